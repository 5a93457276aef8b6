// vdf.moderate.asym, vdf.shear.asym, vdf.plug.wall: which velocity distributions dissipation makes asymmetric between
// smooth walls, and which stay Gaussian (thesis figs. 3.11, 3.16).
#include <fmt/format.h>

#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {
namespace {

constexpr Interval positive{0, INFINITY};

/// P(u_y) in a bin and in its mirror image: skewed, in opposite senses, and mirror images of each other.
void check_mirror(const SceneValues& scene, int bin, double visible, Evidence& evidence) {
  const std::vector<double> near = scene.of(skewness_y.quantity, bin),
                            far = scene.of(skewness_y.quantity, scene.bins() - 1 - bin);
  const std::string place = fmt::format("{}, {}: ", flow_name(scene), bin_names(scene, bin));
  const auto add = [&](const char* what, std::vector<double> values, Interval band) {
    evidence.checks.push_back(
        {.label = place + what, .values = std::move(values), .band = band, .x = scene.centre(bin)});
  };
  add("skewness of u_y in the one times that in the other",
      per_replica(near.size(), [&](std::size_t r) { return near[r] * far[r]; }), {-INFINITY, 0});
  add("size of the skewness of u_y", departure(scene, skewness_y, bin), {visible, INFINITY});
  add("sum of the skewnesses of u_y", per_replica(near.size(), [&](std::size_t r) { return near[r] + far[r]; }),
      band_about(0, visible));
}

/// Skewness of u_x against y/W for each flow.
void plot_skewness(const std::vector<SceneValues>& scenes, double visible, const char* title, Evidence& evidence) {
  evidence.plot = {.title = title,
                   .xlabel = "y/W",
                   .ylabel = "skewness of u_x (points), u_y (lines)",
                   .xrange = {{0, 1}},
                   .series = {band_across(band_about(0, visible), "too small to be seen in P(u)")}};
  for (const SceneValues& scene : scenes) {
    const std::string name = fmt::format("e_n {:.3g}", scene.scene().normal_restitution);
    evidence.plot.series.push_back(moment_profile(scene, skewness_x, name + ", u_x"));
    Series line = moment_profile(scene, skewness_y, name + ", u_y");
    line.style = SeriesStyle::line;
    line.yerr.clear();
    evidence.plot.series.push_back(std::move(line));
  }
}

void note_skewness(const std::vector<SceneValues>& scenes, const std::vector<int>& bins, Evidence& evidence) {
  for (const SceneValues& scene : scenes)
    for (const int bin : bins)
      evidence.notes.push_back(fmt::format(
          "{}, {}: skewness of u_x {:.3f} ({:.3f} about the long-time mean), of u_y {:.3f} on the lower side; kurtosis "
          "{:.3f} and {:.3f}.",
          flow_name(scene), bin_names(scene, bin), over_replicas(moment(scene, skewness_x, bin)).mean,
          over_replicas(moment(scene, skewness_x_long_time, bin)).mean,
          over_replicas(moment(scene, skewness_y, bin)).mean, over_replicas(moment(scene, kurtosis_x, bin)).mean,
          over_replicas(moment(scene, kurtosis_y, bin)).mean));
  for (std::string& note : notes_on_definitions(scenes)) evidence.notes.push_back(std::move(note));
}

}  // namespace

// vdf.moderate.asym. At restitutions up to `highest_restitution`: skewness of u_x larger in size than the tolerance
// (the least asymmetry that a plot of P shows) in the bins `shear_bin` and the centre, within it in bin 1; skewness of
// u_y larger than it in `shear_bin` and its mirror image and of opposite sign, within it in bin 1 (fig. 3.11). No
// units.
Evidence estimate_moderate_asymmetry(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_restitution(records);
  const double visible = claim.tolerance_total(), highest = claim.parameter("highest_restitution") * (1 + 1e-9);
  const int shear = bin_parameter(claim, "shear_bin", scenes.front()), centre = scenes.front().half() - 1;
  Evidence evidence;
  for (const SceneValues& scene : scenes) {
    if (scene.scene().normal_restitution > highest) continue;
    for (const int bin : {shear, centre})
      for (const VelocityMoment& which : skewnesses_x)
        evidence.checks.push_back(
            {.label = fmt::format("{}, {}: size of the {}", flow_name(scene), bin_names(scene, bin), which.name),
             .values = departure(scene, which, bin),
             .band = {visible, INFINITY},
             .x = scene.centre(bin)});
    for (const VelocityMoment& which : {skewness_x, skewness_x_long_time, skewness_y})
      evidence.checks.push_back(moment_check(scene, which, 0, band_about(0, visible)));
    check_mirror(scene, shear, visible, evidence);
  }
  plot_skewness(scenes, visible, "Asymmetry at moderate area fraction", evidence);
  note_skewness(scenes, {0, shear, centre}, evidence);
  return evidence;
}

