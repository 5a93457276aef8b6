// Audits of a version against itself: how often is something said to have moved when nothing has?
#pragma once

#include <vector>

#include "gpf/io/plot.hpp"
#include "verify/trial/trial_result.hpp"
#include "verify/trial/trial_runs.hpp"

namespace gpf {

inline constexpr int replicas_a_side = 16;

struct AuditTrial {
  std::size_t audits = 0, numbers = 0;
  std::vector<TrialResult> results;
  Plot distribution;  ///< functions of the p-values
};

/// As many audits as the runs allow, each of 2 replicas_a_side replicas of every scene that no other audit reads:
/// replicas 32 k ... 32 k + 15 are the version before, the next 16 the version after.
AuditTrial try_audits(const TrialRuns& runs);

}  // namespace gpf
