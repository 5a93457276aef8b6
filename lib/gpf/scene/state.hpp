// Positions and velocities of all disks at one time.
#pragma once

#include <vector>

#include "gpf/base/vec2.hpp"

namespace gpf {

/// Laboratory frame. position[i] and velocity[i] belong to disk i; x in [0, L), y in [0, W).
struct State {
  std::vector<Vec2> position, velocity;
};

/// What a run keeps of itself on the way.
struct Snapshot {
  double time;
  State state;
};

}  // namespace gpf
