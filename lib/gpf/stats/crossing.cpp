#include "gpf/stats/crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"

namespace gpf {

bool Crossing::bounded() const { return std::isfinite(interval.lo) && std::isfinite(interval.hi); }

Crossing zero_crossing(const LineFit& line, double quantile) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(quantile > 0) || line.slope == 0) {
    throw InputError(fmt::format("no zero of a line of slope {} with quantile {}", line.slope, quantile),
                     "a flat line crosses nothing, and an interval needs a quantile above 0",
                     "pass points whose values differ, and for example 1.96");
  }
  // (intercept + slope x)^2 <= q^2 (var_intercept + 2 covariance x + var_slope x^2), a quadratic in x.
  const double q2 = square(quantile);
  const double a = square(line.slope) - q2 * line.var_slope;
  const double half_b = line.intercept * line.slope - q2 * line.covariance;
  const double c = square(line.intercept) - q2 * line.var_intercept;
  const double at = -line.intercept / line.slope;
  if (!(a > 0)) return {at, {-infinity, infinity}};
  const double half_width = std::sqrt(std::max(0.0, half_b * half_b - a * c)) / a;
  return {at, {-half_b / a - half_width, -half_b / a + half_width}};
}

}  // namespace gpf
