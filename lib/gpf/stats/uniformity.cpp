#include "gpf/stats/uniformity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gpf/base/error.hpp"

namespace gpf {

double uniformity_p_value(std::span<const double> values) {
  if (values.empty())
    throw InputError("no values to test for uniformity", "a distribution needs some", "pass a few dozen");
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  if (!(sorted.front() >= 0 && sorted.back() <= 1))
    throw InputError(fmt::format("values from {} to {} are not uniform on [0, 1]", sorted.front(), sorted.back()),
                     "some lie outside", "pass p-values");
  const double n = static_cast<double>(sorted.size());
  double distance = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const double below = static_cast<double>(k) / n, above = static_cast<double>(k + 1) / n;
    distance = std::max({distance, above - sorted[k], sorted[k] - below});
  }
  const double x = (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * distance;
  if (x < 0.3) return 1;  // 1 - 1e-5; the series converges slowly there
  double p = 0;
  for (int j = 1; j <= 20; ++j) p += (j % 2 == 1 ? 2 : -2) * std::exp(-2.0 * j * j * x * x);
  return std::clamp(p, 0.0, 1.0);
}

}  // namespace gpf
