// One check of a claim as a report shows it: scaled to its band, and in digits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/judge.hpp"

namespace gpf {

/// A check in units in which its band is the same for all checks.
struct ScaledCheck {
  double value, lo, hi;  ///< mean and ends of its interval; the ends may be infinite
};

/// (value - centre of the band) / half width of the band: the band is [-1, 1]. Nothing when a side is open, when the
/// band has no width, or without a finite value.
std::optional<ScaledCheck> scaled_to_band(const JudgedCheck& check);

/// Distance to the bound in standard errors of the mean, positive on the band's side, of a check with one open side.
/// Nothing for exact checks and without a standard error.
std::optional<ScaledCheck> scaled_to_bound(const JudgedCheck& check);

/// "4.2 se": distance of the mean to the nearest edge of its band in standard errors, negative outside. For an exact
/// check "exact, 3 % of band": how far its worst value is from the band's centre towards the edge. "-" without values.
std::string margin_text(const JudgedCheck& check);

/// Mean with the digits that its interval justifies; "1e-14 ... 3e-14" for an exact check of several values.
std::string value_text(const JudgedCheck& check);
std::string interval_text(const JudgedCheck& check);

/// Positions in `checks` of the `count` tightest, in ascending order: failed ones first, then undecided ones, then
/// those with the least margin.
std::vector<std::size_t> tightest(const std::vector<JudgedCheck>& checks, std::size_t count);

}  // namespace gpf
