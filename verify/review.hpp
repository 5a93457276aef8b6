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

/// Reads the claim's records for look `look` (from 1) out of the store, lets its estimator make evidence of them, adds
/// the health checks that hold for every record, and judges. Throws InputError when a record is missing or the
/// estimator cannot use them.
Verdict review(const Claim& claim, Tier tier, int look, SceneLibrary& scenes, const RecordStore& store,
               std::uint64_t release_seed, const EstimatorLookup& estimators = estimator_named);

}  // namespace gpf
