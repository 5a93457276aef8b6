// cxx.elastic, cxx.plug, cxx.dense, cxy.plug: how the velocities of the disks of a bin depend on each other.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/pair_functions.hpp"

namespace gpf {
namespace {

struct Window {
  double from, to;  ///< distances in diameters
};
constexpr Window near{1, 3}, far{10, 12};

/// A correlation of one bin of a scene, or what is forced on C_xx taken off it (Mean::instantaneous).
struct Function {
  Component component;
  Mean mean;
  const char* name;
};
constexpr Function cxx{Component::xx, Mean::instantaneous, "C_xx"},
    cxx_long_time{Component::xx, Mean::long_time, "C_xx about the long-time mean"},
    cyy{Component::yy, Mean::instantaneous, "C_yy"}, cxy{Component::xy, Mean::instantaneous, "C_xy"};

/// Pair-weighted mean of a correlation in a window, one value per replica. -1/(n - 1), which eq. 2.10 forces upon C_xx
/// at every distance even where velocities are independent, is taken off.
std::vector<double> mean_in(const Window& window, const Function& function, const std::vector<PairFunctions>& pairs) {
  const bool forced = function.component == Component::xx && function.mean == Mean::instantaneous;
  return per_replica(pairs.size(), [&](std::size_t r) {
    return pairs[r].mean_correlation(function.component, window.from, window.to, function.mean) -
           (forced ? pairs[r].forced_offset() : 0);
  });
}

std::vector<double> magnitude(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

std::vector<double> less(const std::vector<double>& a, const std::vector<double>& b) {
  return per_replica(std::min(a.size(), b.size()), [&](std::size_t r) { return a[r] - b[r]; });
}

std::string text_of(const std::vector<double>& values) {
  const Estimate e = over_replicas(values);
  return fmt::format("{:.3f} +- {:.3f}", e.mean, e.error);
}

Plot plot_of(std::string title, std::string ylabel) {
  return {.title = std::move(title), .xlabel = "r/d", .ylabel = std::move(ylabel), .xrange = {{0.9, 12}}};
}

Series series_of(const std::string& label, const std::vector<PairFunctions>& pairs, const Function& function) {
  return curve_of(label, pairs, [function](const PairFunctions& p) {
    return p.velocity_correlation(function.component, function.mean);
  });
}

const char* const definitions =
    "C_ab(r) = <u_a u_b'>/<u_a u_b> over pairs at distance r (eq. 3.4, read as a mean over pairs), from the pairs of "
    "one "
    "bin, y and W - y together; u_x about the instantaneous mean of the bin (eq. 2.10), unless the long-time mean is "
    "named. Curves are as measured; from the numbers of C_xx the mean over all pairs that eq. 2.10 forces, -1/(n - 1), "
    "is "
    "taken off.";

}  // namespace

/// Figs. 3.31a, 3.32a: C_xx and C_yy vanish. Every bin, four windows of distance, both means.
Evidence estimate_elastic_correlations(const Claim& claim, Tier, const SceneRecords& records) {
  const Interval band = band_about(0, claim.tolerance_total());
  Evidence evidence;
  evidence.plot = plot_of("Velocity correlations of nearly elastic disks", "C_xx, C_yy");
  evidence.plot.series.push_back({.label = "band",
                                  .style = SeriesStyle::band,
                                  .x = {1, 12},
                                  .y = {0, 0},
                                  .lower = {band.lo, band.lo},
                                  .upper = {band.hi, band.hi}});
  for (const auto& [name, replicas] : records) {
    const SceneValues scene(name, replicas);
    for (int bin = 0; bin < scene.half(); ++bin) {
      const std::vector<PairFunctions> pairs = pair_functions(scene, bin);
      for (const Function& function : {cxx, cxx_long_time, cyy})
        for (const Window& window : {Window{1, 1.5}, Window{1.5, 3}, Window{3, 6}, Window{6, 12}})
          evidence.checks.push_back(
              {.label = fmt::format("{}, bins {} and {}: {} at {} to {} d", label_of(scene.scene()), bin + 1,
                                    scene.bins() - bin, function.name, window.from, window.to),
               .values = mean_in(window, function, pairs),
               .band = band,
               .x = (window.from + window.to) / 2,
               .reference = 0});
      if (bin + 1 == scene.half() || bin == 0) {
        evidence.plot.series.push_back(series_of(fmt::format("C_xx, bin {}", bin + 1), pairs, cxx));
        evidence.plot.series.push_back(series_of(fmt::format("C_yy, bin {}", bin + 1), pairs, cyy));
        evidence.notes.push_back(fmt::format(
            "{}, bin {}: eq. 2.10 forces a mean of {:.4f} upon C_xx. At 1 to 3 d C_xx {}, about the long-time mean {}, "
            "C_yy {}.",
            label_of(scene.scene()), bin + 1,
            over_replicas(per_replica(pairs.size(), [&](auto r) { return pairs[r].forced_offset(); })).mean,
            text_of(mean_in(near, cxx, pairs)), text_of(mean_in(near, cxx_long_time, pairs)),
            text_of(mean_in(near, cyy, pairs))));
      }
    }
  }
  evidence.notes.emplace_back(definitions);
  return evidence;
}

/// Figs. 3.31b, 3.32b, 3.36b: at 1 to 3 d C_xx and C_yy are larger in the plug (centre) than in bin 5, and there no
/// smaller than next to the wall; at 10 to 12 d C_xx of the plug is negative.
Evidence estimate_plug_correlations(const Claim&, Tier, const SceneRecords& records) {
  const Interval positive{0, INFINITY}, negative{-INFINITY, 0};
  Evidence evidence;
  evidence.plot = plot_of("Velocity correlations with a plug", "C_xx, C_yy");
  for (const auto& [name, replicas] : records) {
    const SceneValues scene(name, replicas);
    const std::string label = label_of(scene.scene());
    const int centre = scene.half() - 1, shear = scene.half() / 2;
    const std::vector<PairFunctions> plug = pair_functions(scene, centre), layer = pair_functions(scene, shear),
                                     wall = pair_functions(scene, 0);
    for (const Function& function : {cxx, cyy}) {
      const std::vector<double> strong = mean_in(near, function, plug);
      evidence.checks.push_back({.label = fmt::format("{}: {} at 1 to 3 d in the plug", label, function.name),
                                 .values = strong,
                                 .band = positive});
      for (const auto* outside : {&layer, &wall})
        evidence.checks.push_back({.label = fmt::format("{}: {} at 1 to 3 d in the plug less |C| of bin {}", label,
                                                        function.name, outside == &wall ? 1 : shear + 1),
                                   .values = less(strong, magnitude(mean_in(near, function, *outside))),
                                   .band = positive});
      evidence.notes.push_back(
          fmt::format("{}: {} at 1 to 3 d: {} in the plug, {} in bin {}, {} in bin 1; at 10 to 12 d in "
                      "the plug {}.",
                      label, function.name, text_of(strong), text_of(mean_in(near, function, layer)), shear + 1,
                      text_of(mean_in(near, function, wall)), text_of(mean_in(far, function, plug))));
    }
    evidence.checks.push_back(
        {.label = label + ": C_xx at 10 to 12 d in the plug", .values = mean_in(far, cxx, plug), .band = negative});
    evidence.notes.push_back(fmt::format(
        "{}: about the long-time mean C_xx of the plug is {} at 1 to 3 d and {} at 10 to 12 d: the plug drifts "
        "and sloshes as one piece; of bin {} {} and {}.",
        label, text_of(mean_in(near, cxx_long_time, plug)), text_of(mean_in(far, cxx_long_time, plug)), shear + 1,
        text_of(mean_in(near, cxx_long_time, layer)), text_of(mean_in(far, cxx_long_time, layer))));
    evidence.plot.series.push_back(series_of("C_xx, plug; " + label, plug, cxx));
    evidence.plot.series.push_back(series_of("C_yy, plug; " + label, plug, cyy));
    evidence.plot.series.push_back(series_of(fmt::format("C_xx, bin {}; ", shear + 1) + label, layer, cxx));
  }
  evidence.notes.emplace_back(definitions);
  return evidence;
}

/// Figs. 3.38, 3.39: C_xx and C_yy of the centre and of bin 2 vanish at the higher e_n and are larger at the lower.
Evidence estimate_dense_correlations(const Claim& claim, Tier, const SceneRecords& records) {
  const Interval band = band_about(0, claim.tolerance_total()), positive{0, INFINITY};
  Evidence evidence;
  evidence.plot = plot_of("Velocity correlations of a very dense flow", "C_xx, C_yy");
  std::vector<SceneValues> scenes;
  for (const auto& [name, replicas] : records) scenes.emplace_back(name, replicas);
  std::sort(scenes.begin(), scenes.end(), [](const SceneValues& a, const SceneValues& b) {
    return a.scene().normal_restitution > b.scene().normal_restitution;
  });
  for (const int bin : {scenes.front().half() - 1, 1})
    for (const Function& function : {cxx, cyy}) {
      const std::vector<PairFunctions> elastic = pair_functions(scenes.front(), bin),
                                       inelastic = pair_functions(scenes.back(), bin);
      const std::vector<double> weak = mean_in(near, function, elastic), strong = mean_in(near, function, inelastic);
      const std::string what = fmt::format("bin {}: {} at 1 to 3 d", bin + 1, function.name);
      evidence.checks.push_back(
          {.label = fmt::format("{}, e_n {:.2f}", what, scenes.front().scene().normal_restitution),
           .values = weak,
           .band = band,
           .reference = 0});
      evidence.checks.push_back(
          {.label = fmt::format("{}, e_n {:.2f} less e_n {:.2f}", what, scenes.back().scene().normal_restitution,
                                scenes.front().scene().normal_restitution),
           .values = less(strong, magnitude(weak)),
           .band = positive});
      evidence.notes.push_back(fmt::format("{}: {} at the higher e_n, {} at the lower; at 10 to 12 d {} and {}.", what,
                                           text_of(weak), text_of(strong), text_of(mean_in(far, function, elastic)),
                                           text_of(mean_in(far, function, inelastic))));
      for (const auto* pairs : {&elastic, &inelastic})
        evidence.plot.series.push_back(
            series_of(fmt::format("{}, bin {}, e_n {:.2f}", function.name, bin + 1,
                                  (pairs == &elastic ? scenes.front() : scenes.back()).scene().normal_restitution),
                      *pairs, function));
    }
  evidence.notes.emplace_back(definitions);
  return evidence;
}

/// Fig. 3.33: |C_xy| at 1 to 3 d is larger in the plug than in bin 5 and next to the wall, and larger there at the
/// lower e_n. C_xy is odd in y - W/2: bins of the upper half enter with the opposite sign.
Evidence estimate_cross_correlations(const Claim&, Tier, const SceneRecords& records) {
  const Interval positive{0, INFINITY};
  Evidence evidence;
  evidence.plot = plot_of("Cross correlation of u_x and c_y", "C_xy");
  std::vector<SceneValues> scenes;
  for (const auto& [name, replicas] : records) scenes.emplace_back(name, replicas);
  std::sort(scenes.begin(), scenes.end(), [](const SceneValues& a, const SceneValues& b) {
    return a.scene().normal_restitution < b.scene().normal_restitution;
  });
  const int centre = scenes.front().half() - 1, shear = scenes.front().half() / 2;
  const std::vector<double> plug = magnitude(mean_in(near, cxy, pair_functions(scenes.front(), centre)));
  for (const int bin : {shear, 0})
    evidence.checks.push_back({.label = fmt::format("{}: |C_xy| at 1 to 3 d in the plug less that of bin {}",
                                                    label_of(scenes.front().scene()), bin + 1),
                               .values = less(plug, magnitude(mean_in(near, cxy, pair_functions(scenes.front(), bin)))),
                               .band = positive});
  evidence.checks.push_back(
      {.label = fmt::format("centre: |C_xy| at 1 to 3 d, e_n {:.2f} less e_n {:.2f}",
                            scenes.front().scene().normal_restitution, scenes.back().scene().normal_restitution),
       .values = less(plug, magnitude(mean_in(near, cxy, pair_functions(scenes.back(), centre)))),
       .band = positive});
  for (const SceneValues& scene : scenes)
    for (const int bin : {centre, shear, 0}) {
      const std::vector<PairFunctions> pairs = pair_functions(scene, bin);
      const std::vector<double> c = mean_in(near, cxy, pairs);
      const std::vector<double> one = per_replica(pairs.size(), [&](auto r) { return pairs[r].one_disk_xy(); });
      evidence.notes.push_back(
          fmt::format("{}, bin {}: C_xy {} at 1 to 3 d; of one disk <u_x c_y> is {} in the same unit, so that eq. 3.4 "
                      "as it is printed "
                      "gives {}.",
                      label_of(scene.scene()), bin + 1, text_of(c), text_of(one),
                      text_of(per_replica(c.size(), [&](std::size_t r) { return c[r] / one[r]; }))));
      evidence.plot.series.push_back(
          series_of(fmt::format("e_n {:.2f}, bin {}", scene.scene().normal_restitution, bin + 1), pairs, cxy));
    }
  evidence.notes.emplace_back(
      "C_xy is divided by (<u_x^2><c_y^2>)^(1/2): <u_x c_y>, which eq. 3.4 divides by, vanishes at the centre plane, "
      "where "
      "the printed form is a ratio of two small numbers.");
  evidence.notes.emplace_back(definitions);
  return evidence;
}

}  // namespace gpf
