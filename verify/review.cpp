#include "verify/review.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gpf/base/error.hpp"
#include "verify/health.hpp"

namespace gpf {

Verdict review(const Claim& claim, Tier tier, const Look& look, SceneLibrary& scenes, const RecordStore& store,
               std::uint64_t release_seed, const EstimatorLookup& estimators) {
  SceneRecords records;
  std::vector<std::string> names;
  double cpu_seconds = 0;
  for (const std::string& name : claim.scenes_in(tier))
    for (const NamedScene& scene : scenes.of(name))
      for (int replica = 0; replica < look.replicas; ++replica) {
        const SceneFile file = replica_of(scene, replica, release_seed);
        std::optional<Record> record = store.load(file);
        if (!record)
          throw InputError(fmt::format("claim '{}' cannot be judged", claim.id),
                           fmt::format("the record of {} #{} is missing", scene.name, replica + 1),
                           "see why its run did not end, and validate again");
        names.push_back(record_name(file.scene, file.run));
        cpu_seconds += record->cpu_seconds;
        records[scene.name].push_back(std::move(*record));
      }

  Evidence evidence = estimators(claim.estimator)(claim, tier, records);
  const bool statistical =
      std::any_of(evidence.checks.begin(), evidence.checks.end(), [](const Check& c) { return !c.exact; });
  for (HealthCheck& health : check_records(claim, records, statistical)) evidence.health.push_back(std::move(health));

  Verdict verdict = judge(claim, tier, evidence, look.replicas, look.number, look.of);
  verdict.records = std::move(names);
  verdict.cpu_seconds += cpu_seconds;
  verdict.release_seed = release_seed;
  return verdict;
}

}  // namespace gpf
