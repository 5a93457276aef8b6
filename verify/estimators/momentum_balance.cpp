// balance.momentum: weight, wall forces and stresses of a steady channel balance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gpf/measure/bins.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// Mean height of the disks within bin b, in bin widths, 1/2 where it is not known better: from a density that is
/// linear over the neighbours. Next to a wall layers make that wrong (by 1 % of the weight at nu .56), so there the
/// disks of the last state are taken.
double height_in_bin(const Record& record, const std::vector<double>& share, int b) {
  const int bins = record.run.bins;
  const auto k = static_cast<std::size_t>(b);
  if (b > 0 && b < bins - 1) return 0.5 + (share[k] > 0 ? (share[k + 1] - share[k - 1]) / (24 * share[k]) : 0);
  double sum = 0, count = 0;
  for (const Vec2 r : record.final_state.position)
    if (Bins(bins).at(r.y) == b) sum += r.y * bins - b, count += 1;
  return count > 0 ? sum / count : 0.5;
}

/// P_xy of each bin as the weight of the disks demands: the flux of x momentum along +y grows by g for each disk
/// passed. In units of the weight per length that one wall carries, up to a constant that the mirror average takes off.
std::vector<double> demanded_shear(const SceneValues& scene, std::size_t replica) {
  const Record& record = scene.records()[replica];
  std::vector<double> share;  // of the disks, in each bin
  double sum = 0;
  for (int b = 0; b < scene.bins(); ++b) {
    share.push_back(scene.of("area_fraction", b)[replica]);
    sum += share.back();
  }
  for (double& s : share) s /= sum;
  std::vector<double> shear;
  double below = 0;
  for (int b = 0; b < scene.bins(); ++b) {
    const double here = share[static_cast<std::size_t>(b)];
    shear.push_back(2 * (below + here * (1 - height_in_bin(record, share, b))));
    below += here;
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
                               .band = band_about(0, claim.parameter("shear_margin")),
                               .x = scene.centre(bin)});
  }
  std::vector<double> mean(scene.replicas(), 0.0);
  for (int bin = 0; bin < scene.bins(); ++bin) {
    const std::vector<double> shear = scene.of("pressure_xy", bin);
    for (std::size_t r = 0; r < mean.size(); ++r) mean[r] += shear[r] / (weight * scene.bins());
  }
  evidence.checks.push_back({.label = fmt::format("{}: mean of P_xy, zero by symmetry, over weight/2", scene.name()),
                             .values = std::move(mean),
                             .band = band_about(0, claim.parameter("shear_margin"))});
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
    evidence.notes.emplace_back(
        fmt::format("{}: wall pressure {:.4g}, wall shear stress {:.4g} (nu/2 = {:.4g}) in rho_p g W.", scene.name(),
                    over_replicas(wall_mean(scene, "wall_pressure")).mean / unit,
                    over_replicas(wall_mean(scene, "wall_shear")).mean / unit, scene.scene().area_fraction() / 2));
  }
  evidence.notes.emplace_back(
      "Stress: kinetic part about the bin's mean, collisional part shared along the line of contact over the bins that "
      "it crosses, the wall's contact line included. The bins y and W - y are averaged.");
  return evidence;
}

}  // namespace gpf
