// Synthetic series with known truth, from the project's own counter-based Gaussian numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/base/random.hpp"

namespace synthetic {

/// n independent standard normal numbers of stream `key`.
inline std::vector<double> white(std::uint64_t key, std::size_t n) {
  std::vector<double> values(n);
  for (std::size_t k = 0; k < n; ++k) values[k] = gpf::gaussian_pair(key, k).x;
  return values;
}

/// Stationary autoregressive series of mean 0 and variance 1: x_k = phi x_{k-1} + sqrt(1 - phi^2) g_k.
inline std::vector<double> autoregressive(std::uint64_t key, std::size_t n, double phi) {
  std::vector<double> values = white(key, n);
  for (std::size_t k = 1; k < n; ++k) values[k] = phi * values[k - 1] + std::sqrt(1 - phi * phi) * values[k];
  return values;
}

/// Variance of the mean of such a series: (1/n) [1 + 2 sum_{k<n} (1 - k/n) phi^k].
inline double variance_of_mean(std::size_t n, double phi) {
  const double length = static_cast<double>(n);
  double sum = 1, power = 1;
  for (std::size_t k = 1; k < n; ++k) {
    power *= phi;
    sum += 2 * (1 - static_cast<double>(k) / length) * power;
  }
  return sum / length;
}

}  // namespace synthetic
