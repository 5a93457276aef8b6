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

struct NamedScene {
  std::string name;
  SceneFile file;
  bool of_campaign = false;
};

/// Its replica in that release. A point of a campaign has those that `gpf campaign` makes, whatever the release: they
/// are too dear to be made anew for each, and serve both.
inline SceneFile replica_of(const NamedScene& scene, int replica, std::uint64_t release_seed) {
  return replica_of(scene.file, replica, scene.of_campaign ? 0 : release_seed);
}

/// What the names in a claim's [scenes] stand for, each file read once, when it is first asked for.
class SceneLibrary {
 public:
  explicit SceneLibrary(std::filesystem::path reference) : reference_(std::move(reference)) {}

  /// <reference>/scenes/<name>.toml, or where there is a <reference>/campaigns/<name>.toml its points, each named
  /// "<name>: <label of the point>". Throws StorageError, InputError.
  const std::vector<NamedScene>& of(const std::string& name);
  /// How many those are; a scene file is not read for it.
  std::size_t count(const std::string& name) { return is_campaign(name) ? of(name).size() : 1; }
  [[nodiscard]] bool is_campaign(const std::string& name) const {
    return std::filesystem::exists(reference_ / "campaigns" / (name + ".toml"));
  }

 private:
  std::filesystem::path reference_;
  std::map<std::string, std::vector<NamedScene>> scenes_;
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
