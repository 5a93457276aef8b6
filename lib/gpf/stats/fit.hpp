// Weighted straight lines, and power laws as straight lines in log-log.
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

/// y = exp(log_prefactor) x^exponent.
struct PowerLaw {
  Estimate exponent;
  double log_prefactor = 0;
  Estimate low_end, high_end;  ///< exponents of the third of the points with the smallest and with the largest x
  double chi2 = 0;
  std::size_t degrees_of_freedom = 0;

  /// (high_end - low_end)/error: large when the data bend and are not a power law.
  [[nodiscard]] double bend_z() const;
};

/// Straight line through (ln x, ln y), each with the error error_y/y; in any order of x.
/// @throws InputError unless there are at least four points, all x and y above 0, errors finite and above 0, and
/// different x within each third.
PowerLaw fit_power_law(std::span<const double> x, std::span<const Estimate> y);

}  // namespace gpf
