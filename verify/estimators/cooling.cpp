// algo.cooling: a gas that nothing heats loses what the rule of collision says.
#include <cmath>

#include "gpf/measure/tallies.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/ratio_checks.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// Part of a dilute gas' collisions that dissipate though the TC model is at work: 1 - 2.37 omega t_c to first order
/// (scene_file.hpp), here as if contacts were independent.
double dissipating_part(double omega_tc) { return std::exp(-2.37 * omega_tc); }

/// What its temperature has lost in the measured window, over what it should have lost in so many collisions. Two disks
/// of a gas of Gaussian velocities that collide have <u_n^2> = 4 T in two dimensions and lose (1 - e_n^2) u_n^2/4, so
/// that with tau = 2 N_c/N collisions of each disk d ln T = -(1 - e_n^2)/2 d tau.
double loss_ratio(const Record& r) {
  const TallyLayout layout(r.run);
  const std::vector<double> totals = totals_of(r);
  double end = 0;
  for (const Vec2 c : r.final_state.velocity) end += 0.5 * dot(c, c);
  const double begin = end - totals[layout.at(Tally::energy_change)];
  const double collisions = 2 * totals[layout.at(Tally::pair_contacts)] / r.scene.particles;
  const double rate = collisions / totals[layout.at(Tally::measured_time)];
  const double expected =
      0.5 * (1 - square(r.scene.normal_restitution)) * collisions * dissipating_part(rate * r.scene.tc_time);
  return std::log(begin / end) / expected;
}

}  // namespace

Evidence estimate_cooling(const Claim& claim, Tier, const SceneRecords& records) {
  RatioChecks ratios(claim);
  for (const auto& [name, replicas] : records)
    ratios.add(name + ": temperature lost, over that of its collisions", replicas, loss_ratio);
  Evidence evidence = ratios.evidence("Temperature lost by a gas that cools, over what its collisions take",
                                      "ln(T_0/T) over its expectation");
  evidence.notes = {
      "Collisions are counted, not predicted: neither the contact value nor the start on a lattice enters.",
      "omega, for the part of collisions that the TC model makes elastic, is the collision rate of a disk over the "
      "run."};
  return evidence;
}

}  // namespace gpf
