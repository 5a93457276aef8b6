// The page of one claim.
#pragma once

#include <string>

#include "verify/report_data.hpp"

namespace gpf {

/// First line of every page: whatever starts with it was written by a report, and may be removed by the next one.
inline constexpr const char* page_marker = "<!-- Written by `gpf report` from verdicts and records: do not edit. -->\n";

/// What is beside the page. Links are relative to it; empty where there is no picture.
struct ClaimPictures {
  std::string checks, checks_caption;  ///< link to the picture of its checks, and markdown below it
  std::string plot;                    ///< link to the claim's own plot
  std::vector<std::string> drawings;   ///< links to the verdict's drawings, in their order
};

/// The page as markdown. Parts for which there is nothing are left out. `history`: of the claim; `folders` as in
/// ReportData.
std::string claim_page(const JudgedClaim& judged, const ClaimPictures& pictures,
                       const std::vector<ReleaseEntry>& history = {}, const std::string& folders = {});

/// "fail, as expected (refuted)", "fail, expected reproduced".
std::string verdict_text_of(const Verdict& verdict);

}  // namespace gpf
