// Which of many numbers differ between two sides: p-values for all of them together, by relabelling replicas.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gpf {

/// One number on both sides, a value for each independent replica. Numbers with as many values on either side as this
/// one share its relabellings: there, the same index must mean the same replica (or replicas that are independent).
struct TwoSides {
  std::vector<double> a, b;
  bool share = false;  ///< values are 0 or 1
};

struct StepDown {
  std::vector<double> statistic;   ///< |t| of each number, on the scale of a normal variable; infinite for a difference
                                   ///< without scatter
  std::vector<double> p_single;    ///< of "this number does not differ", on its own
  std::vector<double> p_adjusted;  ///< naming those with at most alpha names a wrong one with probability alpha at most
  double global_p = 1;             ///< of "none differs": that of the largest statistic
  std::vector<double> largest;     ///< largest statistic of each relabelling, descending
  bool exact = false;              ///< every relabelling was tried, instead of random ones

  /// What a number's statistic must exceed for an adjusted p-value of at most alpha if no other one differs; infinite
  /// when there are too few relabellings.
  [[nodiscard]] double critical(double alpha) const;
};

/// Free step-down max-T of Westfall & Young (Resampling-Based Multiple Testing, 1993, algorithm 2.8): two-sided, with
/// the distribution of the largest statistic from relabelling the replicas, one relabelling for all numbers of the same
/// counts, so that numbers which depend on one another count for as many as they are worth.
///
/// The statistic is Welch's t, computed anew for each relabelling, and put on the scale of a normal variable by
/// Wallace's approximation, |z| = (8 f + 1)/(8 f + 3) sqrt(f ln(1 + t^2/f)) with f = n_a + n_b - 2 (Ann. Math. Stat.
/// 30, 1124 (1959)), so that numbers of few replicas, whose t is large by chance, do not hide those of many. A share's
/// is the difference over its standard deviation among relabellings. Scatter below 3e-7 of the total counts as none: t
/// is then infinite, or 0 without a difference.
///
/// All relabellings are tried when there are at most `relabellings` of them, and p-values are then the fraction that
/// reaches the observed statistic; otherwise so many are drawn (a function of `seed`), and they are (1 + reached)/(1 +
/// drawn). Numbers with other counts are relabelled independently, which takes those for independent that are not:
/// conservative where they depend on one another positively.
/// @throws InputError unless each number has two values on either side, all finite, and relabellings >= 1.
StepDown step_down_max_t(std::span<const TwoSides> numbers, int relabellings, std::uint64_t seed);

/// Number of ways to choose `chosen` of `all`, as far as a double counts.
double combinations(std::size_t all, std::size_t chosen);

}  // namespace gpf
