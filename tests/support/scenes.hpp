// Small scenes with non-generic parameters (no unit length, gravity or restitution) that several tests share.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "gpf/scene/scene.hpp"

namespace gpf::test {

/// Periodic box with L/W = 1.3; W/d follows from the area fraction.
inline Scene gas(std::int32_t particles, double area_fraction, double normal_restitution = 1, std::uint64_t seed = 1) {
  Scene scene;
  scene.geometry = Geometry::periodic;
  scene.particles = particles;
  scene.length_over_width = 1.3;
  scene.width_over_diameter = std::sqrt(std::numbers::pi * particles / (4 * 1.3 * area_fraction));
  scene.normal_restitution = normal_restitution;
  scene.seed = seed;
  return scene;
}

/// Channel with gravity 1.7, inelastic rough walls that differ, and the TC model at 1e-4 mean free times; L/W follows
/// from the area fraction.
inline Scene channel(std::int32_t particles, double area_fraction, double width_over_diameter,
                     double normal_restitution = 0.9, std::uint64_t seed = 1) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = particles;
  scene.width_over_diameter = width_over_diameter;
  scene.length_over_width =
      std::numbers::pi * particles / (4 * area_fraction * width_over_diameter * width_over_diameter);
  scene.normal_restitution = normal_restitution;
  scene.wall_normal_restitution = 0.95;
  scene.wall_tangential_restitution = {0.9, 0.6};
  scene.gravity = 1.7;
  scene.tc_time = 1e-4 / scene.reference_collision_rate();
  scene.seed = seed;
  return scene;
}

/// The same channel without any loss: work done by gravity stays.
inline Scene smooth_channel(std::int32_t particles, double area_fraction, double width_over_diameter,
                            std::uint64_t seed = 1) {
  Scene scene = channel(particles, area_fraction, width_over_diameter, 1, seed);
  scene.wall_normal_restitution = 1;
  scene.wall_tangential_restitution = {1, 1};
  return scene;
}

/// By what factor `contacts` contacts make a small deviation grow in an elastic gas. Each multiplies that of its two
/// disks by 1 + 2 l/d: the deflection, seen a mean free path l on; l/d = pi/(8 sqrt(2) nu g0), g0 the contact value.
inline double growth(const Scene& gas, double contacts) {
  const double nu = gas.area_fraction(), contact_value = (1 - 7 * nu / 16) / ((1 - nu) * (1 - nu));
  const double mean_free_path = std::numbers::pi / (8 * std::numbers::sqrt2 * nu * contact_value);
  return std::pow(1 + 2 * mean_free_path, 2 * contacts / gas.particles);
}

}  // namespace gpf::test
