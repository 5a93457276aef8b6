// The weighted mean of independent estimates of one quantity.
#pragma once

#include <cstddef>
#include <span>

#include "gpf/stats/estimate.hpp"

namespace gpf {

struct Combination {
  Estimate value;                      ///< weights 1/error^2; its error follows from the errors alone
  double chi2 = 0;                     ///< scatter of the estimates about it in units of their errors
  std::size_t degrees_of_freedom = 0;  ///< number of estimates - 1
};

/// Inverse-variance weighted mean. Whether the estimates agree is for the caller to judge from chi2.
/// @throws InputError for no estimates, or one without a finite mean and a finite error above 0.
Combination weighted_mean(std::span<const Estimate> estimates);

}  // namespace gpf
