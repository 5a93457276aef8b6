// kn.wall, slip.wall, temp.wall: what the roughness of the walls does at e_n .99.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {
namespace {

constexpr double rough_wall = 0.1, smooth_wall = 0.9;

/// Channels seen at walls of more than two kinds are scans over the walls; the others only lend their curves.
bool is_wall_scan(const std::vector<SceneValues>& scan) { return scan.size() > 2; }

void add_scans_to_plot(Plot& plot, const Scans& scans, std::string_view quantity) {
  for (const auto& [nu, scan] : scans)
    if (is_wall_scan(scan))
      plot.series.push_back(points_of(fmt::format("nu {:.3g}", nu), scan, wall_restitution, quantity));
}

}  // namespace

/// Kn between smooth walls less Kn between rough ones against the area fraction (fig. 4.15 a): falls from one area
/// fraction to the next, and from `dense_from` up is at most `negligible` of what it is in the most dilute flow.
Evidence estimate_kn_wall(const Claim& claim, Tier, const SceneRecords& records) {
  const Scans scans = scans_by(wall_restitution, area_fraction, records, any_scene);
  const std::vector<SceneValues>&rough = scans.begin()->second, &smooth = std::prev(scans.end())->second;
  constexpr const char* judged = "knudsen_number_lab";
  Evidence evidence;
  evidence.plot = {.title = "Knudsen number and the walls",
                   .xlabel = "mean area fraction",
                   .ylabel = "Kn",
                   .logx = true,
                   .series = {points_of("rough walls", rough, area_fraction, judged),
                              points_of("smooth walls", smooth, area_fraction, judged)}};
  std::vector<double> most_dilute, before;
  for (const SceneValues& at_rough : rough) {
    const double nu = area_fraction(at_rough.scene());
    const SceneValues* at_smooth = find_scene(smooth, area_fraction, nu);
    if (at_smooth == nullptr) continue;
    const std::vector<double> change = difference(at_smooth->of(judged), at_rough.of(judged));
    if (most_dilute.empty())
      most_dilute = change;
    else
      evidence.checks.push_back({.label = fmt::format("nu {:.3g}: effect of the walls on Kn less that before", nu),
                                 .values = difference(change, before),
                                 .band = {-INFINITY, 0},
                                 .x = nu});
    if (nu > claim.parameter("dense_from") - 1e-6)
      evidence.checks.push_back({.label = fmt::format("nu {:.3g}: effect over that in the most dilute flow", nu),
                                 .values = combined(change, most_dilute, [](double a, double b) { return a / b; }),
                                 .band = band_about(0, claim.parameter("negligible")),
                                 .x = nu,
                                 .reference = 0});
    before = change;
    evidence.notes.push_back(fmt::format(
        "nu {:.3g}: Kn from laboratory displacements {} between rough and {} between smooth walls, a factor {:.2f}; "
        "from peculiar paths {} and {}, a factor {:.3f}.",
        nu, with_error(at_rough.of(judged)), with_error(at_smooth->of(judged)),
        std::exp(over_replicas(log_ratio(at_smooth->of(judged), at_rough.of(judged))).mean),
        with_error(at_rough.of("knudsen_number")), with_error(at_smooth->of("knudsen_number")),
        std::exp(over_replicas(log_ratio(at_smooth->of("knudsen_number"), at_rough.of("knudsen_number"))).mean)));
  }
  return evidence;
}

