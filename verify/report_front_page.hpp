// The front page of a report.
#pragma once

#include <string>

#include "verify/report_data.hpp"

namespace gpf {

/// The page as markdown. `picture` is the link to the picture of all claims, empty when there is none, and
/// `picture_caption` markdown below it.
std::string front_page(const ReportData& data, const std::string& picture, const std::string& picture_caption);

}  // namespace gpf
