// Records on disk, one file per run, found by what was run: nothing is computed twice.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "gpf/io/record.hpp"
#include "gpf/scene/scene_file.hpp"

namespace gpf {

/// The scene file with the seed of replica `replica` (from 0): the upper 63 bits (TOML has no more) of
/// replica_seed(scene_hash, replica); with a release seed other than 0 the scene hash is mixed with it first, so that
/// each release draws fresh replicas.
SceneFile replica_of(const SceneFile& file, int replica, std::uint64_t release_seed);

/// A folder of <record_name>.h5. A file there is used only if it is complete, was made with this physics version and
/// is the record of exactly the scene and run asked for.
class RecordStore {
 public:
  /// `report` is told, in one line, of each file that is not used and why. Creates the folder. Throws StorageError.
  explicit RecordStore(std::filesystem::path folder, std::function<void(const std::string&)> report = {});

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Where the record of this run is, or will be.
  [[nodiscard]] std::filesystem::path path(const SceneFile& file) const;
  /// The record; nothing when there is none that can be used: run the scene again and save().
  [[nodiscard]] std::optional<Record> load(const SceneFile& file) const;
  /// Writes the record of `file` atomically, over whatever is there. Throws StorageError.
  void save(const SceneFile& file, const Record& record) const;

 private:
  std::filesystem::path folder_;
  std::function<void(const std::string&)> report_;
};

}  // namespace gpf
