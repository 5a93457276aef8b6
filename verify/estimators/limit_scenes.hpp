// The scenes of the claims limits.*: channels and boxes given by what those claims vary.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "gpf/base/vec2.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// A channel under g = 1 with beta_w = .9 at both walls; its length follows from the others.
inline Scene limit_channel(std::int32_t disks, double width_over_diameter, double area_fraction,
                           double normal_restitution) {
  Scene scene;
  scene.particles = disks;
  scene.width_over_diameter = width_over_diameter;
  scene.length_over_width = std::numbers::pi * disks / (4 * area_fraction * square(width_over_diameter));
  scene.normal_restitution = normal_restitution;
  scene.wall_tangential_restitution = {0.9, 0.9};
  scene.gravity = 1;
  return scene;
}

/// A square periodic box without gravity.
inline Scene limit_gas(std::int32_t disks, double area_fraction, double normal_restitution) {
  Scene scene;
  scene.geometry = Geometry::periodic;
  scene.particles = disks;
  scene.length_over_width = 1;
  scene.width_over_diameter = std::sqrt(std::numbers::pi * disks / (4 * area_fraction));
  scene.normal_restitution = normal_restitution;
  return scene;
}

}  // namespace gpf
