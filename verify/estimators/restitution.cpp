// kn.restitution, slip.restitution, temp.restitution: what the restitution of pairs does between rough walls.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {
namespace {

constexpr double nearly_elastic = 0.99;

struct Reading {
  const char *quantity, *name;
  bool judged;
};

}  // namespace

/// Kn against e_n between rough walls (fig. 4.14 a), from laboratory displacements as in the text, on the axis of claim
/// kn.wall: the change from e_n .99 is at most `negligible` of the most that the walls do, at the lowest area fraction.
Evidence estimate_kn_restitution(const Claim& claim, Tier, const SceneRecords& records) {
  constexpr const char* judged = "knudsen_number_lab";
  Evidence evidence;
  evidence.plot = {.title = "Knudsen number between rough walls", .xlabel = "e_n", .ylabel = "Kn", .logy = true};
  const Scans walls = scans_by(normal_restitution, area_fraction, records, smooth_walls);
  std::vector<double> of_walls;
  for (const auto& [nu, scan] : scans_by(area_fraction, normal_restitution, records, rough_walls)) {
    const SceneValues* elastic = find_scene(scan, normal_restitution, nearly_elastic);
    const SceneValues* between_smooth = walls.empty() ? nullptr : find_scene(walls.begin()->second, area_fraction, nu);
    if (elastic == nullptr || between_smooth == nullptr) continue;
    if (of_walls.empty()) of_walls = difference(between_smooth->of(judged), elastic->of(judged));
    evidence.plot.series.push_back(points_of(fmt::format("nu {:.2g}", nu), scan, normal_restitution, judged));
    std::string factors;
    for (const SceneValues& scene : scan) {
      if (&scene == elastic) continue;
      const double restitution = normal_restitution(scene.scene());
      evidence.checks.push_back(
          {.label = fmt::format("nu {:.2g}, e_n {:.2g}: change of Kn over the most that walls do", nu, restitution),
           .values = combined(difference(scene.of(judged), elastic->of(judged)), of_walls,
                              [](double change, double most) { return change / most; }),
           .band = band_about(0, claim.parameter("negligible")),
           .x = restitution,
           .reference = 0});
      const auto factor = [&](const char* kn) {
        return std::exp(over_replicas(log_ratio(scene.of(kn), elastic->of(kn))).mean);
      };
      factors += fmt::format(", e_n {:.2g}: {:.2f} ({:.2f})", restitution, factor(judged), factor("knudsen_number"));
    }
    evidence.notes.push_back(fmt::format(
        "nu {:.2g}: Kn {} at e_n .99; as a factor (that of Kn from peculiar paths){}; walls of beta_w .9: {:.2f}.", nu,
        with_error(elastic->of(judged)), factors,
        std::exp(over_replicas(log_ratio(between_smooth->of(judged), elastic->of(judged))).mean)));
  }
  return evidence;
}

