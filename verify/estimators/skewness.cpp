// skew.elastic, skew.dissipation: the skewness of P(u_x) and P(u_y) across the channel (thesis sec. 3.2.3, figs. 3.26,
// 3.27).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {
namespace {

constexpr Interval positive{0, INFINITY}, negative{-INFINITY, 0};

/// Flows between equal walls at one area fraction, from the most elastic to the most dissipative.
using Group = std::vector<SceneValues>;

/// Keyed by area fraction and beta_w, rounded to what names a scene.
std::map<std::pair<int, int>, Group> groups(const SceneRecords& records) {
  std::map<std::pair<int, int>, Group> result;
  for (SceneValues& scene : by_restitution(records)) {
    const Scene& s = scene.scene();
    const auto key = std::pair(static_cast<int>(std::lround(1000 * s.area_fraction())),
                               static_cast<int>(std::lround(1000 * s.wall_tangential_restitution[lower])));
    result[key].push_back(std::move(scene));
  }
  return result;
}

double roughness(const SceneValues& scene) { return scene.scene().wall_tangential_restitution[lower]; }

void add_notes(const std::vector<SceneValues>& scenes, Evidence& evidence) {
  for (std::string& note : notes_on_definitions(scenes)) evidence.notes.push_back(std::move(note));
}

/// Bin (from 0) of one side with the largest mean.
int largest_bin(const SceneValues& scene, const VelocityMoment& which) {
  int largest = 0;
  for (int bin = 1; bin < scene.half(); ++bin)
    if (std::abs(over_replicas(moment(scene, which, bin)).mean) >
        std::abs(over_replicas(moment(scene, which, largest)).mean))
      largest = bin;
  return largest;
}

void plot_profiles(const std::vector<SceneValues>& scenes, const VelocityMoment& which, const std::string& title,
                   Evidence& evidence) {
  evidence.plot = {.title = title,
                   .xlabel = "y/W",
                   .ylabel = std::string(which.name),
                   .xrange = {{0, 1}},
                   .series = {{.style = SeriesStyle::line, .x = {0, 1}, .y = {0, 0}}}};
  for (const SceneValues& scene : scenes)
    evidence.plot.series.push_back(moment_profile(scene, which, flow_name(scene)));
}

}  // namespace

// skew.elastic. The source calls the skewness of u_x in bin 1 between rough walls different from zero, and every other
// one close to zero. So each other one must be nearer to zero than to that one at the same area fraction: its size less
// half of that one is negative. Both definitions of u_x. No units.
Evidence estimate_skewness_elastic(const Claim&, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  Evidence evidence;
  for (const SceneValues& scene : scenes) {
    const auto roughest =
        std::min_element(scenes.begin(), scenes.end(), [&](const SceneValues& a, const SceneValues& b) {
          const auto rank = [&](const SceneValues& s) {  // other area fractions last
            return std::pair(std::abs(s.scene().area_fraction() - scene.scene().area_fraction()) > 1e-3, roughness(s));
          };
          return rank(a) < rank(b);
        });
    for (const VelocityMoment& which : {skewness_x, skewness_x_long_time, skewness_y}) {
      std::vector<double> half = moment(*roughest, which.parity == Parity::odd ? skewness_x : which, 0);
      for (double& value : half) value /= 2;
      for (int bin = 0; bin < scene.half(); ++bin) {
        if (&scene == &*roughest && bin == 0 && which.parity == Parity::even) continue;
        evidence.checks.push_back(
            {.label = fmt::format("{}, {}: size of the {} less half of that of u_x at rough walls", flow_name(scene),
                                  bin_names(scene, bin), which.name),
             .values = difference(departure(scene, which, bin), half),
             .band = negative,
             .x = scene.centre(bin)});
      }
    }
    const int x = largest_bin(scene, skewness_x), y = largest_bin(scene, skewness_y);
    evidence.notes.push_back(fmt::format(
        "{}: the skewness of u_x is largest in {}, {:.3f}, and that of u_y in {}, {:.3f} on the lower side.",
        flow_name(scene), bin_names(scene, x), over_replicas(moment(scene, skewness_x, x)).mean, bin_names(scene, y),
        over_replicas(moment(scene, skewness_y, y)).mean));
  }
  plot_profiles(scenes, skewness_x, "Skewness of u_x in nearly elastic flows", evidence);
  for (const SceneValues& scene : scenes) {
    Series line = moment_profile(scene, skewness_y, "u_y, " + flow_name(scene));
    line.style = SeriesStyle::line;
    line.yerr.clear();
    evidence.plot.series.push_back(std::move(line));
  }
  evidence.plot.ylabel = "skewness of u_x (points), u_y (lines)";
  add_notes(scenes, evidence);
  return evidence;
}

