#include "verify/drift.hpp"

#include <gsl/gsl_cdf.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "gpf/base/vec2.hpp"

namespace gpf {
namespace {

constexpr std::size_t parts = 4;
using Quarters = std::array<double, parts>;

Quarters quarters_of(const std::vector<double>& blocks) {
  const std::size_t length = blocks.size() / parts, first = blocks.size() % parts;
  Quarters means{};
  for (std::size_t k = 0; k < parts * length; ++k) means[k / length] += blocks[first + k] / static_cast<double>(length);
  return means;
}

double two_sided_p(double contrast, double error, double degrees_of_freedom) {
  if (contrast == 0) return 1;
  return error > 0 ? 2 * gsl_cdf_tdist_Q(std::abs(contrast) / error, degrees_of_freedom) : 0;
}

}  // namespace

DriftTest drift_test(const std::vector<std::vector<double>>& replicas) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (replicas.size() < 2) return {nan, nan};
  const auto count = static_cast<double>(replicas.size());
  std::vector<Quarters> table;
  Quarters course{};  // mean over the replicas
  for (const auto& blocks : replicas) {
    if (blocks.size() < parts) return {nan, nan};
    table.push_back(quarters_of(blocks));
    for (std::size_t q = 0; q < parts; ++q) course[q] += table.back()[q] / count;
  }
  const auto mean_of = [](const Quarters& row) { return (row[0] + row[1] + row[2] + row[3]) / parts; };
  double squares = 0;
  for (const Quarters& row : table)
    for (std::size_t q = 0; q < parts; ++q) squares += square((row[q] - mean_of(row)) - (course[q] - mean_of(course)));
  const double freedom = (parts - 1) * (count - 1), error = std::sqrt(squares / freedom / count);  // of course[q]
  const double halves = (course[2] + course[3] - course[0] - course[1]) / 2;                       // variance 4/4
  const double first_quarter = course[0] - (course[1] + course[2] + course[3]) / 3;                // variance 1 + 3/9
  return {two_sided_p(halves, error, freedom), two_sided_p(first_quarter, error * std::sqrt(4.0 / 3), freedom)};
}

}  // namespace gpf
