#include "gpf/stats/combine.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"

namespace gpf {

Combination weighted_mean(std::span<const Estimate> estimates) {
  if (estimates.empty()) {
    throw InputError("no estimates to combine", "their weighted mean is not defined", "pass at least one");
  }
  double weights = 0, sum = 0;
  for (const Estimate& e : estimates) {
    if (!std::isfinite(e.mean) || !std::isfinite(e.error) || !(e.error > 0)) {
      throw InputError(fmt::format("{} +- {} cannot be weighted", e.mean, e.error), "its weight is 1/error^2",
                       "leave out what was not measured");
    }
    const double w = 1 / square(e.error);
    weights += w;
    sum += w * e.mean;
  }
  Combination result;
  result.value = {sum / weights, 1 / std::sqrt(weights)};
  result.degrees_of_freedom = estimates.size() - 1;
  for (const Estimate& e : estimates) result.chi2 += square((e.mean - result.value.mean) / e.error);
  return result;
}

}  // namespace gpf
