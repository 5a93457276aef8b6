#include "gpf/stats/proportion.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

void require_trials(Share share) {
  if (share.trials == 0 || share.hits > share.trials)
    throw InputError(fmt::format("no proportion from {} of {}", share.hits, share.trials),
                     "it is a part of at least one replica", "count hits among the replicas");
}

}  // namespace

Interval proportion_interval(Share share, double alpha) {
  require_trials(share);
  if (!(alpha > 0 && alpha < 0.5))
    throw InputError(fmt::format("no interval with error rate {} per direction", alpha),
                     "it must lie between 0 and 1/2", "pass for example 0.05");
  const auto hits = static_cast<double>(share.hits), misses = static_cast<double>(share.trials - share.hits);
  return {hits > 0 ? gsl_cdf_beta_Pinv(alpha, hits, misses + 1) : 0,
          misses > 0 ? gsl_cdf_beta_Qinv(alpha, hits + 1, misses) : 1};
}

double outside_band_p_value(Share share, Interval band) {
  require_trials(share);
  if (band.contains(share.value())) return 1;
  const auto hits = static_cast<unsigned>(share.hits), trials = static_cast<unsigned>(share.trials);
  if (share.value() < band.lo) return band.lo > 1 ? 0 : gsl_cdf_binomial_P(hits, band.lo, trials);
  return band.hi < 0 ? 0 : gsl_cdf_binomial_Q(hits - 1, band.hi, trials);  // more than the edge: at least one hit
}

}  // namespace gpf