/// U_w/U_0 against beta_w (figs. 4.19, 4.25): grows from each wall to the next smoother one at one area fraction, and
/// also at the Knudsen number of the roughest wall, interpolated along the curves of beta_w .1 and .9. The gradient
/// dU/dy at the walls (fig. 4.20) has a maximum between the roughest and the smoothest wall, from nu `gradient_from`
/// up.
Evidence estimate_slip_wall(const Claim& claim, Tier, const SceneRecords& records) {
  const Scans scans = scans_by(area_fraction, wall_restitution, records, any_scene),
              curves = scans_by(wall_restitution, area_fraction, records, any_scene);
  Evidence evidence;
  evidence.plot = {.title = "Slip velocity", .xlabel = "beta_w", .ylabel = "U_w/U_0"};
  add_scans_to_plot(evidence.plot, scans, "slip_velocity");
  for (const auto& [nu, scan] : scans) {
    if (!is_wall_scan(scan)) continue;
    for (std::size_t k = 1; k < scan.size(); ++k)
      evidence.checks.push_back(
          {.label = fmt::format("nu {:.3g}: slip at beta_w {:.2g} less that at {:.2g}", nu,
                                wall_restitution(scan[k].scene()), wall_restitution(scan[k - 1].scene())),
           .values = difference(scan[k].of("slip_velocity"), scan[k - 1].of("slip_velocity")),
           .band = {0, INFINITY},
           .x = wall_restitution(scan[k].scene())});
    const std::vector<double> walls = numbers_of(scan, wall_restitution);
    if (nu > claim.parameter("gradient_from") - 1e-6)
      add_extremum(evidence, fmt::format("nu {:.3g}: dU/dy at beta_w", nu), walls, values_of(scan, "wall_gradient"),
                   Extremum::maximum);
    std::string raw, relative;
    for (const SceneValues& scene : scan) {
      raw += fmt::format(" {:.2g}: {},", wall_restitution(scene.scene()), with_error(scene.of("wall_gradient")));
      relative +=
          fmt::format(" {:.2g}: {},", wall_restitution(scene.scene()), with_error(scene.of("wall_gradient_relative")));
    }
    evidence.notes.push_back(
        fmt::format("nu {:.3g}, dU/dy in (g/W)^(1/2) at beta_w{} (judged); (dU/dy)/U_0 in 1/W{}.", nu, raw, relative));

    const double kn = over_replicas(scan.front().of("knudsen_number_lab")).mean;
    std::vector<double> below = scan.front().of("slip_velocity");
    std::transform(below.begin(), below.end(), below.begin(), [](double slip) { return std::log(slip); });
    double below_wall = walls.front();
    for (const auto& [wall, curve] : curves) {
      if (std::abs(wall - rough_wall) > 1e-6 && std::abs(wall - smooth_wall) > 1e-6) continue;
      const std::vector<double> slip =
          log_interpolated(values_of(curve, "knudsen_number_lab"), values_of(curve, "slip_velocity"), kn);
      evidence.checks.push_back(
          {.label = fmt::format("Kn {:.2g}: ln slip at beta_w {:.2g} less that at {:.2g}", kn, wall, below_wall),
           .values = difference(slip, below),
           .band = {0, INFINITY},
           .x = wall});
      below = slip;
      below_wall = wall;
    }
  }
  return evidence;
}

/// T_w against beta_w (fig. 4.29 a), in m g W: has a minimum, and the parabola through the walls -.5, 0 and .3 has it
/// within +-tolerance of 0. dT/dy at the walls (b), in m g: has a maximum at the denser of the two area fractions.
Evidence estimate_temp_wall(const Claim& claim, Tier, const SceneRecords& records) {
  const Scans scans = scans_by(area_fraction, wall_restitution, records, any_scene);
  Evidence evidence;
  evidence.plot = {.title = "Temperature at the walls", .xlabel = "beta_w", .ylabel = "T_w, m g W"};
  add_scans_to_plot(evidence.plot, scans, "wall_temperature");
  for (const auto& [nu, scan] : scans) {
    const std::vector<double> walls = numbers_of(scan, wall_restitution);
    add_extremum(evidence, fmt::format("nu {:.3g}: T_w at beta_w", nu), walls, values_of(scan, "wall_temperature"),
                 Extremum::minimum);
    if (&scan == &scans.rbegin()->second)
      add_extremum(evidence, fmt::format("nu {:.3g}: dT/dy at beta_w", nu), walls,
                   values_of(scan, "wall_temperature_gradient"), Extremum::maximum);
    const SceneValues *a = find_scene(scan, wall_restitution, -0.5), *b = find_scene(scan, wall_restitution, 0),
                      *c = find_scene(scan, wall_restitution, 0.3);
    if (a != nullptr && b != nullptr && c != nullptr) {
      const std::vector<double> fall = difference(b->of("wall_temperature"), a->of("wall_temperature")),
                                rise = difference(c->of("wall_temperature"), b->of("wall_temperature"));
      // Slopes fall/.5 at -.25 and rise/.3 at .15; the vertex is where the line through them vanishes.
      evidence.checks.push_back({.label = fmt::format("nu {:.3g}: beta_w of the smallest T_w", nu),
                                 .values = combined(fall, rise,
                                                    [](double f, double r) {
                                                      const double s = f / 0.5, t = r / 0.3;
                                                      return -0.25 - s * 0.4 / (t - s);
                                                    }),
                                 .band = band_about(0, claim.tolerance_total()),
                                 .reference = 0});
    }
    std::string gradients;
    for (const SceneValues& scene : scan)
      gradients +=
          fmt::format(" {:.2g}: {} and {},", wall_restitution(scene.scene()), with_error(scene.of("wall_temperature")),
                      with_error(scene.of("wall_temperature_gradient")));
    evidence.notes.push_back(fmt::format("nu {:.3g}, T_w and dT/dy at beta_w{}.", nu, gradients));
  }
  return evidence;
}

}  // namespace gpf
