// Records whose tallies and correlations are those of given states, so that estimators can be tested on arrangements
// and velocities that are known.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "gpf/base/random.hpp"
#include "gpf/measure/bins.hpp"
#include "gpf/measure/correlations.hpp"
#include "unit/verify/estimators/made_record.hpp"

namespace gpf::test {

/// A uniform random number in [0, 1).
inline double uniform(std::uint64_t stream, std::uint64_t index) { return random_words(5, stream, index)[0] * 0x1p-32; }

/// The record of a run that saw these states, each as often as Correlations needs to count its pairs.
inline Record sampled_record(const std::string& text, const std::vector<State>& states) {
  Record record = made_record(text, [](const SetTally&) {});
  const TallyLayout layout(record.run);
  const Bins bins(record.run.bins);
  Correlations correlations(record.scene, record.run.bins);
  correlations.begin(states.front());
  const auto add = [&](Tally tally, int b, double value) { record.sums[layout.at(tally, b)] += value; };
  for (const State& state : states) {
    const auto size = static_cast<std::size_t>(bins.count());
    std::vector<double> count(size), mean(size), ux(state.position.size());
    const auto at = [&](std::size_t i) { return bins.at(state.position[i].y); };
    for (std::size_t i = 0; i < ux.size(); ++i) {
      count[static_cast<std::size_t>(at(i))] += 1;
      mean[static_cast<std::size_t>(at(i))] += state.velocity[i].x;
    }
    for (std::size_t i = 0; i < ux.size(); ++i) {
      const Vec2 c = state.velocity[i];
      ux[i] = c.x - mean[static_cast<std::size_t>(at(i))] / count[static_cast<std::size_t>(at(i))];
      for (std::size_t k = 0; k < Correlations::stride; ++k) {
        add(Tally::count, at(i), 1);
        add(Tally::cx, at(i), c.x);
        add(Tally::cx2, at(i), c.x * c.x);
        add(Tally::cy, at(i), c.y);
        add(Tally::cy2, at(i), c.y * c.y);
        add(Tally::cxcy, at(i), c.x * c.y);
        add(Tally::ux2, at(i), ux[i] * ux[i]);
      }
    }
    for (std::size_t k = 0; k < Correlations::stride; ++k) correlations.sample(state, ux);
  }
  record.arrays = correlations.arrays();
  record.final_state = states.back();
  return record;
}

/// Uniformly random points where centres may be; `velocity` of the point's place in units of L and W, and its number.
inline State random_state(const Scene& scene, std::uint64_t seed,
                          const std::function<Vec2(Vec2 place, std::size_t disk)>& velocity) {
  State state;
  const double d = scene.geometry == Geometry::channel ? scene.diameter() : 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(scene.particles); ++i) {
    const Vec2 place{uniform(seed, 2 * i), d / 2 + (1 - d) * uniform(seed, 2 * i + 1)};
    state.position.push_back({place.x * scene.length(), place.y});
    state.velocity.push_back(velocity(place, i));
  }
  return state;
}

/// A dilute channel of 18 bins, W/d 31, of that many disks and length in diameters.
inline std::string long_channel(int particles, double length, double normal_restitution = 0.8) {
  return "[scene]\ngeometry = \"channel\"\nparticles = " + std::to_string(particles) +
         "\nwidth_over_diameter = 31\narea_fraction = " +
         std::to_string(std::numbers::pi * particles / (4 * 31 * length)) +
         "\nnormal_restitution = " + std::to_string(normal_restitution) +
         "\nwall_tangential_restitution = 0.9\n[run]\nstart_up = 2\nduration = 8\nsample_interval = 0.03125\n";
}

}  // namespace gpf::test
