// temp.density, temp.knudsen: temperatures against the area fraction and the Knudsen number.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {

/// T against the area fraction, in m g W. Smooth walls (fig. 4.27 a): T in bins 1, 5 and 9 falls from each area
/// fraction to the next. Rough walls: T_w (bin 1) and dT/dy at the walls (fig. 4.30), and above e_n `profiles_from` T
/// at the centre (fig. 4.27 b), have a maximum in between.
Evidence estimate_temp_density(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = {
      .title = "Temperature at the walls", .xlabel = "mean area fraction", .ylabel = "T_w, m g W", .logx = true};
  const auto temperatures = [](const std::vector<SceneValues>& scan, int bin) {
    std::vector<std::vector<double>> values;
    for (const SceneValues& scene : scan) values.push_back(scene.mirrored("granular_temperature", bin));
    return values;
  };
  for (const auto& [restitution, scan] : scans_by(normal_restitution, area_fraction, records, smooth_walls)) {
    evidence.plot.series.push_back(
        points_of(fmt::format("smooth walls, e_n {:.2g}", restitution), scan, area_fraction, "wall_temperature"));
    for (const int bin : {0, scan.front().half() / 2, scan.front().half() - 1}) {
      const std::vector<std::vector<double>> values = temperatures(scan, bin);
      for (std::size_t k = 1; k < scan.size(); ++k)
        evidence.checks.push_back(
            {.label =
                 fmt::format("smooth walls, e_n {:.2g}, bin {}: T at nu {:.3g} less that at nu {:.3g}", restitution,
                             bin + 1, area_fraction(scan[k].scene()), area_fraction(scan[k - 1].scene())),
             .values = difference(values[k], values[k - 1]),
             .band = {-INFINITY, 0},
             .x = area_fraction(scan[k].scene())});
    }
  }
  for (const auto& [restitution, scan] : scans_by(normal_restitution, area_fraction, records, rough_walls)) {
    const std::string walls = fmt::format("rough walls, e_n {:.2g}", restitution);
    evidence.plot.series.push_back(points_of(walls, scan, area_fraction, "wall_temperature"));
    const std::vector<double> nu = numbers_of(scan, area_fraction);
    const auto judge = [&](const std::string& what, const std::vector<std::vector<double>>& values) {
      add_extremum(evidence, fmt::format("{}: {} at nu", walls, what), nu, values, Extremum::maximum);
    };
    judge("T_w", values_of(scan, "wall_temperature"));
    judge("dT/dy", values_of(scan, "wall_temperature_gradient"));
    if (restitution > claim.parameter("profiles_from"))
      judge("T at the centre", temperatures(scan, scan.front().half() - 1));
    std::string seen;
    for (const SceneValues& scene : scan)
      seen += fmt::format(" {:.2g}: {}, {}, {}, {},", area_fraction(scene.scene()),
                          with_error(scene.of("wall_temperature")),
                          with_error(scene.mirrored("granular_temperature", scene.half() - 1)),
                          with_error(scene.of("wall_temperature_gradient")),
                          with_error(scene.of("wall_temperature_gradient_extrapolated")));
    evidence.notes.push_back(
        fmt::format("{}: T_w, T at the centre, dT/dy and dT/dy extrapolated to the wall at nu{}.", walls, seen));
  }
  return evidence;
}

/// T_w (in m g W) and dT/dy at the walls (in m g) against Kn between rough walls (fig. 4.31). Above `high_from` T_w
/// departs from the line between the first and the last point, at each point between, by at most `departure`; dT/dy
/// falls from one point to the next from its maximum on, and changes by at most `constant_part` of that fall above
/// `constant_from`.
Evidence estimate_temp_knudsen(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = {.title = "Temperature at rough walls", .xlabel = "Kn", .ylabel = "T_w, m g W"};
  for (const auto& [restitution, scan] : scans_by(normal_restitution, area_fraction, records, any_scene)) {
    const std::string at = fmt::format("e_n {:.2g}", restitution);
    evidence.plot.series.push_back(over_knudsen(at, scan, "wall_temperature"));
    const std::vector<const SceneValues*> high = between_knudsen(scan, claim.parameter("high_from"), INFINITY);
    for (std::size_t k = 1; k + 1 < high.size(); ++k) {
      const double part = (mean_knudsen(*high[k]) - mean_knudsen(*high.back())) /
                          (mean_knudsen(*high.front()) - mean_knudsen(*high.back()));
      const std::vector<double> line =
          combined(high.front()->of("wall_temperature"), high.back()->of("wall_temperature"),
                   [part](double first, double last) { return part * first + (1 - part) * last; });
      evidence.checks.push_back(
          {.label = fmt::format("{}: T_w at Kn {:.2g} over the straight line, less 1", at, mean_knudsen(*high[k])),
           .values = combined(high[k]->of("wall_temperature"), line, [](double t, double l) { return t / l - 1; }),
           .band = band_about(0, claim.parameter("departure")),
           .x = mean_knudsen(*high[k]),
           .reference = 0});
    }
    const auto steepest = std::max_element(scan.begin(), scan.end(), [](const SceneValues& a, const SceneValues& b) {
      return over_replicas(a.of("wall_temperature_gradient")).mean <
             over_replicas(b.of("wall_temperature_gradient")).mean;
    });
    const std::vector<double> largest = steepest->of("wall_temperature_gradient"),
                              smallest = scan.front().of("wall_temperature_gradient");
    const std::vector<const SceneValues*> constant = between_knudsen(scan, claim.parameter("constant_from"), INFINITY);
    if (!constant.empty())
      evidence.checks.push_back(
          {.label = fmt::format("{}: change of dT/dy above Kn {:.2g} over its whole fall", at,
                                mean_knudsen(*constant.back())),
           .values = combined(difference(constant.back()->of("wall_temperature_gradient"), smallest),
                              difference(largest, smallest), [](double a, double b) { return a / b; }),
           .band = band_about(0, claim.parameter("constant_part")),
           .reference = 0});
    std::string values;
    for (auto scene = scan.begin(); scene != scan.end(); ++scene) {
      values += fmt::format(" {:.2g}: {} and {},", mean_knudsen(*scene), with_error(scene->of("wall_temperature")),
                            with_error(scene->of("wall_temperature_gradient")));
      if (scene >= steepest || mean_knudsen(*scene) > claim.parameter("constant_from")) continue;
      const SceneValues& denser = *(scene + 1);
      evidence.checks.push_back(
          {.label = fmt::format("{}: dT/dy at Kn {:.2g} less that at Kn {:.2g}", at, mean_knudsen(*scene),
                                mean_knudsen(denser)),
           .values = difference(scene->of("wall_temperature_gradient"), denser.of("wall_temperature_gradient")),
           .band = {-INFINITY, 0},
           .x = mean_knudsen(*scene)});
    }
    evidence.notes.push_back(fmt::format("{}: T_w and dT/dy at Kn{} in falling order of Kn.", at, values));
  }
  return evidence;
}

}  // namespace gpf
