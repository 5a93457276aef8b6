// balance.energy: the power of gravity, the losses in contacts and at walls, and what is stored.
#include <fmt/format.h>

#include <algorithm>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

std::vector<double> ratio(const std::vector<double>& a, const std::vector<double>& b) {
  return per_replica(a.size(), [&](std::size_t r) { return a[r] / b[r]; });
}

std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b) {
  return per_replica(a.size(), [&](std::size_t r) { return a[r] + b[r]; });
}

}  // namespace

Evidence estimate_energy_balance(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  Series pairs{.label = "pair contacts"}, walls{.label = "walls"}, both{.label = "both"};
  double largest = 0;
  for (const SceneValues& scene : by_area_fraction(records)) {
    const double nu = scene.scene().area_fraction();
    const std::vector<double> power = scene.of("gravity_power");
    const std::vector<double> pair_share = ratio(scene.of("pair_loss"), power),
                              wall_share = ratio(sum(scene.of("wall_loss_lower"), scene.of("wall_loss_upper")), power);
    std::vector<double> loss = sum(pair_share, wall_share);
    add_point(pairs, nu, pair_share);
    add_point(walls, nu, wall_share);
    add_point(both, nu, loss);
    for (double& l : loss) l -= 1;
    evidence.checks.push_back({.label = fmt::format("{}: losses over the power of gravity, less 1", scene.name()),
                               .values = std::move(loss),
                               .band = band_about(0, claim.tolerance_total()),
                               .x = nu});
    std::vector<double> flow = ratio(scene.of("mean_flow"), power);
    for (double& f : flow) f = f * scene.scene().particles * scene.scene().gravity - 1;
    evidence.checks.push_back({.label = fmt::format("{}: N g <u_x> over the power of gravity, less 1", scene.name()),
                               .values = std::move(flow),
                               .band = band_about(0, claim.tolerance_total()),
                               .x = nu});
    const std::vector<double> residual = ratio(scene.of("energy_residual"), power);
    evidence.checks.push_back(
        {.label = fmt::format("{}: power of gravity less losses and energy gained, over that power", scene.name()),
         .values = residual,
         .band = band_about(0, claim.parameter("round_off")),
         .exact = true,
         .x = nu});
    for (const double value : residual) largest = std::max(largest, std::abs(value));
    evidence.notes.push_back(fmt::format("{}: {:.1f} % of the power is lost in pair contacts, {:.1f} % at the walls.",
                                         scene.name(), 100 * over_replicas(pair_share).mean,
                                         100 * over_replicas(wall_share).mean));
  }
  evidence.plot = {.title = "Where the work of gravity goes",
                   .xlabel = "mean area fraction",
                   .ylabel = "share of the power of gravity",
                   .series = {{.label = "band of the sum",
                               .style = SeriesStyle::band,
                               .x = {0, 0.6},
                               .y = {1, 1},
                               .lower = std::vector<double>(2, 1 - claim.tolerance_total()),
                               .upper = std::vector<double>(2, 1 + claim.tolerance_total())},
                              pairs,
                              walls,
                              both}};
  evidence.notes.push_back(fmt::format(
      "The power is the work done during the flights, the integral of g P_x; <u_x> is sampled. With the energy stored "
      "counted in, the balance closes to {:.1e} in every run: nothing is lost between the events.",
      largest));
  return evidence;
}

}  // namespace gpf
