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

Series line(std::string label) { return {.label = std::move(label), .style = SeriesStyle::line}; }

/// The plot of both claims: deviations from the reference in per cent.
struct DeviationPlot {
  Series points{.label = "gpf, mean and standard error over replicas"};
  Series band{.label = "band of the claim", .style = SeriesStyle::band};

  void add(double nu, const std::vector<double>& values, Interval limits) {
    add_point(points, nu, values);
    points.y.back() *= 100;
    points.yerr.back() *= 100;
    band.x.push_back(nu);
    band.y.push_back(0);
    band.lower.push_back(100 * limits.lo);
    band.upper.push_back(100 * limits.hi);
  }
  [[nodiscard]] Plot plot(std::string title, std::string ylabel, Series other) const {
    return {.title = std::move(title),
            .xlabel = "area fraction",
            .ylabel = std::move(ylabel),
            .series = {band, std::move(other), points}};
  }
};

}  // namespace

Evidence estimate_eos_global(const Claim& claim, Tier tier, const SceneRecords& records) {
  Evidence evidence;
  DeviationPlot plot;
  Series fluid = line("Kolafa and Rottner");
  double largest_dense = 0;
  for (const SceneValues& scene : by_area_fraction(records)) {
    const double nu = scene.scene().area_fraction(), reference = luding_global(nu);
    const bool transition = nu > claim.parameter("transition_from") && nu < claim.parameter("transition_to");
    const double half_width = claim.tolerance_total() + (transition ? claim.parameter("transition_error") : 0);
    const std::vector<double> values = deviation(scene, reference);
    evidence.checks.push_back({.label = fmt::format("Z/Z(Luding) - 1 at nu {:.2f}", nu),
                               .values = values,
                               .band = band_about(0, half_width),
                               .x = nu});
    plot.add(nu, values, band_about(0, half_width));
    if (nu > claim.parameter("transition_from"))
      largest_dense = std::max(largest_dense, std::abs(over_replicas(values).mean));
    compare_with_kolafa_rottner(claim, tier, scene, evidence);
  }
  for (double nu = 0.01; nu < kolafa_rottner_limit; nu += 0.01) {
    fluid.x.push_back(nu);
    fluid.y.push_back(100 * (kolafa_rottner(nu) / luding_global(nu) - 1));
  }
  evidence.plot = plot.plot("Compressibility of elastic hard disks", "100 (Z/Z(Luding) - 1)", std::move(fluid));
  evidence.notes = {
      "Z is p A/(N T) from the virial of the contacts, T = kinetic energy/(N - 1), corrected to infinitely many disks.",
      "The line is Kolafa and Rottner's equation for the fluid: where it leaves zero, Luding's equation is off, not "
      "the "
      "simulation.",
      fmt::format("Above area fraction {:.2f} the largest deviation from Luding's equation is {:.2f} %.",
                  claim.parameter("transition_from"), 100 * largest_dense)};
  return evidence;
}

Evidence estimate_eos_virial(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  DeviationPlot plot;
  Series fluid = line("Kolafa and Rottner");
  const VirialCoefficient last = virial_coefficients().back();
  for (const SceneValues& scene : by_area_fraction(records)) {
    const double nu = scene.scene().area_fraction(), reference = virial_series(nu);
    // Terms left out: like a geometric series with the ratio of the last two coefficients known.
    const double ratio = last.value / virial_coefficients()[8].value * nu;
    const double tail = last.value * std::pow(nu, 9) * ratio / (1 - ratio) / reference;
    const Interval band{-claim.tolerance_total(), claim.tolerance_total() + tail};
    const std::vector<double> values = deviation(scene, reference);
    evidence.checks.push_back({.label = fmt::format("Z/Z(virial, B2 ... B10) - 1 at nu {:.2f}", nu),
                               .values = values,
                               .band = band,
                               .x = nu});
    plot.add(nu, values, band);
    fluid.x.push_back(nu);
    fluid.y.push_back(100 * (kolafa_rottner(nu) / reference - 1));
  }
  evidence.plot = plot.plot("Compressibility of elastic hard disks against the virial series", "100 (Z/Z(virial) - 1)",
                            std::move(fluid));
  evidence.notes = {
      "Z is p A/(N T) from the virial of the contacts, T = kinetic energy/(N - 1), corrected to infinitely many disks.",
      "The series ends with B10; the band's upper edge is raised by an estimate of the terms beyond, a geometric "
      "series "
      "with the ratio of B10 to B9."};
  return evidence;
}

}  // namespace gpf