/// U_w/U_0 and (dU/dy)/U_0 at the walls against e_n (figs. 4.17, 4.18). "Hardly depends": ln of the quantity at e_n
/// over that at e_n .99, in units of what sec. 4.2.2 calls a significant effect at the same area fraction - ln of the
/// quantity between smooth walls (beta_w .9) over that between rough ones (.1). The part has to stay within
/// +-`small_part`.
Evidence estimate_slip_restitution(const Claim& claim, Tier, const SceneRecords& records) {
  const Scans scans = scans_by(area_fraction, normal_restitution, records, rough_walls),
              walls = scans_by(normal_restitution, area_fraction, records, smooth_walls);
  constexpr Reading readings[] = {{"slip_velocity", "slip", true},
                                  {"wall_gradient_relative", "(dU/dy)/U_0", true},
                                  {"wall_gradient_relative_extrapolated", "(dU/dy)/U_0 at the wall", false},
                                  {"wall_gradient", "dU/dy", false}};
  Evidence evidence;
  evidence.plot = {.title = "Slip velocity between rough walls", .xlabel = "e_n", .ylabel = "U_w/U_0", .logy = true};
  for (const auto& [nu, scan] : scans) {
    const SceneValues* elastic = find_scene(scan, normal_restitution, nearly_elastic);
    const SceneValues* between_smooth = walls.empty() ? nullptr : find_scene(walls.begin()->second, area_fraction, nu);
    if (elastic == nullptr || between_smooth == nullptr) continue;
    evidence.plot.series.push_back(
        points_of(fmt::format("nu {:.2g}", nu), scan, normal_restitution, readings[0].quantity));
    for (const Reading& reading : readings) {
      const std::vector<double> at_elastic = elastic->of(reading.quantity),
                                of_walls = log_ratio(between_smooth->of(reading.quantity), at_elastic);
      std::string seen;
      for (const SceneValues& scene : scan) {
        if (&scene == elastic) continue;
        const double restitution = normal_restitution(scene.scene());
        const std::vector<double> effect = log_ratio(scene.of(reading.quantity), at_elastic);
        seen += fmt::format(", e_n {:.2g}: {:+.1f} %", restitution, 100 * std::expm1(over_replicas(effect).mean));
        if (!reading.judged) continue;
        evidence.checks.push_back({.label = fmt::format("nu {:.2g}, e_n {:.2g}: effect on {} over that of the walls",
                                                        nu, restitution, reading.name),
                                   .values = combined(effect, of_walls, [](double a, double b) { return a / b; }),
                                   .band = band_about(0, claim.parameter("small_part")),
                                   .x = restitution,
                                   .reference = 0});
      }
      evidence.notes.push_back(fmt::format("nu {:.2g}, {}: {} at e_n .99{}; smooth walls: {:+.0f} %.", nu, reading.name,
                                           with_error(at_elastic), seen,
                                           100 * std::expm1(over_replicas(of_walls).mean)));
    }
  }
  return evidence;
}

/// |T_w(e_n) - T_w(.99)| and the same of the temperature gradient at the walls (fig. 4.28): larger at each area
/// fraction from `dense_from` up than at each one up to `dilute_to`. Units m g W and m g.
Evidence estimate_temp_restitution(const Claim& claim, Tier, const SceneRecords& records) {
  const Scans scans = scans_by(area_fraction, normal_restitution, records, rough_walls);
  const double dilute_to = claim.parameter("dilute_to"), dense_from = claim.parameter("dense_from");
  Evidence evidence;
  evidence.plot = {.title = "Temperature at rough walls", .xlabel = "e_n", .ylabel = "T_w, m g W"};
  struct Effect {
    double nu, restitution;
    std::vector<double> change;
  };
  for (const Reading& reading :
       {Reading{"wall_temperature", "T_w", true}, Reading{"wall_temperature_gradient", "dT/dy", true},
        Reading{"wall_temperature_gradient_extrapolated", "dT/dy extrapolated to the wall", false}}) {
    std::vector<Effect> effects;
    for (const auto& [nu, scan] : scans) {
      const SceneValues* elastic = find_scene(scan, normal_restitution, nearly_elastic);
      if (elastic == nullptr) continue;
      const std::vector<double> at_elastic = elastic->of(reading.quantity);
      if (std::string_view(reading.name) == "T_w")
        evidence.plot.series.push_back(
            points_of(fmt::format("nu {:.2g}", nu), scan, normal_restitution, reading.quantity));
      for (const SceneValues& scene : scan) {
        if (&scene == elastic) continue;
        effects.push_back({nu, normal_restitution(scene.scene()), difference(scene.of(reading.quantity), at_elastic)});
        evidence.notes.push_back(fmt::format("nu {:.2g}, e_n {:.2g}: {} changes by {} from {} at e_n .99.", nu,
                                             effects.back().restitution, reading.name,
                                             with_error(effects.back().change), with_error(at_elastic)));
      }
    }
    if (!reading.judged) continue;
    for (const Effect& dense : effects)
      for (const Effect& dilute : effects) {
        if (dense.nu < dense_from - 1e-6 || dilute.nu > dilute_to + 1e-6) continue;
        if (dense.restitution != dilute.restitution) continue;
        evidence.checks.push_back({.label = fmt::format("e_n {:.2g}: effect on {} at nu {:.2g} less that at nu {:.2g}",
                                                        dense.restitution, reading.name, dense.nu, dilute.nu),
                                   .values = combined(dense.change, dilute.change,
                                                      [](double a, double b) { return std::abs(a) - std::abs(b); }),
                                   .band = {0, INFINITY},
                                   .x = dense.nu});
      }
  }
  return evidence;
}

}  // namespace gpf
