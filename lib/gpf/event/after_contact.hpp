// Where two disks fly after a contact that has not happened yet: a guess, for memory to be fetched by.
#pragma once

#include <array>

#include "gpf/base/vec2.hpp"
#include "gpf/event/disk.hpp"

namespace gpf {

/// The flights of two disks that touch at `time`, from then on: eqs. 2.3-2.5 for elastic disks, without the engine's
/// rounding of positions, and wrong when they touch round a period. Of one disk twice: it flies on.
inline std::array<Flight, 2> after_contact(const Flight& a, const Flight& b, double time, double diameter) {
  const auto straight_on = [time](const Flight& f) {
    return Flight{f.x + f.vx * (time - f.time), f.y + f.vy * (time - f.time), f.vx, f.vy, time};
  };
  Flight then_a = straight_on(a), then_b = straight_on(b);
  const Vec2 r_12{then_b.x - then_a.x, then_b.y - then_a.y};
  const Vec2 impulse = dot({a.vx - b.vx, a.vy - b.vy}, r_12) / (diameter * diameter) * r_12;
  then_a.vx -= impulse.x, then_a.vy -= impulse.y;
  then_b.vx += impulse.x, then_b.vy += impulse.y;
  return {then_a, then_b};
}

}  // namespace gpf
