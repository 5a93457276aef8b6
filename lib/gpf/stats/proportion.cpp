#include "gpf/stats/proportion.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

void require_trials(Share share) {
  if (share.trials == 0 || share.hits > share.trials)
    throw InputError(fmt::format("no proportion from {} of {}", share.hits, share.trials),
                     "it is a part of at least one replica", "count hits among the replicas");
}

/// P(X >= hits) and P(X <= hits) for X binomial with proportion p.
double at_least(std::size_t hits, std::size_t trials, double p) {
  return hits == 0 ? 1 : gsl_cdf_binomial_Q(static_cast<unsigned>(hits - 1), p, static_cast<unsigned>(trials));
}
double at_most(std::size_t hits, std::size_t trials, double p) {
  return gsl_cdf_binomial_P(static_cast<unsigned>(hits), p, static_cast<unsigned>(trials));
}

/// Where a tail that rises (or falls) with p is alpha. GSL's inverse of the beta distribution does not always converge.
template <class Tail>
double solve(Tail&& tail, bool rises, double alpha) {
  double low = 0, high = 1;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    ((tail(middle) < alpha) == rises ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

Interval proportion_interval(Share share, double alpha) {
  require_trials(share);
  if (!(alpha > 0 && alpha < 0.5))
    throw InputError(fmt::format("no interval with error rate {} per direction", alpha),
                     "it must lie between 0 and 1/2", "pass for example 0.05");
  const auto least = [share](double p) { return at_least(share.hits, share.trials, p); };
  const auto most = [share](double p) { return at_most(share.hits, share.trials, p); };
  return {share.hits == 0 ? 0 : solve(least, true, alpha), share.hits == share.trials ? 1 : solve(most, false, alpha)};
}

double outside_band_p_value(Share share, Interval band) {
  require_trials(share);
  if (band.contains(share.value())) return 1;
  if (share.value() < band.lo) return band.lo > 1 ? 0 : at_most(share.hits, share.trials, band.lo);
  return band.hi < 0 ? 0 : at_least(share.hits, share.trials, band.hi);
}

double inside_band_p_value(Share share, Interval band) {
  require_trials(share);
  const double below = band.lo > 0 ? at_least(share.hits, share.trials, std::min(band.lo, 1.0)) : 0;
  const double above = band.hi < 1 ? at_most(share.hits, share.trials, std::max(band.hi, 0.0)) : 0;
  return std::max(below, above);
}

}  // namespace gpf
