// Records without physics: what a run would have measured, drawn at random.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <string>

#include "gpf/event/physics_version.hpp"
#include "gpf/io/record.hpp"
#include "gpf/measure/tallies.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"

namespace gpf::test {

inline const std::string periodic_scene = R"([scene]
geometry = "periodic"
particles = 36
area_fraction = 0.2
length_over_width = 1
normal_restitution = 1
[run]
start_up = 0
duration = 8
bins = 2
)";

inline const std::string channel_scene = R"([scene]
geometry = "channel"
particles = 36
area_fraction = 0.2
width_over_diameter = 12
normal_restitution = 0.9
wall_tangential_restitution = 0.5
[run]
start_up = 0
duration = 8
bins = 2
)";

/// Value of a main field in block `block` of `blocks`; `noise` is a standard normal number of its own.
using Course = std::function<double(std::size_t block, std::size_t blocks, double noise)>;

inline double steady(std::size_t, std::size_t, double noise) { return 10 + noise; }

/// A record of `file` with independent noise from its seed. Energy balances and nothing overlaps.
inline Record fake_record(const SceneFile& file, std::size_t blocks = 64, const Course& course = steady) {
  Record r;
  r.scene_text = file.text;
  r.scene = file.scene;
  r.run = file.run;
  r.physics_version = physics_version;
  r.trace_hash = file.scene.seed;
  r.counts.pair_contacts = 1000;
  r.final_state = start_state(file.scene);
  r.build = r.session = "{}";
  r.wall_seconds = r.cpu_seconds = 0.25;
  r.blocks = blocks;
  const TallyLayout layout(file.run);
  r.sums.assign(blocks * layout.size(), 0.0);
  std::mt19937_64 generator(file.scene.seed);
  std::normal_distribution<double> normal;
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto row = std::span(r.sums).subspan(b * layout.size(), layout.size());
    const auto set = [&](Tally tally, double value) {
      for (std::size_t k = 0; k < layout.extent(tally); ++k) row[layout.at(tally) + k] = value;
    };
    using enum Tally;
    for (const Tally tally : {measured_time, samples}) set(tally, 1);
    for (const Tally tally : {count, freedom}) set(tally, 18);
    for (const Tally tally : {energy, momentum, virial, pair_contacts, ux2, cy2})
      set(tally, course(b, blocks, normal(generator)));
  }
  return r;
}

}  // namespace gpf::test
