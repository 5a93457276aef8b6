// algo.walls: what each wall takes of a gas that nothing drives.
#include <cmath>
#include <vector>

#include "gpf/measure/tallies.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/ratio_checks.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// Energy lost at a wall over what its contacts should have taken: a disk at a wall with e_w = 1 loses
/// (1 - beta_w^2) c_x^2/2 (eq. 2.9), and disks that arrive have <c_x^2> = T, the kinetic energy per disk, which falls
/// from block to block.
double loss_ratio(const Record& r, Wall wall) {
  const TallyLayout layout(r.run);
  double lost = 0, expected = 0;
  for (std::size_t b = 0; b < r.blocks; ++b) {
    const auto sum = [&](Tally tally, int k = 0) { return r.sums[b * layout.size() + layout.at(tally, k)]; };
    lost += sum(Tally::wall_loss, wall);
    expected += sum(Tally::wall_contacts, wall) * 0.5 * sum(Tally::energy) / (sum(Tally::samples) * r.scene.particles);
  }
  const double beta = r.scene.wall_tangential_restitution[static_cast<std::size_t>(wall)];
  return lost / (expected * (1 - square(beta)));
}

/// Mean of c_x over the whole window, in units of the thermal velocity then.
double drift(const Record& r) {
  const TallyLayout layout(r.run);
  const std::vector<double> sums = totals_of(r);
  const double seen = sums[layout.at(Tally::samples)] * r.scene.particles;
  return sums[layout.at(Tally::momentum)] / seen / std::sqrt(sums[layout.at(Tally::energy)] / seen);
}

}  // namespace

Evidence estimate_wall_losses(const Claim& claim, Tier, const SceneRecords& records) {
  RatioChecks ratios(claim);
  for (const auto& [name, replicas] : records)
    for (const Wall wall : {Wall::lower, Wall::upper})
      ratios.add(name + (wall == Wall::lower ? ": energy lost at the lower" : ": energy lost at the upper") +
                     " wall, over that of its contacts",
                 replicas, [wall](const Record& r) { return loss_ratio(r, wall); });
  Evidence evidence =
      ratios.evidence("Energy lost at each wall, over what its contacts take", "energy lost over its expectation");
  for (const auto& [name, replicas] : records)
    evidence.checks.push_back(
        {.label = name + ": mean c_x over the thermal velocity, of a gas between walls at rest",
         .values = per_replica(replicas.size(), [&](std::size_t k) { return drift(replicas[k]); }),
         .band = band_about(0, claim.parameter("at_rest"))});
  evidence.notes = {"Contacts are counted, not predicted: how often disks reach a wall does not enter."};
  return evidence;
}

}  // namespace gpf
