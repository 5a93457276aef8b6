// The scenes on which the engine's speed is measured: the same work for everybody.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/start.hpp"

namespace gpf::performance {

/// Elastic periodic disks in a square.
inline Scene periodic(std::int32_t particles, double area_fraction) {
  Scene scene;
  scene.geometry = Geometry::periodic;
  scene.particles = particles;
  scene.length_over_width = 1;
  scene.width_over_diameter = std::sqrt(std::numbers::pi * particles / (4 * area_fraction));
  return scene;
}

/// All disks of a periodic scene close together in a square of side 1.2 d N^(1/2), with the velocities of its start.
inline State clump(const Scene& scene) {
  State state = start_state(scene);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(scene.particles)));
  for (std::size_t i = 0; i < state.position.size(); ++i)
    state.position[i] = {1.2 * scene.diameter() * static_cast<double>(i % side),
                         1.2 * scene.diameter() * static_cast<double>(i / side)};
  return state;
}

/// N = 900, W/d = 31, beta_w = 0.9, g = 1 and the default TC time.
inline Scene channel(double area_fraction, double normal_restitution) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = 900;
  scene.width_over_diameter = 31;
  scene.length_over_width = std::numbers::pi * 900 / (4 * area_fraction * 31 * 31);
  scene.normal_restitution = normal_restitution;
  scene.wall_tangential_restitution = {0.9, 0.9};
  scene.gravity = 1;
  scene.tc_time = 1e-4 / scene.reference_collision_rate();
  return scene;
}

}  // namespace gpf::performance