// vdf.shear.asym. In `shear_bin` and its mirror image, from each e_n to the next lower one: skewness of u_x falls; at
// the lowest e_n it is below minus the tolerance on both sides (negative u_x more likely in the tails), and the
// skewness of u_y changes sign between the two bins, which are mirror images (fig. 3.16, insets). No units.
Evidence estimate_shear_asymmetry(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_restitution(records);
  const double visible = claim.tolerance_total();
  const SceneValues& last = scenes.back();
  const int shear = bin_parameter(claim, "shear_bin", last);
  Evidence evidence;
  for (const VelocityMoment& which : skewnesses_x) {
    for (std::size_t k = 1; k < scenes.size(); ++k)
      evidence.checks.push_back(
          {.label = fmt::format("{}, {}: {} less that at e_n {:.3g}", flow_name(scenes[k - 1]), bin_names(last, shear),
                                which.name, scenes[k].scene().normal_restitution),
           .values = difference(moment(scenes[k - 1], which, shear), moment(scenes[k], which, shear)),
           .band = positive,
           .x = last.centre(shear)});
    for (const int bin : {shear, last.bins() - 1 - shear})
      evidence.checks.push_back({.label = fmt::format("{}, bin {}: {}", flow_name(last), bin + 1, which.name),
                                 .values = last.of(which.quantity, bin),
                                 .band = {-INFINITY, -visible},
                                 .x = last.centre(bin)});
  }
  check_mirror(last, shear, visible, evidence);
  plot_skewness(scenes, visible, "Asymmetry in the shear layer", evidence);
  note_skewness(scenes, {shear}, evidence);
  return evidence;
}

// vdf.plug.wall. In bin 1 at every e_n: kurtosis of u_x (either mean) and u_y within the tolerance of 3, skewness
// within `largest_skewness` of zero (fig. 3.16, upper inset). No units.
Evidence estimate_wall_gaussian(const Claim& claim, Tier, const SceneRecords& records) {
  constexpr double gaussian = 3;
  const std::vector<SceneValues> scenes = by_restitution(records);
  const Interval flat = band_about(gaussian, claim.tolerance_total()),
                 even = band_about(0, claim.parameter("largest_skewness"));
  const double lowest = scenes.back().scene().normal_restitution, highest = scenes.front().scene().normal_restitution;
  Evidence evidence;
  evidence.plot = {.title = "Kurtosis next to smooth walls",
                   .xlabel = "e_n",
                   .ylabel = "kurtosis in bin 1",
                   .series = {{.label = "band about a Gaussian",
                               .style = SeriesStyle::band,
                               .x = {lowest, highest},
                               .y = {gaussian, gaussian},
                               .lower = {flat.lo, flat.lo},
                               .upper = {flat.hi, flat.hi}}}};
  for (const VelocityMoment& which : {kurtosis_x, kurtosis_x_long_time, kurtosis_y}) {
    Series points{.label = std::string(which.name)};
    for (const SceneValues& scene : scenes) {
      evidence.checks.push_back(moment_check(scene, which, 0, flat));
      add_point(points, scene.scene().normal_restitution, evidence.checks.back().values);
    }
    evidence.plot.series.push_back(std::move(points));
  }
  for (const VelocityMoment& which : {skewness_x, skewness_x_long_time, skewness_y})
    for (const SceneValues& scene : scenes) evidence.checks.push_back(moment_check(scene, which, 0, even));
  note_skewness(scenes, {0}, evidence);
  return evidence;
}

}  // namespace gpf
