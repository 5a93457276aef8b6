#include "verify/methods/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpf {
namespace {

/// Mean and variance of a bin over replicas.
struct Moments {
  double mean = 0, variance = 0;
};
Moments moments(const std::vector<std::vector<double>>& replicas, std::size_t bin) {
  const auto count = static_cast<double>(replicas.size());
  Moments m;
  for (const auto& r : replicas) m.mean += r[bin] / count;
  if (replicas.size() < 2) return m;
  for (const auto& r : replicas) m.variance += (r[bin] - m.mean) * (r[bin] - m.mean) / (count - 1);
  return m;
}

}  // namespace

double Misfit::bias_at_most() const { return std::hypot(bias, resolution) + resolution; }
double Misfit::total() const { return std::hypot(bias, noise); }

Misfit misfit_of(const std::vector<std::vector<double>>& runs, const std::vector<std::vector<double>>& reference,
                 bool absolute) {
  double difference = 0, error = 0, variance = 0, size = 0, bins = 0;
  for (std::size_t b = 0; b < reference.front().size(); ++b) {
    const Moments m = moments(runs, b), truth = moments(reference, b);
    if (!std::isfinite(m.mean) || !std::isfinite(truth.mean)) continue;
    difference += (m.mean - truth.mean) * (m.mean - truth.mean);
    error += m.variance / static_cast<double>(runs.size()) + truth.variance / static_cast<double>(reference.size());
    variance += m.variance;
    size += truth.mean * truth.mean;
    bins += 1;
  }
  const double unit = absolute ? bins : size;
  if (!(unit > 0)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
  }
  return {std::sqrt(std::max(0.0, difference - error) / unit), std::sqrt(error / unit), std::sqrt(variance / unit)};
}

}  // namespace gpf
