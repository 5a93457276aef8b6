// Parts of an audit's page: numbers that moved, and the first event that differs.
#pragma once

#include <string>
#include <vector>

#include "verify/audit/findings.hpp"

namespace gpf {

/// Those named as moved, the smallest adjusted p-value first, then the largest difference in standard errors.
std::vector<const Shift*> moved_numbers(const Shifts& shifts);

/// Numbers that moved, and what can be said of the others.
std::string moved_part(const AuditFindings& findings);

/// The first event that differs, with each number of it.
std::string first_difference_part(const ReplayedDifference& first);

}  // namespace gpf
