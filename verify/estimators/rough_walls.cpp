// vdf.rough.centre, vdf.rough.beta: what rough walls do to P(u_x), at the wall and at the centre of the channel (thesis
// figs. 3.5, 3.7).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {
namespace {

constexpr double gaussian = 3;
constexpr Interval positive{0, INFINITY};

/// Largest departure of the kurtosis from 3 in the bins from `first` to the centre, one value per replica.
std::vector<double> largest_departure(const SceneValues& scene, const VelocityMoment& which, int first) {
  std::vector<double> largest(scene.replicas(), 0.0);
  for (int bin = first; bin < scene.half(); ++bin) {
    const std::vector<double> values = departure(scene, which, bin, gaussian);
    for (std::size_t r = 0; r < values.size(); ++r) largest[r] = std::max(largest[r], values[r]);
  }
  return largest;
}

std::vector<double> larger(const std::vector<double>& a, const std::vector<double>& b) {
  return per_replica(std::min(a.size(), b.size()), [&](std::size_t r) { return std::max(a[r], b[r]); });
}

void compare_kurtosis(const std::vector<SceneValues>& scenes, std::size_t first_dense, int wall_bins,
                      const VelocityMoment& which, Evidence& evidence) {
  std::vector<double> beyond;  // largest departure of all dense flows, away from the wall
  for (std::size_t k = first_dense; k < scenes.size(); ++k) {
    const std::vector<double> here = largest_departure(scenes[k], which, wall_bins);
    evidence.checks.push_back(
        {.label = fmt::format("{}: departure of the {} from 3 in {} less the largest beyond the wall region",
                              flow_name(scenes[k]), which.name, bin_names(scenes[k], 0)),
         .values = difference(departure(scenes[k], which, 0, gaussian), here),
         .band = positive,
         .x = scenes[k].centre(0)});
    beyond = beyond.empty() ? here : larger(beyond, here);
  }
  const SceneValues& dilute = scenes.front();
  for (int bin = 0; bin < dilute.half(); ++bin)
    evidence.checks.push_back(
        {.label = fmt::format("{}, {}: departure of the {} from 3 less the largest of dense flows beyond the wall",
                              flow_name(dilute), bin_names(dilute, bin), which.name),
         .values = difference(departure(dilute, which, bin, gaussian), beyond),
         .band = positive,
         .x = dilute.centre(bin)});
}

double wall_roughness(const SceneValues& scene) { return scene.scene().wall_tangential_restitution[lower]; }

}  // namespace

// vdf.rough.centre. The most dilute flow against the dense ones (area fraction at least `dense_from`). At the centre:
// skewness of u_x beyond the tolerance (the least asymmetry that a plot of P shows) when dilute, within it when dense.
// Kurtosis of u_x (fig. 3.7a): its departure from 3 is larger in every bin of the dilute flow than anywhere in a dense
// one outside the `wall_bins` bins at the wall; in dense flows it is largest in bin 1. No units.
Evidence estimate_rough_centre(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const double visible = claim.tolerance_total(), dense_from = claim.parameter("dense_from");
  const int wall_bins = bin_parameter(claim, "wall_bins", scenes.front()) + 1;
  const auto first_dense =
      static_cast<std::size_t>(std::count_if(scenes.begin(), scenes.end(), [&](const SceneValues& s) {
        return s.scene().area_fraction() < dense_from * (1 - 1e-9);
      }));

  Evidence evidence;
  for (std::size_t k = 0; k < scenes.size(); ++k)
    for (const VelocityMoment& which : skewnesses_x) {
      const int centre = scenes[k].half() - 1;
      if (k == 0)
        evidence.checks.push_back({.label = fmt::format("{}, {}: size of the {}", flow_name(scenes[k]),
                                                        bin_names(scenes[k], centre), which.name),
                                   .values = departure(scenes[k], which, centre),
                                   .band = {visible, INFINITY},
                                   .x = scenes[k].centre(centre)});
      else if (k >= first_dense)
        evidence.checks.push_back(moment_check(scenes[k], which, centre, band_about(0, visible)));
    }
  for (const VelocityMoment& which : kurtoses_x) compare_kurtosis(scenes, first_dense, wall_bins, which, evidence);

  evidence.plot = {
      .title = "Kurtosis of u_x between rough walls",
      .xlabel = "y/W",
      .ylabel = "kurtosis of u_x",
      .xrange = {{0, 1}},
      .series = {{.label = "Gaussian", .style = SeriesStyle::line, .x = {0, 1}, .y = {gaussian, gaussian}}}};
  for (const SceneValues& scene : scenes) {
    const int centre = scene.half() - 1;
    evidence.plot.series.push_back(
        moment_profile(scene, kurtosis_x, fmt::format("nu {:.3g}", scene.scene().area_fraction())));
    evidence.notes.push_back(fmt::format(
        "{}: at the centre skewness of u_x {:.3f} and kurtosis {:.3f}; in bin 1 {:.3f} and {:.3f}.", flow_name(scene),
        over_replicas(moment(scene, skewness_x, centre)).mean, over_replicas(moment(scene, kurtosis_x, centre)).mean,
        over_replicas(moment(scene, skewness_x, 0)).mean, over_replicas(moment(scene, kurtosis_x, 0)).mean));
  }
  for (std::string& note : notes_on_definitions(scenes)) evidence.notes.push_back(std::move(note));
  return evidence;
}

