// One contact, as those who watch a simulation are told of it.
#pragma once

#include <cstdint>

#include "gpf/base/vec2.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// A pair contact, after it has been resolved. Positions and velocities are in the laboratory frame.
struct PairContact {
  double time;                  ///< since the start of the run
  std::int32_t first, second;   ///< first < second
  Vec2 position;                ///< of the first disk's centre, x in some period
  Vec2 r_12;                    ///< from the first to the second centre
  Vec2 velocity_1, velocity_2;  ///< after the contact
  Vec2 impulse;                 ///< that the second disk received; the first received the opposite
  double energy_loss;           ///< kinetic energy lost
};

/// A wall contact, after it has been resolved.
struct WallContact {
  double time;
  std::int32_t disk;
  Wall wall;
  Vec2 position;
  Vec2 velocity_before, velocity_after;
};

}  // namespace gpf
