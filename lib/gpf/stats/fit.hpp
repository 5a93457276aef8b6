// Weighted straight lines.
#pragma once

#include <cstddef>
#include <span>

#include "gpf/stats/estimate.hpp"

namespace gpf {

/// y = intercept + slope x, with the covariance that follows from the errors of y alone (not scaled by chi2).
struct LineFit {
  double intercept = 0, slope = 0;
  double var_intercept = 0, covariance = 0, var_slope = 0;
  double chi2 = 0;
  std::size_t degrees_of_freedom = 0;  ///< points - 2

  /// The line at x, with its error.
  [[nodiscard]] Estimate at(double x) const;
};

/// Least squares with weights 1/error^2 (gsl_fit_wlinear).
/// @throws InputError unless there are at least two different x, equally many y, and finite errors above 0.
LineFit fit_line(std::span<const double> x, std::span<const Estimate> y);

}  // namespace gpf
