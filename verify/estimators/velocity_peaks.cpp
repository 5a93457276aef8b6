// vdf.rough.wall, vdf.rough.hump, vdf.cx.wall: peaks of the velocity distributions next to the walls.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_distribution.hpp"

namespace gpf {
namespace {

/// Peaks of every replica.
std::vector<std::vector<Peak>> peaks_of(const std::vector<VelocityDistribution>& replicas) {
  const double spread = dispersion(replicas);
  std::vector<std::vector<Peak>> peaks;
  for (const VelocityDistribution& d : replicas) peaks.push_back(find_peaks(d, spread));
  return peaks;
}

std::vector<double> counts_of(const std::vector<std::vector<Peak>>& peaks) {
  return per_replica(peaks.size(), [&](std::size_t r) { return static_cast<double>(peaks[r].size()); });
}

/// Position of the highest peak, in sigma from the mean; NaN without a peak.
std::vector<double> positions_of(const std::vector<std::vector<Peak>>& peaks) {
  return per_replica(peaks.size(), [&](std::size_t r) {
    const auto higher = [](const Peak& a, const Peak& b) { return a.height < b.height; };
    const auto highest = std::max_element(peaks[r].begin(), peaks[r].end(), higher);
    return highest == peaks[r].end() ? NAN : highest->position;
  });
}

template <class F>
std::vector<double> each(const std::vector<VelocityDistribution>& replicas, F&& f) {
  return per_replica(replicas.size(), [&](std::size_t r) { return f(replicas[r]); });
}
double skewness(const VelocityDistribution& d) { return d.skewness; }
double kurtosis(const VelocityDistribution& d) { return d.kurtosis; }

/// "0.12 (0.01)".
std::string text_of(const std::vector<double>& values) {
  const Estimate e = over_replicas(values);
  return fmt::format("{:.3f} ({:.3f})", e.mean, e.error);
}

void check_one_peak(Evidence& evidence, const std::string& where, const std::vector<std::vector<Peak>>& peaks) {
  evidence.checks.push_back({.label = where + ": number of peaks",
                             .values = counts_of(peaks),
                             .band = {1, 1},
                             .exact = true,
                             .reference = 1});
}

std::string wall_label(const SceneValues& scene) {
  return fmt::format("nu {:.3g}, beta_w {:.1f}", scene.scene().area_fraction(),
                     scene.scene().wall_tangential_restitution[0]);
}

const char* peak_definition =
    "A peak is a maximum of the counts summed over .3 sigma that stands out on both sides by 2 % of the highest and by "
    "four standard errors, these from the scatter of the replicas.";

}  // namespace

// P(u_x) in the bin next to the walls: number of peaks, position of the highest and skewness; u_x about the
// instantaneous mean of the bin and about the long-time mean, in units of sigma. Thesis fig. 3.5a.
Evidence estimate_rough_wall_peak(const Claim&, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = density_plot("P(u_x) next to rough walls", 1e-4);
  for (const SceneValues& scene : by_area_fraction(records))
    for (const Velocity velocity : {Velocity::ux, Velocity::cx}) {
      const std::vector<VelocityDistribution> replicas = velocity_distributions(scene, velocity, 0);
      const std::vector<std::vector<Peak>> peaks = peaks_of(replicas);
      const std::string where = fmt::format("{}: {}", wall_label(scene), name_of(velocity));
      check_one_peak(evidence, where, peaks);
      evidence.checks.push_back({.label = where + ": position of the peak",
                                 .values = positions_of(peaks),
                                 .band = {-INFINITY, 0},
                                 .x = scene.scene().area_fraction(),
                                 .reference = NAN});
      evidence.checks.push_back({.label = where + ": skewness",
                                 .values = each(replicas, skewness),
                                 .band = {0, INFINITY},
                                 .x = scene.scene().area_fraction(),
                                 .reference = NAN});
      evidence.notes.push_back(fmt::format("{}: peak at {} sigma, skewness {}, kurtosis {}.", where,
                                           text_of(positions_of(peaks)), text_of(each(replicas, skewness)),
                                           text_of(each(replicas, kurtosis))));
      if (velocity == Velocity::ux) evidence.plot.series.push_back(density_series(wall_label(scene), replicas));
    }
  evidence.notes.emplace_back(peak_definition);
  return evidence;
}

// P(u_y) in the bin next to the walls, with bins of two widths: the dip at 0 between two humps. u_y is c_y, about its
// long-time mean 0. Thesis fig. 3.5b and its inset.
Evidence estimate_hump(const Claim& claim, Tier, const SceneRecords& records) {
  const int wide = static_cast<int>(claim.parameter("double_humped_bins"));
  Evidence evidence;
  evidence.plot = density_plot("P(u_y) next to rough walls", 0.1);
  evidence.plot.xrange = {{-2, 2}};
  evidence.plot.yrange = {{0.2, 1.5}};
  for (const SceneValues& scene : by_area_fraction(records)) {
    const bool humped = scene.bins() == wide;
    const std::vector<VelocityDistribution> replicas = velocity_distributions(scene, Velocity::uy, 0);
    evidence.checks.push_back({.label = fmt::format("{}, {} bins: dip of P(u_y) at 0", wall_label(scene), scene.bins()),
                               .values = each(replicas, dip_at_zero),
                               .band = humped ? Interval{0, INFINITY} : Interval{-INFINITY, 0},
                               .x = static_cast<double>(scene.bins()),
                               .reference = NAN});
    std::string text = fmt::format("{}, {} bins: dip at 0, from the wall inwards:", wall_label(scene), scene.bins());
    for (int bin = 0; bin < scene.half(); ++bin)
      text += fmt::format(" {}", text_of(each(velocity_distributions(scene, Velocity::uy, bin), dip_at_zero)));
    evidence.notes.push_back(text + "; -.13 for a Gaussian.");
    evidence.notes.push_back(fmt::format("{} bins, bin 1: {} peaks on average, kurtosis {}.", scene.bins(),
                                         text_of(counts_of(peaks_of(replicas))), text_of(each(replicas, kurtosis))));
    evidence.plot.series.push_back(density_series(fmt::format("{} bins", scene.bins()), replicas, 1));
  }
  evidence.notes.emplace_back("Dip: 1 - P(|u| < .1 sigma)/P(.4 sigma < |u| < .6 sigma).");
  evidence.notes.emplace_back(peak_definition);
  return evidence;
}

// P(c_x) in the bin next to the walls. Rough walls: one peak, below `low_velocity` of the mean velocity, c_x measured
// from the wall. Smooth walls: near a Gaussian. Thesis fig. 3.6.
Evidence estimate_cx_wall(const Claim& claim, Tier, const SceneRecords& records) {
  const double low = claim.parameter("low_velocity"), part = claim.parameter("part_of_distance");
  Evidence evidence;
  evidence.plot = density_plot("P(c_x) next to the walls, rough and smooth", 1e-4);
  evidence.plot.xlabel = "(c_x - U)/σ";
  std::map<double, std::vector<double>> rough_distance;
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const auto smooth = [](const SceneValues& s) { return s.scene().wall_tangential_restitution[0] > 0.5; };
  const auto nu_of = [](const SceneValues& s) { return std::round(1000 * s.scene().area_fraction()) / 1000; };
  for (const SceneValues& scene : scenes)
    if (!smooth(scene))
      rough_distance[nu_of(scene)] = each(velocity_distributions(scene, Velocity::cx, 0), distance_from_gaussian);
  for (const SceneValues& scene : scenes) {
    const std::vector<VelocityDistribution> replicas = velocity_distributions(scene, Velocity::cx, 0);
    const std::vector<double> distance = each(replicas, distance_from_gaussian);
    const std::vector<std::vector<Peak>> peaks = peaks_of(replicas);
    const std::vector<double> positions = positions_of(peaks);
    const std::vector<double> mode = per_replica(
        replicas.size(), [&](std::size_t r) { return 1 + positions[r] * replicas[r].sigma / replicas[r].mean; });
    const std::string where = wall_label(scene);
    const double nu = nu_of(scene);
    check_one_peak(evidence, where, peaks);
    if (smooth(scene)) {
      evidence.checks.push_back({.label = where + ": kurtosis of c_x",
                                 .values = each(replicas, kurtosis),
                                 .band = band_about(3, claim.tolerance_total()),
                                 .x = nu,
                                 .reference = 3});
      if (const auto rough = rough_distance.find(nu); rough != rough_distance.end())
        evidence.checks.push_back(
            {.label = where + ": distance from a Gaussian, less a part of that at rough walls",
             .values = per_replica(std::min(distance.size(), rough->second.size()),
                                   [&](std::size_t r) { return distance[r] - part * rough->second[r]; }),
             .band = {-INFINITY, 0},
             .x = nu,
             .reference = NAN});
    } else {
      evidence.checks.push_back({.label = where + ": most probable c_x, over the mean",
                                 .values = mode,
                                 .band = {-INFINITY, low},
                                 .x = nu,
                                 .reference = NAN});
    }
    evidence.notes.push_back(fmt::format(
        "{}: most probable c_x {} of the mean; about the mean, skewness {}, kurtosis {}; distance from a Gaussian {}.",
        where, text_of(mode), text_of(each(replicas, skewness)), text_of(each(replicas, kurtosis)), text_of(distance)));
    evidence.plot.series.push_back(density_series(where, replicas, 4));
  }
  evidence.notes.emplace_back(peak_definition);
  evidence.notes.emplace_back(
      "Distance: the greatest difference between the distribution function and that of a Gaussian of the same mean and "
      "variance.");
  return evidence;
}

}  // namespace gpf
