#include "gpf/stats/compare.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"
#include "gpf/stats/blocks.hpp"

namespace gpf {

double stationarity_z(std::span<const double> series) {
  const std::size_t half = series.size() / 2;
  const BlockError first = block_error(series.first(half)), second = block_error(series.last(half));
  const double difference = second.mean - first.mean, error = std::hypot(first.error, second.error);
  if (difference == 0 && error == 0) return 0;
  return difference / error;
}

double relative_misfit(std::span<const Estimate> measured, std::span<const double> reference,
                       std::span<const double> weights) {
  if (measured.size() != reference.size() || (!weights.empty() && weights.size() != measured.size())) {
    throw InputError(fmt::format("{} measured bins, {} reference bins and {} weights", measured.size(),
                                 reference.size(), weights.size()),
                     "they are compared bin by bin", "pass arrays of equal length");
  }
  double misfit = 0, scale = 0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (!std::isfinite(measured[k].mean) || !std::isfinite(measured[k].error)) continue;
    const double w = weights.empty() ? 1 : weights[k];
    misfit += w * (square(measured[k].mean - reference[k]) - square(measured[k].error));
    scale += w * square(reference[k]);
  }
  if (!(scale > 0)) {
    throw InputError("no relative misfit", "no measured bin has a reference other than 0", "compare absolute values");
  }
  return misfit / scale;
}

}  // namespace gpf
