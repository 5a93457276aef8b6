// The pictures of a report that show values, intervals and bands side by side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "verify/report_data.hpp"

namespace gpf {

/// Most checks in the picture of a claim, and of each claim in the picture of all; of more the tightest are shown.
inline constexpr std::size_t most_checks_in_picture = 40, most_checks_per_claim = 7;

/// A plot and what its caption has to say of what it leaves out.
struct Picture {
  Plot plot;
  std::string caption;
};

/// The checks of a claim beside each other, numbered from 1 as in its table: those with two edges in half widths of
/// their band or, where there is none, those with one bound by their distance to it in standard errors. Nothing when
/// neither kind is there.
std::optional<Picture> checks_picture(const Verdict& verdict);

/// All claims beside each other, numbered from 1 as in the table of claims: (value - centre of the band)/half width of
/// the band for each check with two edges. Nothing when there is none.
std::optional<Picture> bias_and_scatter(const std::vector<JudgedClaim>& claims);

}  // namespace gpf
