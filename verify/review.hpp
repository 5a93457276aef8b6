// One claim at one look: records in, verdict out.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "verify/judge.hpp"
#include "verify/planner.hpp"

namespace gpf {

/// estimator_named(), or what stands in for it in tests.
using EstimatorLookup = std::function<Estimator(std::string_view)>;

/// One of the times that a claim is looked at.
struct Look {
  int number = 1, of = 1;  ///< from 1; of so many that its cap allows
  int replicas = 1;
};

/// Reads the claim's records for this look out of the store, lets its estimator make evidence of them, adds
/// the health checks that hold for every record, and judges. Throws InputError when a record is missing or the
/// estimator cannot use them.
Verdict review(const Claim& claim, Tier tier, const Look& look, SceneLibrary& scenes, const RecordStore& store,
               std::uint64_t release_seed, const EstimatorLookup& estimators = estimator_named);

}  // namespace gpf
