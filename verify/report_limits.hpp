// The page "Where methods fail": the claims limits.* side by side.
#pragma once

#include <set>
#include <string>

#include "verify/report_data.hpp"

namespace gpf {

/// True for the claims that say where a method ends.
bool is_limit(const Claim& claim);

/// Their statements, verdicts and plots; `plots`: ids of those that have one. Empty when there is no such claim.
std::string limits_page(const ReportData& data, const std::set<std::string>& plots);

}  // namespace gpf
