// p-values: Welch's t, equivalence by two one-sided tests, a value outside a band, chi square, and Holm's correction.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gpf/stats/interval.hpp"

namespace gpf {

/// P(chi square with so many degrees of freedom > chi2).
/// @throws InputError unless chi2 >= 0 and degrees_of_freedom > 0.
double chi2_p_value(double chi2, std::size_t degrees_of_freedom);

/// Difference of two means with unequal variances (Welch, Biometrika 34, 28 (1947)).
struct WelchTest {
  double difference = 0;          ///< mean of a - mean of b
  double error = 0;               ///< standard error of the difference
  double degrees_of_freedom = 0;  ///< Welch-Satterthwaite
  double p_value = 1;             ///< two-sided, of "no difference"

  /// The difference with error rate alpha at each end. @throws InputError unless 0 < alpha < 1/2.
  [[nodiscard]] Interval interval(double alpha) const;
};

/// @throws InputError with fewer than two replicas on either side.
WelchTest welch(const ReplicaSummary& a, const ReplicaSummary& b);

/// Two one-sided tests (Schuirmann, J. Pharmacokin. Biopharm. 15, 657 (1987)): p-value of "the true difference is
/// margin or more, either way". Below alpha exactly when the interval with alpha at each end lies within +-margin.
/// @throws InputError unless margin > 0.
double equivalence_p_value(const WelchTest& test, double margin);

/// p-value of "the true mean lies in the band": one-sided against the nearer edge; 1 when the mean is inside.
/// Below alpha exactly when t_interval(replicas, alpha) and the band are disjoint.
/// @throws InputError with fewer than two replicas.
double outside_band_p_value(const ReplicaSummary& replicas, Interval band);

/// Holm's step-down adjustment (Scand. J. Stat. 6, 65 (1979)), in the order given: rejecting where the adjusted value
/// is at most alpha keeps the family-wise error rate at alpha, however the tests depend on one another.
/// @throws InputError when a p-value is not within [0, 1].
std::vector<double> holm(std::span<const double> p_values);

}  // namespace gpf
