// Which runs a set of claims needs, and which of them are missing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/scene/scene_file.hpp"
#include "verify/claim.hpp"
#include "verify/run_pool.hpp"
#include "verify/store.hpp"

namespace gpf {

/// The scene files of a folder, each read once, when it is first asked for.
class SceneLibrary {
 public:
  explicit SceneLibrary(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// <folder>/<name>.toml. Throws StorageError, InputError.
  const SceneFile& at(const std::string& name);

 private:
  std::filesystem::path folder_;
  std::map<std::string, SceneFile> scenes_;
};

/// Scene name -> number of replicas. Claims share runs: the larger number counts.
using Demand = std::map<std::string, int>;

/// Adds what a claim reads at a look with so many replicas.
void add_demand(Demand& demand, const Claim& claim, Tier tier, int replicas);

/// The runs of the demand that the store does not hold, those with the most expected collisions first (so that no long
/// run is left alone at the end), labelled "<scene> #<replica>", replicas counted from 1. Runs that two scene files
/// describe alike are done once.
std::vector<RunJob> missing_runs(const Demand& demand, SceneLibrary& scenes, const RecordStore& store,
                                 std::uint64_t release_seed);

}  // namespace gpf
