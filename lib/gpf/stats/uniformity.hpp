// Are numbers spread evenly over (0, 1), as p-values of true statements are?
#pragma once

#include <span>

namespace gpf {

/// Kolmogorov & Smirnov: p-value of "independent and uniform on [0, 1]", from the largest distance D between the
/// measured distribution function and the diagonal, with the argument (sqrt(n) + 0.12 + 0.11/sqrt(n)) D of Kolmogorov's
/// series (Stephens, J. R. Stat. Soc. B 32, 115 (1970)): good to a few per cent of p for n >= 5. Ties, as of p-values
/// with few values, make it smaller.
/// @throws InputError without values, or with one that is not within [0, 1].
double uniformity_p_value(std::span<const double> values);

}  // namespace gpf
