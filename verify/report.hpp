// The report of a tier: pages and pictures made from verdicts and records alone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verify/claim.hpp"
#include "verify/report_data.hpp"

namespace gpf {

struct ReportOptions {
  Tier tier = Tier::quick;
  std::filesystem::path store = "records", reference = "reference", output;
  std::vector<std::string> claims{};  ///< those to report on; none: all of the tier
  bool release = false;               ///< keep what this version found in <output>/history/
};

/// Writes
///   <output>/README.md, bias-and-scatter.svg     the front page
///   <output>/errata.md                         errata of the source, when there is a list
///   <output>/limits.md                         where methods fail, when claims limits.* are among them
///   <output>/claims/<id>.md, <id>.svg            a page per claim, and the claim's own plot
///   <output>/checks/<id>.svg                     its checks against their bands
///   NAME.csv beside each NAME.svg that is a plot  its numbers
///   <output>/history/<version>.csv               for a release
/// and removes pages of an earlier report whose claim is gone, with their pictures. Runs no physics; equal verdicts and
/// records give equal bytes. Returns the path of the front page.
/// Throws what load_report_data throws, and StorageError when a file cannot be written or a picture not be drawn.
std::filesystem::path write_report(const ReportOptions& options);

/// The same from data at hand.
std::filesystem::path write_report(const ReportData& data, const std::filesystem::path& output);

}  // namespace gpf
