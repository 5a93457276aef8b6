// Records of a channel with given Knudsen number, velocities and temperatures, for claims about scans.
#pragma once

#include <string>
#include <vector>

#include "unit/verify/estimators/made_record.hpp"

namespace gpf::test {

/// What a run of six bins measured. U and T from the wall to the centre, both halves alike.
struct WallRun {
  double area_fraction = 0.1, restitution = 0.99, wall = 0.1;
  int particles = 180;
  double knudsen = 0.1;
  std::vector<double> velocity{1, 2, 4}, temperature{1, 1, 1};
};

inline Record record_of(const WallRun& run) {
  const std::string text = "[scene]\ngeometry = \"channel\"\nparticles = " + std::to_string(run.particles) +
                           "\nwidth_over_diameter = 12\narea_fraction = " + std::to_string(run.area_fraction) +
                           "\nnormal_restitution = " + std::to_string(run.restitution) +
                           "\nwall_tangential_restitution = " + std::to_string(run.wall) +
                           "\n[run]\nstart_up = 2\nduration = 8\nbins = 6\n";
  return made_record(text, [&](const SetTally& set) {
    set(Tally::free_paths, 0, 10);
    set(Tally::free_path, 0, 10 * run.knudsen);
    set(Tally::pair_contacts, 0, run.particles / 2.0);  // one contact of each disk per time: Kn = speed
    set(Tally::peculiar_speed, 0, run.particles * run.knudsen);
    set(Tally::speed, 0, run.particles * run.knudsen);
    set(Tally::momentum, 0, run.particles * run.velocity[2]);
    for (int b = 0; b < 6; ++b) {
      const auto from_wall = static_cast<std::size_t>(b < 3 ? b : 5 - b);
      set(Tally::count, b, 30);
      set(Tally::freedom, b, 30);
      set(Tally::cx, b, 30 * run.velocity[from_wall]);
      set(Tally::ux2, b, 30 * run.temperature[from_wall]);
      set(Tally::cy2, b, 30 * run.temperature[from_wall]);
    }
  });
}

/// Two equal replicas.
inline void add(SceneRecords& records, const WallRun& run) {
  records["scene " + std::to_string(records.size())] = {record_of(run), record_of(run)};
}

}  // namespace gpf::test
