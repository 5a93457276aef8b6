// Where a curve first passes a threshold.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace gpf {

/// x at which y, linear between its points, first rises to `threshold`: the first point if it lies there or above, NaN
/// when none does. x ascends; both are as long.
inline double onset(const std::vector<double>& x, const std::vector<double>& y, double threshold) {
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!(y[k] >= threshold)) continue;
    return k == 0 ? x[0] : x[k - 1] + (x[k] - x[k - 1]) * (threshold - y[k - 1]) / (y[k] - y[k - 1]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace gpf
