#include "gpf/stats/fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"

namespace gpf {
namespace {

void require_same_length(std::size_t x, std::size_t y) {
  if (x != y) {
    throw InputError(fmt::format("{} values of x and {} of y", x, y), "a fit needs pairs", "pass as many of each");
  }
}

}  // namespace

Estimate LineFit::at(double x) const {
  return {intercept + slope * x, std::sqrt(var_intercept + 2 * x * covariance + x * x * var_slope)};
}

LineFit fit_line(std::span<const double> x, std::span<const Estimate> y) {
  require_same_length(x.size(), y.size());
  const bool can_tilt = std::any_of(x.begin(), x.end(), [&](double v) { return v != x.front(); });
  if (!can_tilt) {
    throw InputError(fmt::format("no line through {} point(s) with one x", x.size()), "the slope is not determined",
                     "pass at least two different x");
  }
  std::vector<double> weights, values;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!std::isfinite(x[k]) || !std::isfinite(y[k].mean) || !std::isfinite(y[k].error) || !(y[k].error > 0)) {
      throw InputError(fmt::format("point ({}, {} +- {}) cannot be fitted", x[k], y[k].mean, y[k].error),
                       "its weight is 1/error^2", "leave out what was not measured");
    }
    values.push_back(y[k].mean);
    weights.push_back(1 / square(y[k].error));
  }
  LineFit fit;
  gsl_fit_wlinear(x.data(), 1, weights.data(), 1, values.data(), 1, values.size(), &fit.intercept, &fit.slope,
                  &fit.var_intercept, &fit.covariance, &fit.var_slope, &fit.chi2);
  fit.degrees_of_freedom = values.size() - 2;
  return fit;
}

}  // namespace gpf
