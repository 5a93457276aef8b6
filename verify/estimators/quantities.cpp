// Checks that the claim file itself spells out, of quantities that every run measures.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "gpf/base/error.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"
#include "verify/quantity_expression.hpp"

namespace gpf {
namespace {

/// About the reference +- the tolerance, relative where the claim says so; or between the bounds, each that much wider.
Interval band_of(const ClaimCheck& check, const Claim& claim) {
  const double tolerance = claim.tolerance_total();
  const auto width = [&](double about) {
    return claim.tolerance_unit == "relative" ? tolerance * std::abs(about) : tolerance;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (check.reference) return band_about(*check.reference, width(*check.reference));
  return {check.least ? *check.least - width(*check.least) : -infinity,
          check.most ? *check.most + width(*check.most) : infinity};
}

}  // namespace

Evidence estimate_quantities(const Claim& claim, Tier, const SceneRecords& records) {
  if (claim.checks.empty())
    throw InputError(fmt::format("claim '{}' has no [[check]]", claim.id), "its estimator 'quantities' judges these",
                     "add [[check]] with value and reference, least or most");
  Evidence evidence;
  evidence.plot = {.title = claim.title, .xlabel = "area fraction", .ylabel = claim.checks.front().value, .series = {}};
  for (const ClaimCheck& check : claim.checks) {
    Series points{.label = check.value};
    for (const SceneValues& scene : by_area_fraction(records)) {
      const std::vector<double> values = values_of(parse_quantity_expression(check.value), scene);
      const double nu = scene.scene().area_fraction();
      add_point(points, nu, values);
      evidence.checks.push_back({.label = fmt::format("{}: {}", scene.name(), check.label),
                                 .values = values,
                                 .band = band_of(check, claim),
                                 .x = nu,
                                 .reference = check.reference.value_or(std::numeric_limits<double>::quiet_NaN())});
    }
    evidence.plot.series.push_back(std::move(points));
  }
  return evidence;
}

}  // namespace gpf
