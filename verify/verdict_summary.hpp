// What a verdict says in words.
#pragma once

#include <string>
#include <vector>

#include "verify/judge.hpp"

namespace gpf {

/// The check that decided: of a pass the one with the least room to its band's edge in units of its interval's half
/// width, of a fail the one furthest outside, of an inconclusive verdict the undecided one that needs the most
/// replicas. Null when there is no check.
const JudgedCheck* deciding_check(const Verdict& verdict);

/// One sentence: a failed health check if there is one, else the deciding check with its number, interval and band.
std::string summary_of(const Verdict& verdict);

/// A sentence when every check passes and none uses a tenth of its band's half width, counted from the band's centre to
/// the far end of the interval: such tolerances are too wide. Else empty. Bands with an open side do not count.
std::string unused_tolerance(const std::vector<JudgedCheck>& checks);

/// "[0.9, 1.1]", "<= 1.1", ">= 0.9", or "any".
std::string band_text(const Interval& band);

/// "0.1234" with the digits that its uncertainty justifies: two of the half width `uncertainty`.
std::string rounded(double value, double uncertainty);

}  // namespace gpf
