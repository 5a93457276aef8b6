// The frames that are shown: states at equal intervals, simulated anew.
#pragma once

#include <csignal>
#include <cstdint>
#include <functional>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

struct FramePlan {
  int count = 240;
  double interval = 0;                               ///< between two frames
  const volatile std::sig_atomic_t* stop = nullptr;  ///< set: stop
};

/// The power of two next below W/(32 v), v the root mean square velocity of a state: from frame to frame a disk moves
/// by about its diameter at W/d = 31, and less than that is seen as motion. A power of two adds up without round-off.
double default_interval(const State& state);

/// Runs the engine from `start` and shows the state at start.time + k interval for k = 0 ... count - 1, and how many
/// have been shown. Returns the trace hash of what happened between. The contact memory of disks (TC model) begins
/// empty, so that after a record's last state the trajectory is one of the scene's, not the one that a longer run would
/// have taken.
/// Throws what the engine throws, and Error with ExitStatus::interrupted when it was stopped.
std::uint64_t run_frames(const Scene& scene, const Snapshot& start, const FramePlan& plan,
                         const std::function<void(const Snapshot&)>& show);

}  // namespace gpf
