// vdf.gauss.smooth: the kurtosis of both velocity components in every bin.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

struct Component {
  const char *quantity, *name;
};
constexpr Component components[] = {
    {"kurtosis_x", "u_x"}, {"kurtosis_y", "u_y"}, {"kurtosis_x_long_time", "u_x about the long-time mean"}};

}  // namespace

Evidence estimate_kurtosis(const Claim& claim, Tier, const SceneRecords& records) {
  constexpr double gaussian = 3;
  const Interval band = band_about(gaussian, claim.tolerance_total());
  Evidence evidence;
  evidence.plot = {.title = "Kurtosis of the fluctuation velocities",
                   .xlabel = "y/W (left half: u_x; right half, mirrored: u_y)",
                   .ylabel = "kurtosis",
                   .xrange = {{0, 1}},
                   .series = {{.label = "band about a Gaussian",
                               .style = SeriesStyle::band,
                               .x = {0, 1},
                               .y = {gaussian, gaussian},
                               .lower = {band.lo, band.lo},
                               .upper = {band.hi, band.hi}}}};
  for (const SceneValues& scene : by_area_fraction(records)) {
    const double nu = scene.scene().area_fraction();
    Series points{.label = fmt::format("nu {:.3g}", nu)};
    for (const Component& component : components)
      for (int bin = 0; bin < scene.half(); ++bin) {
        const std::vector<double> values = scene.mirrored(component.quantity, bin);
        evidence.checks.push_back({.label = fmt::format("nu {:.3g}, bins {} and {}: kurtosis of {}", nu, bin + 1,
                                                        scene.bins() - bin, component.name),
                                   .values = values,
                                   .band = band,
                                   .x = scene.centre(bin),
                                   .reference = gaussian});
        if (&component == &components[0]) add_point(points, scene.centre(bin), values);
        if (&component == &components[1]) add_point(points, 1 - scene.centre(bin), values);
      }
    double between = 0;
    for (int bin = 0; bin < scene.half(); ++bin)
      between = std::max(between, std::abs(over_replicas(scene.mirrored("kurtosis_x", bin)).mean -
                                           over_replicas(scene.mirrored("kurtosis_x_long_time", bin)).mean));
    evidence.notes.push_back(fmt::format(
        "nu {:.3g}: kurtosis of u_x {:.3f} next to the wall and {:.3f} at the centre, of u_y {:.3f} and {:.3f}; "
        "the two means that can be subtracted differ by at most {:.3f} in any bin.",
        nu, over_replicas(scene.mirrored("kurtosis_x", 0)).mean,
        over_replicas(scene.mirrored("kurtosis_x", scene.half() - 1)).mean,
        over_replicas(scene.mirrored("kurtosis_y", 0)).mean,
        over_replicas(scene.mirrored("kurtosis_y", scene.half() - 1)).mean, between));
    evidence.plot.series.push_back(std::move(points));
  }
  evidence.notes.push_back(
      "u is taken about the instantaneous mean of its bin (thesis eq. 2.10); about the long-time mean it is checked "
      "too. "
      "The bins y and W - y are averaged.");
  return evidence;
}

}  // namespace gpf
