#include "verify/planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "gpf/base/error.hpp"
#include "verify/campaign.hpp"

namespace gpf {

const std::vector<NamedScene>& SceneLibrary::of(const std::string& name) {
  const auto found = scenes_.find(name);
  if (found != scenes_.end()) return found->second;
  const std::string file = name + ".toml";
  std::vector<NamedScene> scenes;
  if (is_campaign(name) && std::filesystem::exists(reference_ / "scenes" / file))
    throw InputError(fmt::format("'{}' is a scene and a campaign", name), "a claim's [scenes] could mean either",
                     "rename one of the files");
  if (is_campaign(name))
    for (const CampaignPoint& point : load_campaign(reference_ / "campaigns" / file).points)
      scenes.push_back({name + ": " + point.label, point.scene, true});
  else
    scenes.push_back({name, load_scene(reference_ / "scenes" / file)});
  return scenes_.emplace(name, std::move(scenes)).first->second;
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
  for (const auto& [name, replicas] : demand)
    for (const NamedScene& scene : scenes.of(name))
      for (int replica = 0; replica < replicas; ++replica) {
        RunJob job{replica_of(scene, replica, release_seed), fmt::format("{} #{}", scene.name, replica + 1)};
        if (planned.insert(store.path(job.file)).second && !is_done(store, job.file)) jobs.push_back(std::move(job));
      }
  std::stable_sort(jobs.begin(), jobs.end(), [](const RunJob& a, const RunJob& b) {
    return expected_collisions(a.file) > expected_collisions(b.file);
  });
  return jobs;
}

}  // namespace gpf
