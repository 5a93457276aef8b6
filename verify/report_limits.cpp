#include "verify/report_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "verify/plot_files.hpp"
#include "verify/report_claim_page.hpp"
#include "verify/report_markdown.hpp"
#include "verify/verdict_summary.hpp"

namespace gpf {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> parts{
    {{"limits.hydrodynamics", "Channel hydrodynamics"},
     {"limits.monte-carlo", "Enskog Monte Carlo"},
     {"limits.soft-disks", "Soft disks"},
     {"limits.", "The engine, its models, and the advice"}}};

std::size_t part_of(const Claim& claim) {
  std::size_t k = 0;
  while (!claim.id.starts_with(parts[k].first)) ++k;
  return k;
}

}  // namespace

bool is_limit(const Claim& claim) { return claim.id.starts_with("limits."); }

std::string limits_page(const ReportData& data, const std::set<std::string>& plots) {
  std::string text;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::string section;
    for (const auto& [claim, verdict] : data.claims)
      if (is_limit(claim) && part_of(claim) == part) {
        section += fmt::format("### {}\n\n{}.\n\n[{}](claims/{}.md): **{}** - {}.\n\n", markdown_text(claim.title),
                               markdown_text(claim.statement), claim.id, claim.id, verdict_text_of(verdict),
                               markdown_text(verdict.summary));
        if (plots.contains(claim.id))
          section += plot_markdown(markdown_text(claim.title), fmt::format("claims/{}.svg", claim.id)) + "\n";
      }
    if (!section.empty()) text += fmt::format("## {}\n\n{}", parts[part].second, section);
  }
  if (text.empty()) return text;
  const bool theory = std::any_of(data.claims.begin(), data.claims.end(),
                                  [](const JudgedClaim& c) { return c.claim.id == "stress.jr.limit"; });
  return fmt::format(
      "{}# Where methods fail\n\n"
      "Each limit is a claim, judged on both sides: within it the method gives the flow of the event-driven engine, "
      "beyond\n"
      "it it does not. The program warns beyond these limits (`gpf flow`, `gpf advise`). What each method costs:\n"
      "`gpf chart`.{}\n\n{}",
      page_marker,
      theory ? " How the stresses of kinetic theory leave those that are measured:\n"
               "[stress.jr.limit](claims/stress.jr.limit.md)."
             : "",
      text);
}

}  // namespace gpf
