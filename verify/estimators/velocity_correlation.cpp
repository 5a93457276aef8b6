// cxx.elastic, cxx.plug: how the velocities of the disks of a bin depend on each other, at moderate density.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verify/estimators/correlation_windows.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf {

/// Figs. 3.31a, 3.32a: C_xx and C_yy vanish. Every bin, four windows of distance, both means.
Evidence estimate_elastic_correlations(const Claim& claim, Tier, const SceneRecords& records) {
  const Interval band = band_about(0, claim.tolerance_total());
  Evidence evidence;
  evidence.plot = correlation_plot("Velocity correlations of nearly elastic disks", "C_xx, C_yy");
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
      for (const VelocityCorrelation& function : {cxx, cxx_long_time, cyy})
        for (const DistanceWindow& window :
             {DistanceWindow{1, 1.5}, DistanceWindow{1.5, 3}, DistanceWindow{3, 6}, DistanceWindow{6, 12}})
          evidence.checks.push_back(
              {.label = fmt::format("{}, bins {} and {}: {} at {} to {} d", label_of(scene.scene()), bin + 1,
                                    scene.bins() - bin, function.name, window.from, window.to),
               .values = mean_in(window, function, pairs),
               .band = band,
               .x = (window.from + window.to) / 2,
               .reference = 0});
      if (bin + 1 == scene.half() || bin == 0) {
        evidence.plot.series.push_back(correlation_series(fmt::format("C_xx, bin {}", bin + 1), pairs, cxx));
        evidence.plot.series.push_back(correlation_series(fmt::format("C_yy, bin {}", bin + 1), pairs, cyy));
        evidence.notes.push_back(fmt::format(
            "{}, bin {}: eq. 2.10 forces a mean of {:.4f} upon C_xx. At 1 to 3 d C_xx {}, about the long-time mean {}, "
            "C_yy {}.",
            label_of(scene.scene()), bin + 1,
            over_replicas(per_replica(pairs.size(), [&](auto r) { return pairs[r].forced_offset(); })).mean,
            text_of(mean_in(near_window, cxx, pairs)), text_of(mean_in(near_window, cxx_long_time, pairs)),
            text_of(mean_in(near_window, cyy, pairs))));
      }
    }
  }
  evidence.notes.emplace_back(correlation_definitions);
  return evidence;
}

/// Figs. 3.31b, 3.32b, 3.36b: at 1 to 3 d C_xx and C_yy are larger in the plug (centre) than in bin 5, and there no
/// smaller than next to the wall; at 10 to 12 d C_xx of the plug is negative.
Evidence estimate_plug_correlations(const Claim&, Tier, const SceneRecords& records) {
  const Interval positive{0, INFINITY}, negative{-INFINITY, 0};
  Evidence evidence;
  evidence.plot = correlation_plot("Velocity correlations with a plug", "C_xx, C_yy");
  for (const auto& [name, replicas] : records) {
    const SceneValues scene(name, replicas);
    const std::string label = label_of(scene.scene());
    const std::string walls = fmt::format("beta_w {:.1f}", scene.scene().wall_tangential_restitution[Wall::lower]);
    const int centre = scene.half() - 1, shear = scene.half() / 2;
    const std::vector<PairFunctions> plug = pair_functions(scene, centre), layer = pair_functions(scene, shear),
                                     wall = pair_functions(scene, 0);
    for (const VelocityCorrelation& function : {cxx, cyy}) {
      const std::vector<double> strong = mean_in(near_window, function, plug);
      evidence.checks.push_back({.label = fmt::format("{}: {} at 1 to 3 d in the plug", label, function.name),
                                 .values = strong,
                                 .band = positive});
      for (const auto* outside : {&layer, &wall})
        evidence.checks.push_back({.label = fmt::format("{}: {} at 1 to 3 d in the plug less |C| of bin {}", label,
                                                        function.name, outside == &wall ? 1 : shear + 1),
                                   .values = difference(strong, magnitude(mean_in(near_window, function, *outside))),
                                   .band = positive});
      evidence.notes.push_back(
          fmt::format("{}: {} at 1 to 3 d: {} in the plug, {} in bin {}, {} in bin 1; at 10 to 12 d in "
                      "the plug {}.",
                      label, function.name, text_of(strong), text_of(mean_in(near_window, function, layer)), shear + 1,
                      text_of(mean_in(near_window, function, wall)), text_of(mean_in(far_window, function, plug))));
    }
    evidence.checks.push_back({.label = label + ": C_xx at 10 to 12 d in the plug",
                               .values = mean_in(far_window, cxx, plug),
                               .band = negative});
    evidence.notes.push_back(fmt::format(
        "{}: about the long-time mean C_xx of the plug is {} at 1 to 3 d and {} at 10 to 12 d: the plug drifts "
        "and sloshes as one piece; of bin {} {} and {}.",
        label, text_of(mean_in(near_window, cxx_long_time, plug)), text_of(mean_in(far_window, cxx_long_time, plug)),
        shear + 1, text_of(mean_in(near_window, cxx_long_time, layer)),
        text_of(mean_in(far_window, cxx_long_time, layer))));
    evidence.plot.series.push_back(correlation_series("C_xx, plug, " + walls, plug, cxx));
    evidence.plot.series.push_back(correlation_series("C_yy, plug, " + walls, plug, cyy));
    evidence.plot.series.push_back(correlation_series(fmt::format("C_xx, bin {}, ", shear + 1) + walls, layer, cxx));
  }
  evidence.notes.emplace_back(correlation_definitions);
  return evidence;
}

}  // namespace gpf
