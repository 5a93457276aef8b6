#include "verify/planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace gpf {

const SceneFile& SceneLibrary::at(const std::string& name) {
  const auto found = scenes_.find(name);
  if (found != scenes_.end()) return found->second;
  return scenes_.emplace(name, load_scene(folder_ / (name + ".toml"))).first->second;
}

void add_demand(Demand& demand, const Claim& claim, Tier tier, int replicas) {
  for (const std::string& scene : claim.scenes_in(tier)) {
    int& wanted = demand[scene];
    wanted = std::max(wanted, replicas);
  }
}

std::vector<RunJob> missing_runs(const Demand& demand, SceneLibrary& scenes, const RecordStore& store,
                                 std::uint64_t release_seed) {
  std::vector<RunJob> jobs;
  std::set<std::filesystem::path> planned;
  for (const auto& [scene, replicas] : demand)
    for (int replica = 0; replica < replicas; ++replica) {
      RunJob job{replica_of(scenes.at(scene), replica, release_seed), fmt::format("{} #{}", scene, replica + 1)};
      if (planned.insert(store.path(job.file)).second && !store.load(job.file)) jobs.push_back(std::move(job));
    }
  std::stable_sort(jobs.begin(), jobs.end(), [](const RunJob& a, const RunJob& b) {
    return expected_collisions(a.file) > expected_collisions(b.file);
  });
  return jobs;
}

}  // namespace gpf
