// eos.global, eos.virial: the compressibility of elastic disks against equations of state.
#include "gpf/theory/equation_of_state.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gpf/io/record.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// Z/reference - 1 of the infinite system, one per replica.
std::vector<double> deviation(const SceneValues& scene, double reference) {
  std::vector<double> values = scene.of("compressibility");
  for (double& z : values) z = z / reference - 1;
  return values;
}

/// Error of the mean of Z by the block errors of the replicas: with 256 blocks each it is known far better than the
/// scatter of a few replicas could tell.
double own_error(const SceneValues& scene) {
  double squared = 0;
  for (const Record& record : scene.records())
    squared += std::pow(quantities_of(record).at("compressibility").values.front().error, 2);
  return std::sqrt(squared) / static_cast<double>(scene.replicas());
}

/// The stated acceptance of the engine: the mean within 3 of its own errors and 0.1 % of Kolafa and Rottner. Tiers with
/// enough data also show that the true value, not only the mean, lies within the 0.1 %.
void compare_with_kolafa_rottner(const Claim& claim, Tier tier, const SceneValues& scene, Evidence& evidence) {
  const double nu = scene.scene().area_fraction();
  if (nu < claim.parameter("kolafa_rottner_from") - 0.005 || nu > claim.parameter("kolafa_rottner_to") + 0.005) return;
  const double reference = kolafa_rottner(nu), margin = claim.parameter("kolafa_rottner_margin");
  const std::vector<double> values = deviation(scene, reference);
  const double mean = over_replicas(values).mean;
  const double sigmas = claim.parameter("own_errors"), error = own_error(scene) / reference;
  evidence.checks.push_back({.label = fmt::format("mean of Z/Z(Kolafa-Rottner) - 1 at nu {:.2f}", nu),
                             .values = {mean},
                             .band = band_about(0, margin),
                             .exact = true,
                             .x = nu});
  evidence.checks.push_back({.label = fmt::format("Z - Z(Kolafa-Rottner) in units of its own error at nu {:.2f}", nu),
                             .values = {mean / error},
                             .band = band_about(0, sigmas),
                             .exact = true,
                             .x = nu});
  if (tier == Tier::quick) return;
  evidence.checks.push_back({.label = fmt::format("Z/Z(Kolafa-Rottner) - 1 at nu {:.2f}", nu),
                             .values = values,
                             .band = band_about(0, margin),
                             .x = nu});
}

/// The plot of both claims: deviations from the reference in per cent.
struct DeviationPlot {
  Series points{.label = "gpf, mean and standard error over replicas"};
  Series band{.label = "band of the claim", .style = SeriesStyle::band};
  Series fluid{.label = "Kolafa and Rottner", .style = SeriesStyle::line};

  void add_measured(double nu, const std::vector<double>& values) {
    add_point(points, nu, values);
    points.y.back() *= 100;
    points.yerr.back() *= 100;
  }
  void add_reference(double nu, double reference, Interval limits) {
    band.x.push_back(nu);
    band.y.push_back(0);
    band.lower.push_back(100 * limits.lo);
    band.upper.push_back(100 * limits.hi);
    if (nu > kolafa_rottner_limit) return;
    fluid.x.push_back(nu);
    fluid.y.push_back(100 * (kolafa_rottner(nu) / reference - 1));
  }
  [[nodiscard]] Plot plot(std::string title, std::string ylabel) const {
    return {.title = std::move(title),
            .xlabel = "area fraction",
            .ylabel = std::move(ylabel),
            .series = {band, fluid, points}};
  }
};

/// Calls visit(nu) in steps fine enough for a curve, from 0 to beyond the densest scene.
template <class F>
void along_density(const std::vector<SceneValues>& scenes, F&& visit) {
  const double last = scenes.empty() ? 0 : scenes.back().scene().area_fraction() + 0.015;
  for (int k = 1; 0.0025 * k < last; ++k) visit(0.0025 * k);
}

/// Half width of the band about Luding's equation.
double luding_margin(const Claim& claim, double nu) {
  const bool transition = nu > claim.parameter("transition_from") && nu < claim.parameter("transition_to");
  return claim.tolerance_total() + (transition ? claim.parameter("transition_error") : 0);
}

/// The band about the virial series. Terms left out: like a geometric series with the ratio of the last two known.
Interval virial_band(const Claim& claim, double nu) {
  const auto& b = virial_coefficients();
  const double ratio = b[9].value / b[8].value * nu;
  const double tail = b[9].value * std::pow(nu, 9) * ratio / (1 - ratio) / virial_series(nu);
  return {-claim.tolerance_total(), claim.tolerance_total() + tail};
}

const char* const definition =
    "Z is p A/(N T) from the virial of the contacts, T = kinetic energy/(N - 1), corrected to infinitely many disks.";

}  // namespace

Evidence estimate_eos_global(const Claim& claim, Tier tier, const SceneRecords& records) {
  Evidence evidence;
  DeviationPlot plot;
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  for (const SceneValues& scene : scenes) {
    const double nu = scene.scene().area_fraction();
    const std::vector<double> values = deviation(scene, luding_global(nu));
    evidence.checks.push_back({.label = fmt::format("Z/Z(Luding) - 1 at nu {:.2f}", nu),
                               .values = values,
                               .band = band_about(0, luding_margin(claim, nu)),
                               .x = nu});
    plot.add_measured(nu, values);
    compare_with_kolafa_rottner(claim, tier, scene, evidence);
  }
  along_density(scenes,
                [&](double nu) { plot.add_reference(nu, luding_global(nu), band_about(0, luding_margin(claim, nu))); });
  evidence.plot = plot.plot("Compressibility of elastic hard disks", "100 (Z/Z(Luding) - 1)");
  evidence.notes = {definition,
                    "The line is Kolafa and Rottner's equation for the fluid: where it leaves zero, Luding's equation "
                    "is off, not the simulation."};
  return evidence;
}

Evidence estimate_eos_virial(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  DeviationPlot plot;
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  for (const SceneValues& scene : scenes) {
    const double nu = scene.scene().area_fraction();
    const std::vector<double> values = deviation(scene, virial_series(nu));
    evidence.checks.push_back({.label = fmt::format("Z/Z(virial, B2 ... B10) - 1 at nu {:.2f}", nu),
                               .values = values,
                               .band = virial_band(claim, nu),
                               .x = nu});
    plot.add_measured(nu, values);
  }
  along_density(scenes, [&](double nu) { plot.add_reference(nu, virial_series(nu), virial_band(claim, nu)); });
  evidence.plot = plot.plot("Compressibility of elastic hard disks against the virial series", "100 (Z/Z(virial) - 1)");
  evidence.notes = {definition,
                    "The series ends with B10; the band's upper edge is raised by an estimate of the terms beyond, a "
                    "geometric series with the ratio of B10 to B9."};
  return evidence;
}

}  // namespace gpf
