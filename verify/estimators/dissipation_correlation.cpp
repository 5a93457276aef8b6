// cxx.dense, cxy.plug: how the velocities of the disks of a bin depend on each other, against e_n.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verify/estimators/correlation_windows.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf {

namespace {

std::vector<SceneValues> most_dissipative_first(const SceneRecords& records) {
  std::vector<SceneValues> scenes;
  for (const auto& [name, replicas] : records) scenes.emplace_back(name, replicas);
  std::sort(scenes.begin(), scenes.end(), [](const SceneValues& a, const SceneValues& b) {
    return a.scene().normal_restitution < b.scene().normal_restitution;
  });
  return scenes;
}

}  // namespace

/// Figs. 3.38, 3.39: C_xx and C_yy of the centre and of bin 2 vanish at the higher e_n and are larger at the lower.
Evidence estimate_dense_correlations(const Claim& claim, Tier, const SceneRecords& records) {
  const Interval band = band_about(0, claim.tolerance_total()), positive{0, INFINITY};
  Evidence evidence;
  evidence.plot = correlation_plot("Velocity correlations of a very dense flow", "C_xx, C_yy");
  const std::vector<SceneValues> scenes = most_dissipative_first(records);
  for (const int bin : {scenes.back().half() - 1, 1})
    for (const VelocityCorrelation& function : {cxx, cyy}) {
      const std::vector<PairFunctions> elastic = pair_functions(scenes.back(), bin),
                                       inelastic = pair_functions(scenes.front(), bin);
      const std::vector<double> weak = mean_in(near_window, function, elastic),
                                strong = mean_in(near_window, function, inelastic);
      const std::string what = fmt::format("bin {}: {} at 1 to 3 d", bin + 1, function.name);
      evidence.checks.push_back({.label = fmt::format("{}, e_n {:.2f}", what, scenes.back().scene().normal_restitution),
                                 .values = weak,
                                 .band = band,
                                 .reference = 0});
      evidence.checks.push_back(
          {.label = fmt::format("{}, e_n {:.2f} less e_n {:.2f}", what, scenes.front().scene().normal_restitution,
                                scenes.back().scene().normal_restitution),
           .values = difference(strong, magnitude(weak)),
           .band = positive});
      evidence.notes.push_back(fmt::format(
          "{}: {} at the higher e_n, {} at the lower; at 10 to 12 d {} and {}.", what, text_of(weak), text_of(strong),
          text_of(mean_in(far_window, function, elastic)), text_of(mean_in(far_window, function, inelastic))));
      for (const auto* pairs : {&elastic, &inelastic})
        evidence.plot.series.push_back(correlation_series(
            fmt::format("{}, bin {}, e_n {:.2f}", function.name, bin + 1,
                        (pairs == &elastic ? scenes.back() : scenes.front()).scene().normal_restitution),
            *pairs, function));
    }
  evidence.notes.emplace_back(correlation_definitions);
  return evidence;
}

/// Fig. 3.33: |C_xy| at 1 to 3 d is larger in the plug than in bin 5 and next to the wall, and larger there at the
/// lower e_n. C_xy is odd in y - W/2: bins of the upper half enter with the opposite sign.
Evidence estimate_cross_correlations(const Claim&, Tier, const SceneRecords& records) {
  const Interval positive{0, INFINITY};
  Evidence evidence;
  evidence.plot = correlation_plot("Cross correlation of u_x and c_y", "C_xy");
  const std::vector<SceneValues> scenes = most_dissipative_first(records);
  const int centre = scenes.front().half() - 1, shear = scenes.front().half() / 2;
  const std::vector<double> plug = magnitude(mean_in(near_window, cxy, pair_functions(scenes.front(), centre)));
  for (const int bin : {shear, 0})
    evidence.checks.push_back(
        {.label = fmt::format("{}: |C_xy| at 1 to 3 d in the plug less that of bin {}",
                              label_of(scenes.front().scene()), bin + 1),
         .values = difference(plug, magnitude(mean_in(near_window, cxy, pair_functions(scenes.front(), bin)))),
         .band = positive});
  evidence.checks.push_back(
      {.label = fmt::format("centre: |C_xy| at 1 to 3 d, e_n {:.2f} less e_n {:.2f}",
                            scenes.front().scene().normal_restitution, scenes.back().scene().normal_restitution),
       .values = difference(plug, magnitude(mean_in(near_window, cxy, pair_functions(scenes.back(), centre)))),
       .band = positive});
  for (const SceneValues& scene : scenes)
    for (const int bin : {centre, shear, 0}) {
      const std::vector<PairFunctions> pairs = pair_functions(scene, bin);
      const std::vector<double> c = mean_in(near_window, cxy, pairs);
      const std::vector<double> one = per_replica(pairs.size(), [&](auto r) { return pairs[r].one_disk_xy(); });
      evidence.notes.push_back(
          fmt::format("{}, bin {}: C_xy {} at 1 to 3 d; of one disk <u_x c_y> is {} in the same unit, so that eq. 3.4 "
                      "as it is printed "
                      "gives {}.",
                      label_of(scene.scene()), bin + 1, text_of(c), text_of(one),
                      text_of(per_replica(c.size(), [&](std::size_t r) { return c[r] / one[r]; }))));
      evidence.plot.series.push_back(
          correlation_series(fmt::format("e_n {:.2f}, bin {}", scene.scene().normal_restitution, bin + 1), pairs, cxy));
    }
  evidence.notes.emplace_back(
      "C_xy is divided by (<u_x^2><c_y^2>)^(1/2): <u_x c_y>, which eq. 3.4 divides by, vanishes at the centre plane, "
      "where "
      "the printed form is a ratio of two small numbers.");
  evidence.notes.emplace_back(correlation_definitions);
  return evidence;
}

}  // namespace gpf
