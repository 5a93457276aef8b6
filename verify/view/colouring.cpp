#include "verify/view/colouring.hpp"

#include <cmath>

#include "gpf/measure/bins.hpp"

namespace gpf {

std::vector<double> shown_values(const State& state, Colouring colouring, int bins) {
  std::vector<double> values(state.velocity.size(), 0.0);
  if (colouring == Colouring::one) return values;
  const Bins across(bins);
  const auto bin_of = [&](std::size_t i) { return static_cast<std::size_t>(across.at(state.position[i].y)); };
  std::vector<Vec2> mean(static_cast<std::size_t>(bins));
  if (colouring == Colouring::fluctuation) {
    std::vector<double> number(mean.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      mean[bin_of(i)] = mean[bin_of(i)] + state.velocity[i];
      number[bin_of(i)] += 1;
    }
    for (std::size_t b = 0; b < mean.size(); ++b)
      if (number[b] > 0) mean[b] = (1 / number[b]) * mean[b];
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Vec2 from_mean = state.velocity[i] - mean[bin_of(i)];
    values[i] = std::sqrt(dot(from_mean, from_mean));
  }
  return values;
}

}  // namespace gpf
