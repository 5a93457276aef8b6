// Positions and velocities of all disks at one time.
#pragma once

#include <vector>

#include "gpf/base/vec2.hpp"

namespace gpf {

/// Laboratory frame. position[i] and velocity[i] belong to disk i; x in [0, L), y in [0, W).
struct State {
  std::vector<Vec2> position, velocity;
};

/// Of all disks, of unit mass.
inline Vec2 momentum(const State& state) {
  Vec2 sum;
  for (const Vec2 c : state.velocity) sum = sum + c;
  return sum;
}
inline double kinetic_energy(const State& state) {
  double sum = 0;
  for (const Vec2 c : state.velocity) sum += 0.5 * dot(c, c);
  return sum;
}

/// What a run keeps of itself on the way.
struct Snapshot {
  double time;
  State state;
};

}  // namespace gpf