// vdf.rough.beta. Skewness of u_x in bin 1 against beta_w: it falls from each wall to the next smoother one, and at the
// smoothest it is within the tolerance of zero (fig. 3.5a, lower inset). No units.
Evidence estimate_rough_beta(const Claim& claim, Tier, const SceneRecords& records) {
  std::vector<SceneValues> scenes = by_area_fraction(records);
  std::stable_sort(scenes.begin(), scenes.end(),
                   [](const SceneValues& a, const SceneValues& b) { return wall_roughness(a) < wall_roughness(b); });
  const Interval unseen = band_about(0, claim.tolerance_total());
  const double roughest = wall_roughness(scenes.front()), smoothest = wall_roughness(scenes.back());
  Evidence evidence;
  evidence.plot = {.title = "Asymmetry of P(u_x) next to the wall",
                   .xlabel = "beta_w",
                   .ylabel = "skewness of u_x in bin 1",
                   .series = {{.label = "too small to be seen in P(u_x)",
                               .style = SeriesStyle::band,
                               .x = {roughest, smoothest},
                               .y = {0, 0},
                               .lower = {unseen.lo, unseen.lo},
                               .upper = {unseen.hi, unseen.hi}}}};
  for (const VelocityMoment& which : skewnesses_x) {
    Series points{.label = std::string(which.name)};
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      const std::vector<double> values = moment(scenes[k], which, 0);
      add_point(points, wall_roughness(scenes[k]), values);
      if (k > 0)
        evidence.checks.push_back(
            {.label = fmt::format("{}, {}: {} less that at beta_w {:.3g}", flow_name(scenes[k - 1]),
                                  bin_names(scenes[k], 0), which.name, wall_roughness(scenes[k])),
             .values = difference(moment(scenes[k - 1], which, 0), values),
             .band = positive,
             .x = wall_roughness(scenes[k - 1])});
    }
    evidence.checks.push_back(moment_check(scenes.back(), which, 0, unseen));
    evidence.plot.series.push_back(std::move(points));
  }
  for (const SceneValues& scene : scenes)
    evidence.notes.push_back(fmt::format("{}, {}: skewness of u_x {:.3f}, kurtosis {:.3f}.", flow_name(scene),
                                         bin_names(scene, 0), over_replicas(moment(scene, skewness_x, 0)).mean,
                                         over_replicas(moment(scene, kurtosis_x, 0)).mean));
  for (std::string& note : notes_on_definitions(scenes)) evidence.notes.push_back(std::move(note));
  return evidence;
}

}  // namespace gpf
