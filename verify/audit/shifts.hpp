// What moved between two versions: their estimates of the same numbers, compared.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpf/stats/interval.hpp"

namespace gpf {

/// One number that a claim judges, as a version of the program finds it.
struct ClaimEstimate {
  std::string claim, label;    ///< Check::label
  std::vector<double> values;  ///< one per replica
  Interval band;               ///< Check::band
  bool exact = false;          ///< an identity: judged apart, without statistics
  bool share = false;          ///< values are 0 or 1
};

enum class Moved {
  no,          ///< the same bits
  equivalent,  ///< the 90 % interval of the difference lies within half the tolerance
  unresolved,  ///< neither shown to be equivalent nor to have changed
  yes          ///< adjusted p-value at most the family's alpha (even when the shift is small beside the tolerance)
};

/// One number before and after.
struct Shift {
  ClaimEstimate before, after;
  double difference = 0, error = 0;  ///< after - before of the means; its standard error (Welch)
  Interval interval;                 ///< 90 % interval of the difference
  double p_adjusted = 1;             ///< step-down max-T by permutation
  double p_single = 1;               ///< by permutation, of this number alone
  /// Shift that would be found at 90 % power in this family, same unit: (t_c + t_.90) error, both quantiles with
  /// Welch's degrees of freedom, t_c that of the two-sided p of StepDown::critical(family_alpha). Infinite when its
  /// replicas have too few relabellings: 4 a side reach a p-value of 2/70 at best, 3 a side 2/20.
  double detectable = 0;
  Moved moved = Moved::unresolved;
};

struct ShiftOptions {
  double family_alpha = 0.05;  ///< for naming single numbers: chance that any is named when nothing moved
  int permutations = 9999;
  std::uint64_t seed = 1;
};

struct Shifts {
  std::vector<Shift> all;  ///< in the order of `before`
  /// Exact checks, and numbers of one value a side (no scatter to measure a shift by), with difference only: `no`: the
  /// same bits; `equivalent`: in the band on both sides, and smallest and largest value differ by at most half the
  /// tolerance; `yes`: measured on one side only; of an exact check in the band on one side only, or out of it on both
  /// and moved by more than half of its width; of a single value moved by more than the whole band; else `unresolved`.
  std::vector<Shift> identities;
  double global_p = 1;  ///< of "nothing moved", over all statistical numbers
  double critical = 0;  ///< StepDown::critical(family_alpha); 0 when nothing took part
  [[nodiscard]] bool identity_moved() const;
  [[nodiscard]] bool any_named(double family_alpha = 0.05) const;  ///< a number is named as moved, or an identity
};

/// Welch's t of every number, two-sided, and step-down max-T p-values by permutation of the replicas between the
/// versions (Westfall & Young, Resampling-Based Multiple Testing, 1993; gpf/stats/step_down.hpp): one permutation
/// relabels replica k of all claims together, because claims share runs. Numbers whose values are the same bits on both
/// sides are Moved::no and take no part.
///
/// The tolerance of a number is half the width of its band, so equivalence takes a 90 % interval (Welch) within +- a
/// quarter of the width; a band with an open side has no width, and nothing is equivalent in it. The k-th number after
/// is that of the k-th before. With a value that is not finite a number is `unresolved`, without difference (NaN).
///
/// Throws InputError for sides of other lengths, and for fewer than two replicas on a side of a statistical number that
/// differs, unless it is one on both.
Shifts compare(std::span<const ClaimEstimate> before, std::span<const ClaimEstimate> after,
               const ShiftOptions& options = {});

}  // namespace gpf
