// Records on disk, one file per run, found by what was run: nothing is computed twice.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "gpf/io/record.hpp"
#include "gpf/scene/scene_file.hpp"
#include "verify/claim.hpp"

namespace gpf {

/// The scene file with the seed of replica `replica` (from 0): the upper 63 bits (TOML has no more) of
/// replica_seed(scene_hash, replica); with a release seed other than 0 the scene hash is mixed with it first, so that
/// each release draws fresh replicas.
SceneFile replica_of(const SceneFile& file, int replica, std::uint64_t release_seed);

/// Which records of the right physics version are used. `same_sources` wants those that this program's own source text
/// made (simulation_sources.hpp): a change that should have raised the physics version and did not is then noticed.
enum class Trust { same_version, same_sources };

/// Runs of the quick tier are soon repeated, those of the others are not.
constexpr Trust trust_in(Tier tier) { return tier == Tier::quick ? Trust::same_sources : Trust::same_version; }

/// A folder of <record_name>.h5. A file there is used only if it is complete, was made with this physics version - by
/// the same sources, where that is asked for - and is the record of exactly the scene and run that are wanted.
class RecordStore {
 public:
  /// `report` is told, in one line, of each file that is not used and why; of records made by other sources only once.
  /// Creates the folder. Throws StorageError.
  RecordStore(std::filesystem::path folder, Trust trust, std::function<void(const std::string&)> report = {});

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Where the record of this run is, or will be.
  [[nodiscard]] std::filesystem::path path(const SceneFile& file) const;
  /// The record; nothing when there is none that can be used: run the scene again and save().
  [[nodiscard]] std::optional<Record> load(const SceneFile& file) const;
  /// Writes the record of `file` atomically, over whatever is there, with simulation_sources() in its session.
  /// Throws StorageError.
  void save(const SceneFile& file, const Record& record) const;

 private:
  [[nodiscard]] std::string why_not(const Record& record, const SceneFile& file) const;

  std::filesystem::path folder_;
  Trust trust_;
  std::function<void(const std::string&)> report_;
  mutable bool other_sources_reported_ = false;
};

}  // namespace gpf
