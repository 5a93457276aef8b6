// Comparing a series with itself (is it stationary?) and a profile with its reference (how far off is it?).
#pragma once

#include <span>

#include "gpf/stats/estimate.hpp"

namespace gpf {

/// z of "the second half of the series has the same mean as the first", from the block error of each half;
/// positive when it rises. An odd value in the middle is left out. NaN when a half has fewer than fewest_blocks values
/// or the series contains NaN; 0 or +-infinity when both halves are constant.
double stationarity_z(std::span<const double> series);

/// Relative misfit of a profile, with the part that noise alone would give taken off:
/// D^2 = sum w [(y - theta)^2 - se^2] / sum w theta^2, y the measured means, se their errors, theta the reference.
/// Its expectation is the true relative squared misfit, so it is about 0, and as often negative, for a perfect
/// reference. Bins whose mean or error is not finite are left out. `weights` empty: all 1.
/// @throws InputError when the lengths differ, or no bin with a reference other than 0 is left.
double relative_misfit(std::span<const Estimate> measured, std::span<const double> reference,
                       std::span<const double> weights = {});

}  // namespace gpf
