// balance.momentum: weight, wall forces and stresses of a steady channel balance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// P_xy of each bin as the weight of the disks demands: the flux of x momentum along +y grows from -tau at the lower
/// wall by g for each disk passed. A bin's mean lies between its ends, by where in the bin its disks are: with a
/// density that is linear over the neighbours, or between the wall's contact plane and the bin's end. In units of the
/// weight per length of one wall, up to a constant that the mirror average takes off.
std::vector<double> demanded_shear(const SceneValues& scene, std::size_t replica) {
  const int bins = scene.bins();
  const double width = 1.0 / bins, radius = scene.scene().diameter() / 2;
  std::vector<double> share;  // of the disks, in each bin
  double sum = 0;
  for (int b = 0; b < bins; ++b) {
    share.push_back(scene.of("area_fraction", b)[replica]);
    sum += share.back();
  }
  for (double& s : share) s /= sum;
  std::vector<double> shear;
  double below = 0;
  for (int b = 0; b < bins; ++b) {
    const auto k = static_cast<std::size_t>(b);
    double height = 0.5;  // mean height of the disks within the bin, in bin widths
    if (b == 0)
      height = 0.5 * (1 + radius / width);
    else if (b == bins - 1)
      height = 0.5 * (1 - radius / width);
    else if (share[k] > 0)
      height += (share[k + 1] - share[k - 1]) / (24 * share[k]);
    shear.push_back(2 * (below + share[k] * (1 - height)));
    below += share[k];
  }
  return shear;
}

void check_shear(const Claim& claim, const SceneValues& scene, Evidence& evidence) {
  const double weight = scene.scene().particles * scene.scene().gravity / (2 * scene.scene().length());  // on one wall
  std::vector<std::vector<double>> demanded;
  for (std::size_t r = 0; r < scene.replicas(); ++r) demanded.push_back(demanded_shear(scene, r));
  for (int bin = 0; bin < scene.bins() / 2; ++bin) {
    const std::vector<double> shear = scene.mirrored("pressure_xy", bin, Parity::odd);
    const auto near = static_cast<std::size_t>(bin), far = static_cast<std::size_t>(scene.bins() - 1 - bin);
    evidence.checks.push_back({.label = fmt::format("{}: P_xy of bins {} and {} less the weight beyond, over weight/2",
                                                    scene.name(), bin + 1, far + 1),
                               .values = per_replica(scene.replicas(),
                                                     [&](std::size_t r) {
                                                       return shear[r] / weight -
                                                              0.5 * (demanded[r][near] - demanded[r][far]);
                                                     }),
                               .band = band_about(0, claim.tolerance_total()),
                               .x = scene.centre(bin)});
  }
}

std::vector<double> wall_mean(const SceneValues& scene, const std::string& quantity) {
  const std::vector<double> lower = scene.of(quantity + "_lower"), upper = scene.of(quantity + "_upper");
  return per_replica(scene.replicas(), [&](std::size_t r) { return 0.5 * (lower[r] + upper[r]); });
}

void check_pressure(const Claim& claim, const SceneValues& scene, Evidence& evidence) {
  const std::vector<double> wall = wall_mean(scene, "wall_pressure");
  std::vector<double> mean(scene.replicas(), 0.0);
  Series points{.label = scene.name()};
  for (int bin = 0; bin < scene.half(); ++bin) {
    std::vector<double> values = scene.mirrored("pressure_yy", bin);
    for (std::size_t r = 0; r < values.size(); ++r) values[r] = values[r] / wall[r] - 1;
    add_point(points, scene.centre(bin), values);
    evidence.checks.push_back({.label = fmt::format("{}: P_yy of bins {} and {} over the wall pressure, less 1",
                                                    scene.name(), bin + 1, scene.bins() - bin),
                               .values = std::move(values),
                               .band = band_about(0, claim.tolerance_total()),
                               .x = scene.centre(bin)});
  }
  for (int bin = 0; bin < scene.bins(); ++bin) {
    const std::vector<double> pressure = scene.of("pressure_yy", bin);
    for (std::size_t r = 0; r < mean.size(); ++r) mean[r] += pressure[r] / (wall[r] * scene.bins());
  }
  for (double& m : mean) m -= 1;
  evidence.checks.push_back(
      {.label = fmt::format("{}: mean P_yy over the wall pressure, less 1 (y virial)", scene.name()),
       .values = std::move(mean),
       .band = band_about(0, claim.parameter("whole_channel_margin"))});
  evidence.plot.series.push_back(std::move(points));
}

void check_walls(const Claim& claim, const SceneValues& scene, Evidence& evidence) {
  const Interval band = band_about(0, claim.parameter("whole_channel_margin"));
  const double weight = scene.scene().particles * scene.scene().gravity / scene.scene().length();
  std::vector<double> friction = wall_mean(scene, "wall_shear");
  for (double& f : friction) f = 2 * f / weight - 1;
  evidence.checks.push_back({.label = fmt::format("{}: friction of both walls over the weight, less 1", scene.name()),
                             .values = std::move(friction),
                             .band = band});
  const std::vector<double> lower = scene.of("wall_pressure_lower"), upper = scene.of("wall_pressure_upper");
  evidence.checks.push_back(
      {.label = fmt::format("{}: pressures of the walls, difference over mean", scene.name()),
       .values = per_replica(scene.replicas(),
                             [&](std::size_t r) { return 2 * (upper[r] - lower[r]) / (upper[r] + lower[r]); }),
       .band = band});
}

}  // namespace

Evidence estimate_momentum_balance(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = {.title = "P_yy over the wall pressure",
                   .xlabel = "y/W",
                   .ylabel = "P_yy/p_w - 1",
                   .xrange = {{0, 0.5}},
                   .series = {{.label = "band",
                               .style = SeriesStyle::band,
                               .x = {0, 0.5},
                               .y = {0, 0},
                               .lower = std::vector<double>(2, -claim.tolerance_total()),
                               .upper = std::vector<double>(2, claim.tolerance_total())}}};
  for (const SceneValues& scene : by_area_fraction(records)) {
    check_walls(claim, scene, evidence);
    check_pressure(claim, scene, evidence);
    check_shear(claim, scene, evidence);
    const double unit = 4 / (std::numbers::pi * square(scene.scene().diameter()));  // rho_p g W for m = g = W = 1
    evidence.notes.push_back(
        fmt::format("{}: wall pressure {:.4g}, wall shear stress {:.4g} (nu/2 = {:.4g}) in rho_p g W.", scene.name(),
                    over_replicas(wall_mean(scene, "wall_pressure")).mean / unit,
                    over_replicas(wall_mean(scene, "wall_shear")).mean / unit, scene.scene().area_fraction() / 2));
  }
  evidence.notes.push_back(
      "Stress: kinetic part about the bin's mean, collisional part shared along the line of contact over the bins that "
      "it crosses, the wall's contact line included. The bins y and W - y are averaged.");
  return evidence;
}

}  // namespace gpf
