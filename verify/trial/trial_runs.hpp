// Small cheap scenes, run with many seeds: what the trials of the audit and of the seeds look at.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpf/scene/scene_file.hpp"

namespace gpf {

/// Channels of 60 disks (two of which differ by their restitution alone, 0.90 and 0.91; a dilute one between rough
/// walls that differ) and a periodic gas. Short runs: what is compared need not be steady, only alike.
std::vector<SceneFile> trial_scenes();

/// What one run measured.
struct TrialRun {
  std::uint64_t trace_hash = 0;
  std::vector<double> values;  ///< in the order of TrialRuns::labels of its scene
};

struct TrialRuns {
  std::vector<std::vector<std::string>> labels;  ///< by scene: "granular_temperature, bin 2"
  std::vector<std::vector<TrialRun>> runs;       ///< by scene and replica
};

/// Replicas 0 ... replicas - 1 of every scene, seeded as the suite seeds them (replica_of), through the engine and the
/// measurement that records are made by; on all cores.
TrialRuns run_trial_scenes(int replicas);

}  // namespace gpf
