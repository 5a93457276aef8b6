// Errors of quantities derived from sums (ratios, moments, fluxes), by the jackknife over blocks.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "gpf/stats/estimate.hpp"

namespace gpf {

/// Derived quantities from the sums of all tallies; always the same number of them.
using Derive = std::function<std::vector<double>(std::span<const double> sums)>;

/// Delete-one jackknife over `blocks` consecutive blocks of a run.
///
/// `sums` is a row-major matrix, blocks x tallies: row b holds what each tally collected during block b. Each derived
/// quantity q gets the pseudo-values B q(all) - (B - 1) q(all but b) (Tukey 1958), in the order of time, and
/// their block_error, so that blocks that are still correlated are dealt with.
///
/// The mean is q(all), not the bias-corrected mean of the pseudo-values: it is the number that anybody gets from
/// the stored sums, exact balances between derived quantities stay exact, and the bias that remains is of the
/// order of error^2/q. An undefined quantity (a bin never occupied) is not finite in q(all) and gives a NaN mean and a
/// NaN error. A bin occupied in one block only gives a mean without an error, as do fewer than fewest_blocks blocks.
///
/// @throws InputError when `sums` is not a whole number of rows, there is no block, or `derive` changes its length.
std::vector<Estimate> jackknife(std::span<const double> sums, std::size_t blocks, const Derive& derive);

}  // namespace gpf
