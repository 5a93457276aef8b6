// How large a share of all replicas is of one kind, from some of them.
#pragma once

#include <cstddef>

#include "gpf/stats/interval.hpp"

namespace gpf {

/// `hits` of `trials` independent replicas are of the kind.
struct Share {
  std::size_t hits = 0, trials = 0;

  [[nodiscard]] double value() const { return static_cast<double>(hits) / static_cast<double>(trials); }
};

/// Interval of the true proportion (Clopper & Pearson, Biometrika 26, 404 (1934)): each end is passed by it with
/// probability alpha at most. Never wider than [0, 1]. 8 of 8 with alpha 0.05: from 0.688.
/// @throws InputError without trials, with more hits than trials, or unless 0 < alpha < 1/2.
Interval proportion_interval(Share share, double alpha);

/// p-value of "the true proportion lies in the band": the binomial tail at the nearer edge; 1 when the share is inside.
/// Below alpha exactly when proportion_interval(share, alpha) and the band are disjoint.
/// @throws InputError without trials or with more hits than trials.
double outside_band_p_value(Share share, Interval band);

/// p-value of "the true proportion lies on an edge of the band or beyond": the larger binomial tail at an edge within
/// (0, 1). At most alpha exactly when the band contains proportion_interval(share, alpha).
/// @throws InputError without trials or with more hits than trials.
double inside_band_p_value(Share share, Interval band);

}  // namespace gpf
