// skew.density: the skewness of P(u_x) at the centre against the area fraction (thesis sec. 3.2.3, fig. 3.28).
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {

// skew.density. Size of the skewness of u_x at the centre against the mean area fraction (fig. 3.28): it grows from
// each flow to the next up to `peak`, falls from each to the next up to `constant_from`, and in the flows whose centre
// is denser than `local_from` it stays within the tolerance of their mean. No units.
Evidence estimate_skewness_density(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const double peak = claim.parameter("peak"), constant_from = claim.parameter("constant_from"),
               local_from = claim.parameter("local_from");
  const auto at_most = [](double a, double b) { return a <= b * (1 + 1e-6); };
  constexpr Interval positive{0, INFINITY}, negative{-INFINITY, 0};
  Evidence evidence;
  Series instantaneous{.label = "about the instantaneous mean of the bin"},
      long_time{.label = "about the long-time mean"};
  std::vector<const SceneValues*> plugs;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const SceneValues& scene = scenes[k];
    const int centre = scene.half() - 1;
    const double nu = scene.scene().area_fraction();
    const std::vector<double> size = departure(scene, skewness_x, centre);
    add_point(instantaneous, nu, moment(scene, skewness_x, centre));
    add_point(long_time, nu, moment(scene, skewness_x_long_time, centre));
    const double local = over_replicas(scene.mirrored("area_fraction", centre)).mean;
    if (local > local_from) plugs.push_back(&scene);
    evidence.notes.push_back(
        fmt::format("nu {:.3g}: skewness of u_x at the centre {:.3f} ({:.3f} about the long-time mean), local area "
                    "fraction {:.3f}.",
                    nu, instantaneous.y.back(), long_time.y.back(), local));
    if (k == 0) continue;
    const double before = scenes[k - 1].scene().area_fraction();
    const std::vector<double> step = difference(size, departure(scenes[k - 1], skewness_x, centre));
    const bool grows = at_most(nu, peak), falls = at_most(peak, before) && at_most(nu, constant_from);
    if (grows || falls)
      evidence.checks.push_back(
          {.label = fmt::format("size of the skewness at nu {:.3g} less that at nu {:.3g}", nu, before),
           .values = step,
           .band = grows ? positive : negative,
           .x = nu});
  }
  for (const SceneValues* scene : plugs) {
    const int centre = scene->half() - 1;
    std::vector<double> values = moment(*scene, skewness_x, centre);
    for (std::size_t r = 0; r < values.size(); ++r) {
      double mean = 0;
      for (const SceneValues* other : plugs)
        mean += moment(*other, skewness_x, centre).at(r) / static_cast<double>(plugs.size());
      values[r] -= mean;
    }
    evidence.checks.push_back(
        {.label = fmt::format("nu {:.3g}: skewness less the mean of flows with local area fraction above {:.3g}",
                              scene->scene().area_fraction(), local_from),
         .values = std::move(values),
         .band = band_about(0, claim.tolerance_total()),
         .x = scene->scene().area_fraction()});
  }
  evidence.plot = {.title = "Skewness of u_x at the centre",
                   .xlabel = "mean area fraction",
                   .ylabel = "skewness of u_x",
                   .series = {std::move(instantaneous), std::move(long_time)}};
  for (std::string& note : notes_on_definitions(scenes)) evidence.notes.push_back(std::move(note));
  return evidence;
}

}  // namespace gpf
