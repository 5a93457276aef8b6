// algo.temperature: the fluctuation in a bin, about the bin's own mean, is that of all disks.
#include "gpf/measure/tallies.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/ratio_checks.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// <u_x^2> about the instantaneous means of the bins, each with n - 1 degrees of freedom, over that of the N disks of
/// the same samples, with N - 1 for their zero momentum. In equilibrium a disk's velocity knows nothing of its place,
/// so that the mean is one whatever the bins.
double temperature_ratio(const Record& r) {
  const TallyLayout layout(r.run);
  const std::vector<double> totals = totals_of(r);
  double ux2 = 0, freedom = 0, cx2 = 0;
  for (int b = 0; b < r.run.bins; ++b) {
    ux2 += totals[layout.at(Tally::ux2, b)];
    freedom += totals[layout.at(Tally::freedom, b)];
    cx2 += totals[layout.at(Tally::cx2, b)];
  }
  return ux2 / freedom * totals[layout.at(Tally::samples)] * (r.scene.particles - 1) / cx2;
}

}  // namespace

Evidence estimate_bin_temperature(const Claim& claim, Tier, const SceneRecords& records) {
  RatioChecks ratios(claim);
  for (const auto& [name, replicas] : records)
    ratios.add(name + ": <u_x^2> of the bins over that of all disks", replicas, temperature_ratio);
  return ratios.evidence("Fluctuation about the means of the bins, over that about the mean of all disks",
                         "<u_x^2> of the bins over that of all disks");
}

}  // namespace gpf
