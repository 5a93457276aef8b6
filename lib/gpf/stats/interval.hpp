// Intervals, and the Student t interval of the mean of independent replicas.
#pragma once

#include <cstddef>
#include <span>

namespace gpf {

/// A closed interval; lo <= hi. Either end may be infinite.
struct Interval {
  double lo = 0, hi = 0;

  [[nodiscard]] constexpr double width() const { return hi - lo; }
  [[nodiscard]] constexpr double centre() const { return (lo + hi) / 2; }
  [[nodiscard]] constexpr bool contains(double x) const { return lo <= x && x <= hi; }
  [[nodiscard]] constexpr bool contains(Interval other) const { return lo <= other.lo && other.hi <= hi; }
  [[nodiscard]] constexpr bool disjoint(Interval other) const { return hi < other.lo || other.hi < lo; }
};

/// Mean, standard deviation (n - 1 below) and number of independent values, one per replica.
struct ReplicaSummary {
  double mean = 0, deviation = 0;
  std::size_t count = 0;

  [[nodiscard]] double standard_error() const;  ///< deviation/sqrt(count)
};

/// Summary of one value per replica. One value has no deviation: NaN. No value: mean NaN too.
ReplicaSummary summarise(std::span<const double> values);

/// Quantile of Student's t: P(t < result) = probability.
/// @throws InputError unless 0 < probability < 1 and degrees_of_freedom > 0.
double student_t_quantile(double probability, double degrees_of_freedom);

/// mean +- t_{1-alpha, R-1} s/sqrt(R): each end is passed by the true mean with probability alpha.
/// Fewer than two replicas bound nothing: (-infinity, infinity).
/// @throws InputError unless 0 < alpha < 1/2.
Interval t_interval(const ReplicaSummary& replicas, double alpha);

}  // namespace gpf
