#include "gpf/stats/hypothesis.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"

namespace gpf {
namespace {

void require_two(const ReplicaSummary& replicas) {
  if (replicas.count < 2) {
    throw InputError(fmt::format("no t test with {} replica(s)", replicas.count), "their scatter is the error",
                     "run at least two");
  }
}

/// P(t > distance/error); a distance without any error is certain.
double upper_tail(double distance, double error, double degrees_of_freedom) {
  if (error > 0) return gsl_cdf_tdist_Q(distance / error, degrees_of_freedom);
  return distance > 0 ? 0.0 : distance < 0 ? 1.0 : 0.5;
}

}  // namespace

double chi2_p_value(double chi2, std::size_t degrees_of_freedom) {
  if (!(chi2 >= 0) || degrees_of_freedom == 0) {
    throw InputError(fmt::format("no p-value for chi square {} with {} degrees of freedom", chi2, degrees_of_freedom),
                     "chi square is a sum of squares over at least one degree of freedom", "pass more data points");
  }
  return gsl_cdf_chisq_Q(chi2, static_cast<double>(degrees_of_freedom));
}

Interval WelchTest::interval(double alpha) const {
  if (!(alpha > 0 && alpha < 0.5)) {
    throw InputError(fmt::format("no interval with error rate {} per direction", alpha),
                     "it must lie between 0 and 1/2", "pass for example 0.05");
  }
  const double half = student_t_quantile(1 - alpha, degrees_of_freedom) * error;
  return {difference - half, difference + half};
}

WelchTest welch(const ReplicaSummary& a, const ReplicaSummary& b) {
  require_two(a);
  require_two(b);
  const double va = square(a.standard_error()), vb = square(b.standard_error());
  const double na = static_cast<double>(a.count), nb = static_cast<double>(b.count);
  WelchTest test;
  test.difference = a.mean - b.mean;
  test.error = std::sqrt(va + vb);
  test.degrees_of_freedom = test.error > 0 ? square(va + vb) / (va * va / (na - 1) + vb * vb / (nb - 1)) : na + nb - 2;
  test.p_value = 2 * upper_tail(std::abs(test.difference), test.error, test.degrees_of_freedom);
  return test;
}

double equivalence_p_value(const WelchTest& test, double margin) {
  if (!(margin > 0)) {
    throw InputError(fmt::format("no equivalence within a margin of {}", margin),
                     "more data can never show that two means are exactly equal", "state a margin above 0");
  }
  return std::max(upper_tail(margin - test.difference, test.error, test.degrees_of_freedom),
                  upper_tail(margin + test.difference, test.error, test.degrees_of_freedom));
}

double outside_band_p_value(const ReplicaSummary& replicas, Interval band) {
  require_two(replicas);
  if (std::isnan(replicas.mean)) return std::numeric_limits<double>::quiet_NaN();
  if (band.contains(replicas.mean)) return 1;
  const double distance = replicas.mean < band.lo ? band.lo - replicas.mean : replicas.mean - band.hi;
  return upper_tail(distance, replicas.standard_error(), static_cast<double>(replicas.count - 1));
}

std::vector<double> holm(std::span<const double> p_values) {
  for (const double p : p_values) {
    if (!(p >= 0 && p <= 1)) {
      throw InputError(fmt::format("{} is not a p-value", p), "probabilities lie between 0 and 1",
                       "leave out tests that could not be made");
    }
  }
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p_values[i] < p_values[j]; });

  std::vector<double> adjusted(p_values.size());
  double largest = 0;  // an adjusted value never falls below that of a smaller p-value
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double p = std::min(1.0, static_cast<double>(order.size() - k) * p_values[order[k]]);
    largest = std::max(largest, p);
    adjusted[order[k]] = largest;
  }
  return adjusted;
}

}  // namespace gpf
