// The front page of a report.
#pragma once

#include <string>
#include <vector>

#include "verify/report_data.hpp"

namespace gpf {

/// A claim's page that an earlier report has left in the folder.
struct EarlierPage {
  std::string claim;    ///< its id
  std::string verdict;  ///< verdict_text_of(), as the page has it
};

/// The page as markdown. `earlier`: pages of data.others. `picture` is the link to the picture of all claims, empty
/// when there is none, and `picture_caption` markdown below it.
std::string front_page(const ReportData& data, const std::vector<EarlierPage>& earlier, const std::string& picture,
                       const std::string& picture_caption);

}  // namespace gpf
