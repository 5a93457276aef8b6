#include "gpf/stats/fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

double PowerLaw::bend_z() const { return (high_end.mean - low_end.mean) / std::hypot(low_end.error, high_end.error); }

PowerLaw fit_power_law(std::span<const double> x, std::span<const Estimate> y) {
  require_same_length(x.size(), y.size());
  if (x.size() < 4) {
    throw InputError(fmt::format("no power law from {} points", x.size()),
                     "the slopes at its two ends are compared, and each needs two", "pass at least four");
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!(x[k] > 0) || !(y[k].mean > 0)) {
      throw InputError(fmt::format("point ({}, {}) is on no power law", x[k], y[k].mean),
                       "only numbers above 0 have a logarithm", "leave it out, or shift the quantity");
    }
  }
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return x[i] < x[j]; });
  std::vector<double> log_x;
  std::vector<Estimate> log_y;
  for (const std::size_t k : order) {
    log_x.push_back(std::log(x[k]));
    log_y.push_back({std::log(y[k].mean), y[k].error / y[k].mean});
  }
  const auto exponent = [](const LineFit& line) { return Estimate{line.slope, std::sqrt(line.var_slope)}; };
  const std::size_t third = std::max<std::size_t>(2, x.size() / 3);
  const std::span<const double> all_x = log_x;
  const std::span<const Estimate> all_y = log_y;
  const LineFit line = fit_line(all_x, all_y);
  return {exponent(line),
          line.intercept,
          exponent(fit_line(all_x.first(third), all_y.first(third))),
          exponent(fit_line(all_x.last(third), all_y.last(third))),
          line.chi2,
          line.degrees_of_freedom};
}

}  // namespace gpf
