#include "gpf/stats/blocks.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/vec2.hpp"

namespace gpf {
namespace {

struct Level {
  double error, uncertainty;
  std::size_t blocks;
};

double mean_of(std::span<const double> values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

Level naive(std::span<const double> values) {
  const double n = static_cast<double>(values.size()), mean = mean_of(values);
  double squares = 0;
  for (const double v : values) squares += square(v - mean);
  const double error = std::sqrt(squares / (n * (n - 1)));
  return {error, error / std::sqrt(2 * (n - 1)), values.size()};
}

/// Averages neighbours; the last of an odd number is left out.
std::vector<double> in_pairs(const std::vector<double>& values) {
  std::vector<double> pairs(values.size() / 2);
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k] = (values[2 * k] + values[2 * k + 1]) / 2;
  return pairs;
}

bool is_plateau(const std::vector<Level>& levels, std::size_t level) {
  for (std::size_t above = level + 1; above < levels.size(); ++above) {
    if (levels[above].error > levels[level].error + levels[above].uncertainty) return false;
  }
  // A constant series has naive error 0 at every level: it shows no correlation.
  const double inefficiency = levels[0].error > 0 ? square(levels[level].error / levels[0].error) : 1;
  return std::ldexp(1.0, static_cast<int>(level)) >= 4 * (inefficiency - 1);
}

}  // namespace

BlockError block_error(std::span<const double> series) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const double mean = series.empty() ? nan : mean_of(series);
  if (series.size() < fewest_blocks || !std::isfinite(mean)) return {mean, nan, 0, series.size(), false};

  std::vector<Level> levels;
  for (std::vector<double> values(series.begin(), series.end()); values.size() >= fewest_blocks;
       values = in_pairs(values)) {
    levels.push_back(naive(values));
  }
  // The last level has none above that could confirm it.
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
    if (is_plateau(levels, level))
      return {mean, levels[level].error, static_cast<int>(level), levels[level].blocks, true};
  }
  return {mean, levels.back().error, static_cast<int>(levels.size()) - 1, levels.back().blocks, false};
}

}  // namespace gpf
