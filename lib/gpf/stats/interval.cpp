#include "gpf/stats/interval.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <cmath>
#include <limits>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"

namespace gpf {

double ReplicaSummary::standard_error() const { return deviation / std::sqrt(static_cast<double>(count)); }

ReplicaSummary summarise(std::span<const double> values) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {nan, nan, 0};
  const double n = static_cast<double>(values.size());
  double sum = 0;
  for (const double v : values) sum += v;
  const double mean = sum / n;
  if (values.size() == 1) return {mean, nan, 1};
  double squares = 0;
  for (const double v : values) squares += square(v - mean);
  return {mean, std::sqrt(squares / (n - 1)), values.size()};
}

double student_t_quantile(double probability, double degrees_of_freedom) {
  if (!(probability > 0 && probability < 1) || !(degrees_of_freedom > 0)) {
    throw InputError(
        fmt::format("no t quantile for probability {} and {} degrees of freedom", probability, degrees_of_freedom),
        "the probability must lie between 0 and 1, the degrees of freedom above 0",
        "pass at least two replicas and an error rate between 0 and 1");
  }
  return gsl_cdf_tdist_Pinv(probability, degrees_of_freedom);
}

Interval t_interval(const ReplicaSummary& replicas, double alpha) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(alpha > 0 && alpha < 0.5)) {
    throw InputError(fmt::format("no interval with error rate {} per direction", alpha),
                     "it must lie between 0 and 1/2", "pass for example 0.01");
  }
  if (replicas.count < 2) return {-infinity, infinity};
  const double half =
      student_t_quantile(1 - alpha, static_cast<double>(replicas.count - 1)) * replicas.standard_error();
  return {replicas.mean - half, replicas.mean + half};
}

}  // namespace gpf
