// The size of a scene: particles, area fraction, W/d and L/W, of which any three fix the fourth.
#pragma once

#include <cstdint>

#include "gpf/scene/key_values.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

struct SceneSize {
  std::int32_t particles = 0;
  double width_over_diameter = 0, length_over_width = 0;
};

/// Solves nu = pi N/(4 (L/W) (W/d)^2) (eq. 2.7 as it must read) for the one that is not given. A particle number that
/// follows is rounded to the nearest integer, W/d and L/W are kept and the area fraction becomes that of the rounded N.
/// Throws InputError when fewer than three are given, when four contradict each other by more than the rounding of N,
/// and when the result leaves the keys' ranges or makes a period shorter than shortest_period or longer than
/// longest_side diameters.
[[nodiscard]] SceneSize resolve_size(const KeyValues& values, Geometry geometry);

}  // namespace gpf
