// Seeds: are replicas independent, and are no two runs the same?
#pragma once

#include <cstddef>
#include <vector>

#include "verify/trial/trial_result.hpp"
#include "verify/trial/trial_runs.hpp"

namespace gpf {

/// Repeats among `seeds` seeds (of 1000 scenes that differ by their restitution, in steps of 1e-4 to 1e-7)
/// and among the trace hashes of the runs; correlations of start velocities in `pairs` pairs of replicas; correlations
/// of what the runs measured, between replicas and between scenes.
std::vector<TrialResult> try_seeds(const TrialRuns& runs, std::size_t seeds, std::size_t pairs);

}  // namespace gpf
