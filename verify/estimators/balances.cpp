#include "verify/estimators/balances.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gpf {
Balances balances_of(const Scene& scene, const Measurement& measurement, const State& start, const State& end) {
  const std::vector<double> totals = block_totals(measurement.series().sums(), measurement.series().tallies());
  const auto total = [&](Tally tally, int k = 0) { return totals[measurement.layout().at(tally, k)]; };

  Balances b;
  const double work = total(Tally::gravity_work);
  const double losses = total(Tally::pair_loss) + total(Tally::wall_loss, lower) + total(Tally::wall_loss, upper);
  b.energy = (work - losses - total(Tally::energy_change)) / std::max(std::abs(work), kinetic_energy(start));

  const Vec2 gained = momentum(end) - momentum(start);
  const double given = scene.particles * scene.gravity * total(Tally::measured_time);
  const double taken = total(Tally::wall_tangential, lower) + total(Tally::wall_tangential, upper);
  const double scale = scene.particles * scene.velocity_scale();
  b.momentum_x = (gained.x - given + taken) / std::max(given, scale);
  const double from_below = total(Tally::wall_normal, lower), from_above = total(Tally::wall_normal, upper);
  b.momentum_y = (gained.y - from_below + from_above) / std::max(from_below + from_above, scale);
  return b;
}

}  // namespace gpf
