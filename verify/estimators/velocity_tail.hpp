// Tails of velocity distributions: the exponent of a power law, and whether a stretched exponential does better.
#pragma once

#include <vector>

#include "gpf/stats/estimate.hpp"
#include "verify/estimators/velocity_distribution.hpp"

namespace gpf {

/// from < |u|/sigma < to.
struct TailWindow {
  double from, to;
};
enum class TailSide { both, positive, negative };

/// The windows in which tails are fitted.
inline constexpr TailWindow tail_windows[] = {{2, 4}, {2.5, 5}, {3, 6}};

/// Counts in the cells of a window, from its lower end on.
struct TailCounts {
  TailWindow window;
  std::vector<double> counts;
};
TailCounts tail_counts(const VelocityDistribution& distribution, TailWindow window, TailSide side);

/// P ~ exp(-slope ((x/from)^bend - 1)/bend), x = |u|/sigma: a stretched exponential of that `bend`, 2 for a Gaussian,
/// and in the limit bend = 0 the power law x^-slope. `slope`: -d ln P/d ln x at the lower end of the window.
struct TailLaw {
  double slope = 0, bend = 0;

  /// ln of the probability of the counts, given how many there are in the window.
  [[nodiscard]] double log_likelihood(const TailCounts& tail) const;
  /// -d ln P/d ln x at the upper end of the window.
  [[nodiscard]] double slope_at_end(TailWindow window) const;
};

/// Of greatest likelihood among those with the given bend; NaN with less than ten counts.
TailLaw fit_tail(const TailCounts& tail, double bend);
/// The same with bend free in [-2, 4].
TailLaw fit_stretched_tail(const TailCounts& tail);

/// A tail in one window: one value per replica.
struct TailFit {
  TailWindow window;
  std::vector<double> exponent;       ///< of the power law
  std::vector<double> bend;           ///< of the stretched exponential
  std::vector<double> end_slope;      ///< local exponent of the stretched exponential at the window's upper end, less
                                      ///< that at its lower end
  std::vector<double> against_power;  ///< ln likelihood of this replica, stretched exponential less power law, both
                                      ///< fitted to the other replicas: above 0 when the stretched exponential wins
};
std::vector<TailFit> fit_tails(const std::vector<VelocityDistribution>& replicas, TailSide side);

/// Exponents of all windows: mean over replicas and windows, error over replicas and half the spread over windows.
struct TailExponent {
  std::vector<double> per_replica;  ///< mean over the windows
  Estimate estimate;
  double half_spread = 0;
};
TailExponent tail_exponent(const std::vector<TailFit>& fits);

}  // namespace gpf
