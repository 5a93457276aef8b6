// Refuses states from which the engine cannot start: of another scene, not finite, outside the box, overlapping.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"
#include "gpf/event/engine_state.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf::detail {

/// Overlap that round-off can explain, a length: 2^-46 of the longest side, a few hundred ulp of a coordinate.
inline double deepest_round_off(const Scene& scene) { return std::max(scene.length(), 1.0) * 0x1p-46; }

inline std::string describe(const EngineState& state, std::size_t i) {
  return fmt::format("disk {}: x {:.17g} y {:.17g} vx {:.17g} vy {:.17g}", i, state.x[i], state.y[i], state.vx[i],
                     state.vy[i]);
}

/// Throws InputError if a period is shorter than the three cells, each wider than a disk, which the engine needs.
inline void require_room(const Scene& scene) {
  const double period = scene.geometry == Geometry::channel ? scene.length() : std::min(scene.length(), 1.0);
  if (!(period > 3.001 * scene.diameter()))
    throw InputError(fmt::format("a period is {:.4g} diameters", period / scene.diameter()),
                     "with three or less a disk may touch another in two places", "use a longer or wider scene");
}

/// Throws InputError unless each disk of the scene has finite numbers and a place in the box, give or take round-off.
inline void require_inside(const Scene& scene, const EngineState& state) {
  const auto count = static_cast<std::size_t>(scene.particles);
  for (const auto* values : {&state.x, &state.y, &state.vx, &state.vy, &state.last_contact})
    if (values->size() != count)
      throw InputError(fmt::format("the state has {} disks, the scene {}", values->size(), count),
                       "they belong to different scenes", "start from a state of this scene");
  const double slack = deepest_round_off(scene);
  const double wall = scene.geometry == Geometry::channel ? scene.diameter() / 2 : 0;
  const auto inside = [slack](double a, double low, double high) { return a >= low - slack && a <= high + slack; };
  for (std::size_t i = 0; i < count; ++i)
    if (!inside(state.x[i], 0, scene.length()) || !inside(state.y[i], wall, 1 - wall) || !std::isfinite(state.vx[i]) ||
        !std::isfinite(state.vy[i]))
      throw InputError(fmt::format("the state has a disk that is not in the box ({})", describe(state, i)),
                       fmt::format("x must be in [0, {:.17g}], y in [{:.17g}, {:.17g}], velocities finite",
                                   scene.length(), wall, 1 - wall),
                       "check how the state was made");
}

/// Throws PhysicsError if disks i and j overlap by more than round-off.
inline void require_apart(const Scene& scene, const EngineState& state, std::size_t i, std::size_t j) {
  double x = state.x[j] - state.x[i], y = state.y[j] - state.y[i];
  x -= scene.length() * std::round(x / scene.length());
  if (scene.geometry == Geometry::periodic) y -= std::round(y);
  const double distance = std::sqrt(x * x + y * y);
  if (distance < scene.diameter() - deepest_round_off(scene))
    throw PhysicsError(fmt::format("two disks overlap by {:.3g} d ({}; {})", 1 - distance / scene.diameter(),
                                   describe(state, i), describe(state, j)),
                       "deeper than round-off explains", "check how the state was made");
}

/// Throws PhysicsError if any two disks overlap by more than round-off. For a state that is inside.
inline void require_apart(const Scene& scene, const EngineState& state) {
  // Disks in square bins no narrower than one: the first of each bin, and the next after each disk.
  const double side = std::max(scene.diameter(), std::sqrt(scene.length() / scene.particles));
  const auto columns = std::max(1, static_cast<int>(scene.length() / side)),
             rows = std::max(1, static_cast<int>(1 / side));
  const auto bin = [](double fraction, int bins) { return std::clamp(static_cast<int>(fraction * bins), 0, bins - 1); };
  const auto number = [=](int column, int row) {
    return static_cast<std::size_t>((row + rows) % rows) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>((column + columns) % columns);
  };
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(number(columns - 1, rows - 1) + 1, none), next(state.x.size(), none);
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    const int column = bin(state.x[i] / scene.length(), columns), row = bin(state.y[i], rows);
    for (int r = row - 1; r <= row + 1; ++r)
      for (int c = column - 1; c <= column + 1; ++c)
        for (std::size_t j = first[number(c, r)]; j != none; j = next[j]) require_apart(scene, state, j, i);
    next[i] = std::exchange(first[number(column, row)], i);
  }
}

}  // namespace gpf::detail
