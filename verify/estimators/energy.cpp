// algo.energy: what elastic contacts and gravity conserve, they conserve to round-off.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/measure/tallies.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// start_state scales the velocities to this, to round-off, and takes their mean off.
double start_energy(const Scene& scene) { return scene.particles * square(scene.velocity_scale()); }
double momentum_scale(const Scene& scene) { return scene.particles * scene.velocity_scale(); }

Check exact_check(std::string label, const std::vector<Record>& records, Interval band,
                  double (*value)(const Record&)) {
  return {.label = std::move(label),
          .values = per_replica(records.size(), [&](std::size_t r) { return value(records[r]); }),
          .band = band,
          .exact = true};
}

double energy_drift(const Record& r) { return kinetic_energy(r.final_state) / start_energy(r.scene) - 1; }
double momentum_drift(const Record& r) {
  const Vec2 p = momentum(r.final_state);
  return std::sqrt(dot(p, p)) / momentum_scale(r.scene);
}
double collisions(const Record& r) { return static_cast<double>(r.counts.pair_contacts); }

/// Under gravity along +x, between walls that take no tangential momentum, P_x grows as N g t.
double fall_error(const Record& r) {
  const double expected = r.scene.particles * r.scene.gravity * r.time;
  return (momentum(r.final_state).x - expected) / expected;
}

/// Kinetic energy gained over the measured window less the work of gravity, over that work.
double work_error(const Record& r) {
  const TallyLayout layout(r.run);
  const std::vector<double> totals = totals_of(r);
  const double work = totals[layout.at(Tally::gravity_work)];
  return (totals[layout.at(Tally::energy_change)] - work) / work;
}

/// The same over the whole run and from the final state alone. P_x = N g t from zero, so gravity's power is N g^2 t.
double final_energy_error(const Record& r) {
  const double fall = 0.5 * r.scene.particles * square(r.scene.gravity * r.time);
  return (kinetic_energy(r.final_state) - start_energy(r.scene) - fall) / fall;
}

}  // namespace

Evidence estimate_energy(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  const Interval round_off = band_about(0, claim.tolerance_total());
  Series points{.label = "final state of each run"};
  double number = 0;
  for (const auto& [name, replicas] : records) {
    if (replicas.front().scene.gravity == 0) {
      evidence.checks.push_back(exact_check(name + ": energy drift", replicas, round_off, energy_drift));
      evidence.checks.push_back(exact_check(name + ": |momentum| over N times the thermal velocity", replicas,
                                            {0, claim.tolerance_total()}, momentum_drift));
      evidence.checks.push_back(
          exact_check(name + ": pair collisions", replicas, {claim.parameter("collisions"), INFINITY}, collisions));
    } else {
      evidence.checks.push_back(
          exact_check(name + ": kinetic energy less work of gravity, over the work", replicas, round_off, work_error));
      evidence.checks.push_back(
          exact_check(name + ": kinetic energy less N (g t)^2/2, over that", replicas, round_off, final_energy_error));
      evidence.checks.push_back(
          exact_check(name + ": x momentum less N g t, over that", replicas, round_off, fall_error));
    }
    for (const Record& r : replicas) {
      points.x.push_back(++number);
      // No error at all is drawn at the resolution of a double.
      points.y.push_back(std::max(std::abs(r.scene.gravity == 0 ? energy_drift(r) : final_energy_error(r)), 0x1p-53));
    }
  }
  const std::vector<double> ends{0, number + 1};
  evidence.plot = {.title = "Relative error of the energy after the whole run",
                   .xlabel = "run",
                   .ylabel = "size of the relative error",
                   .logy = true,
                   .xrange = {{ends[0], ends[1]}},
                   .yrange = {{1e-17, 10 * round_off.hi}},
                   .series = {{.label = "allowed",
                               .style = SeriesStyle::band,
                               .x = ends,
                               .lower = {1e-17, 1e-17},
                               .upper = {round_off.hi, round_off.hi}},
                              points}};
  evidence.notes = {
      "Start energy and momentum are those that start_state() sets to round-off: N v^2 with v the thermal velocity of "
      "the scene, and zero.",
      "With e_n = e_w = 1 and beta_w = 1 nothing takes momentum along x, so the mean velocity is g t and the work of "
      "gravity N (g t)^2/2, whatever the disks do."};
  return evidence;
}

}  // namespace gpf