// skew.dissipation. For each area fraction and pair of walls, in the shear bin (`shear_bin`; from `dense_from` on
// `dense_shear_bin`): the size of the skewness grows from each e_n to the next lower one. At the lowest e_n: it is
// larger there than in the plug (centre), skewness of u_x is negative in every bin, and that of u_y has opposite signs
// on the two sides. Both definitions of u_x where no plug sloshes: not at its centre. No units.
Evidence estimate_skewness_dissipation(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  std::vector<SceneValues> most_dissipative;
  for (const auto& [key, group] : groups(records)) {
    const SceneValues& last = group.back();
    const bool dense = last.scene().area_fraction() >= claim.parameter("dense_from");
    const int shear = bin_parameter(claim, dense ? "dense_shear_bin" : "shear_bin", last), centre = last.half() - 1;
    const auto add = [&](const SceneValues& scene, int bin, const std::string& what, std::vector<double> values,
                         Interval band) {
      evidence.checks.push_back({.label = fmt::format("{}, {}: {}", flow_name(scene), bin_names(scene, bin), what),
                                 .values = std::move(values),
                                 .band = band,
                                 .x = scene.centre(bin)});
    };
    for (const VelocityMoment& which : {skewness_x, skewness_x_long_time, skewness_y})
      for (std::size_t k = 1; k < group.size(); ++k)
        add(group[k], shear,
            fmt::format("size of the {} less that at e_n {:.3g}", which.name, group[k - 1].scene().normal_restitution),
            difference(departure(group[k], which, shear), departure(group[k - 1], which, shear)), positive);
    for (const VelocityMoment& which : {skewness_x, skewness_y})
      add(last, shear, fmt::format("size of the {} less that at the centre", which.name),
          difference(departure(last, which, shear), departure(last, which, centre)), positive);
    for (int bin = 0; bin < last.half(); ++bin)
      add(last, bin, std::string(skewness_x.name), moment(last, skewness_x, bin), negative);
    const std::vector<double> near = last.of(skewness_y.quantity, shear),
                              far = last.of(skewness_y.quantity, last.bins() - 1 - shear);
    add(last, shear, "skewness of u_y in the one times that in the other",
        per_replica(near.size(), [&](std::size_t r) { return near[r] * far[r]; }), negative);

    const int x = largest_bin(last, skewness_x), y = largest_bin(last, skewness_y);
    evidence.notes.push_back(fmt::format(
        "{}: the skewness of u_x is largest in {}, {:.3f}, that of u_y in {}, {:.3f} on the lower side; at the centre "
        "{:.3f} and {:.3f}. About the long-time mean u_x has {:.3f} in the shear bin and {:.3f} at the centre.",
        flow_name(last), bin_names(last, x), over_replicas(moment(last, skewness_x, x)).mean, bin_names(last, y),
        over_replicas(moment(last, skewness_y, y)).mean, over_replicas(moment(last, skewness_x, centre)).mean,
        over_replicas(moment(last, skewness_y, centre)).mean,
        over_replicas(moment(last, skewness_x_long_time, shear)).mean,
        over_replicas(moment(last, skewness_x_long_time, centre)).mean));
    most_dissipative.push_back(last);
  }
  plot_profiles(most_dissipative, skewness_x, "Skewness of u_x at the lowest e_n", evidence);
  add_notes(most_dissipative, evidence);
  return evidence;
}

}  // namespace gpf
