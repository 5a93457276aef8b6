#include "verify/report_front_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "gpf/io/markdown.hpp"
#include "verify/duration_text.hpp"
#include "verify/plot_files.hpp"
#include "verify/report_check.hpp"
#include "verify/report_claim_page.hpp"
#include "verify/report_limits.hpp"
#include "verify/report_markdown.hpp"
#include "verify/verdict_summary.hpp"

namespace gpf {
namespace {

std::string link_to(const std::string& id) { return fmt::format("[{}](claims/{}.md)", id, id); }

bool is_red(const JudgedClaim& c) { return !c.verdict.green && c.verdict.outcome != Outcome::inconclusive; }
bool is_open(const JudgedClaim& c) { return !c.verdict.green && c.verdict.outcome == Outcome::inconclusive; }

std::string totals(const ReportData& data) {
  const auto red = std::count_if(data.claims.begin(), data.claims.end(), is_red),
             open = std::count_if(data.claims.begin(), data.claims.end(), is_open);
  const auto all = static_cast<std::ptrdiff_t>(data.claims.size());
  std::string text = fmt::format(
      "**{} claim(s): {} as expected, {} red, {} inconclusive.** {} run(s), {:.3g} collisions, "
      "{} of CPU time",
      all, all - red - open, red, open, data.runs, static_cast<double>(data.collisions),
      duration_text(data.cpu_seconds));
  if (!data.dates.empty()) {
    text += fmt::format("; run on {}", markdown_text(*data.dates.begin()));
    if (data.dates.size() > 1) text += fmt::format(" to {}", markdown_text(*data.dates.rbegin()));
  }
  return text + ".\n";
}

/// Red ones first, then those that need more data; a claim whose inconclusive answer was expected is neither.
std::string troubles(const ReportData& data) {
  std::string text;
  for (const auto condition : {is_red, is_open})
    for (const JudgedClaim& c : data.claims)
      if (condition(c))
        text += fmt::format("- {}: **{}** - {}\n", link_to(c.claim.id), verdict_text_of(c.verdict),
                            markdown_text(c.verdict.summary));
  return text.empty() ? "None.\n" : text;
}

/// What the source says and the simulation contradicts, or cannot decide, as the claim files say.
std::string departures(const ReportData& data) {
  std::string text;
  for (const JudgedClaim& c : data.claims)
    if (c.claim.expected != Expectation::reproduced)
      text += fmt::format("- {} ({}): {}\n  - because: {}\n", link_to(c.claim.id), name_of(c.claim.expected),
                          markdown_text(c.claim.statement), markdown_text(c.claim.expected_because));
  return text.empty() ? "" : "\n## Expected to be refuted or unresolved\n\n" + text;
}

std::string errata_link(const ReportData& data) {
  if (data.errata.empty()) return {};
  return fmt::format(
      "\n## Errata of the source\n\n[{} place(s)](errata.md) where the source cannot mean what it prints.\n",
      data.errata.size());
}

std::string limits_link(const ReportData& data) {
  const auto limits =
      std::count_if(data.claims.begin(), data.claims.end(), [](const JudgedClaim& c) { return is_limit(c.claim); });
  if (limits == 0) return {};
  return fmt::format(
      "\n## Where methods fail\n\n[{} claim(s)](limits.md) on the limits of the engine and of the other methods.\n",
      limits);
}

std::string claims_table(const ReportData& data) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [claim, verdict] : data.claims) {
    const JudgedCheck* deciding = deciding_check(verdict);
    const std::string outcome(name_of(verdict.outcome));
    rows.push_back({fmt::format("{}", rows.size() + 1), link_to(claim.id), markdown_text(claim.statement),
                    std::string(name_of(verdict.expected)), verdict.green ? outcome : fmt::format("**{}**", outcome),
                    fmt::format("{}", verdict.replicas), deciding == nullptr ? "-" : margin_text(*deciding),
                    fmt::format("{:.1f}", verdict.cpu_seconds)});
  }
  return markdown_table({"#", "claim", "statement", "expected", "outcome", "replicas", "tightest margin", "CPU s"},
                        rows);
}

std::string earlier_pages(const ReportData& data, const std::vector<EarlierPage>& earlier) {
  if (earlier.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const EarlierPage& page : earlier) {
    const auto claim =
        std::find_if(data.others.begin(), data.others.end(), [&](const Claim& c) { return c.id == page.claim; });
    rows.push_back({link_to(page.claim), markdown_text(claim->statement), markdown_text(page.verdict)});
  }
  return "\n## Pages of earlier reports\n\nOn other claims of this tier. Only their pages say on what runs they "
         "rest.\n\n" +
         markdown_table({"claim", "statement", "verdict"}, rows);
}

std::string runs_table(const ReportData& data) {
  if (data.scenes.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const auto& [scene, cost] : data.scenes) {
    std::string claims;
    for (const std::string& id : cost.claims) claims += (claims.empty() ? "" : ", ") + link_to(id);
    rows.push_back({scene, claims, fmt::format("{}", cost.records.size()),
                    fmt::format("{:.3g}", static_cast<double>(cost.collisions)),
                    fmt::format("{:.1f}", cost.cpu_seconds)});
  }
  return "\n## Runs, and the claims that they serve\n\n" +
         markdown_table({"scene", "claims", "records", "collisions", "CPU s"}, rows);
}

std::string release_seed_option(const ReportData& data) {
  for (const JudgedClaim& c : data.claims)
    if (c.verdict.release_seed != 0) return fmt::format(" --release-seed {}", c.verdict.release_seed);
  return {};
}

std::string reproduction(const ReportData& data) {
  std::string text = "\n## How to reproduce it\n\n";
  if (data.tier == Tier::quick && data.folders.empty())
    text += "From a fresh clone on Debian 12, dependencies included:\n\n    verify/quick\n\nOr, with gpf built:\n\n";
  std::string chosen;
  if (data.claims.size() < data.of_claims) {
    for (const JudgedClaim& c : data.claims) chosen += " " + c.claim.id;
  }
  text += fmt::format("    gpf validate --tier {}{}{}{}\n    gpf report --tier {}{}{}{}\n", name_of(data.tier),
                      data.folders, release_seed_option(data), chosen, name_of(data.tier), data.folders,
                      chosen.empty() ? "" : " --output FOLDER", chosen);
  return text + "\nThe seeds of this tier are " +
         (data.tier == Tier::quick
              ? "fixed, so that a verdict changes only when the program does.\n"
              : "those of the release: another release draws other replicas. The points of a campaign are the "
                "exception:\ntheir replicas are those that gpf campaign makes, in every release.\n");
}

std::string provenance(const ReportData& data) {
  constexpr std::array<std::pair<const char*, const char*>, 7> lines{{{"version", "gpf"},
                                                                      {"commit", "commit"},
                                                                      {"compiler", "compiler"},
                                                                      {"flags", "flags"},
                                                                      {"libraries", "libraries"},
                                                                      {"cpu", "CPU"},
                                                                      {"system", "system"}}};
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, name] : lines) {
    const auto found = data.provenance.find(key);
    if (found == data.provenance.end()) continue;
    std::string values;
    for (const std::string& value : found->second) values += (values.empty() ? "" : "; ") + markdown_text(value);
    rows.push_back({name, values});
  }
  if (rows.empty()) return {};
  return "\n## Provenance of the records\n\n" + markdown_table({"", "of all records"}, rows);
}

}  // namespace

std::string front_page(const ReportData& data, const std::vector<EarlierPage>& earlier, const std::string& picture,
                       const std::string& picture_caption) {
  std::string text = page_marker;
  const bool chosen = data.claims.size() < data.of_claims;
  text +=
      fmt::format("# Validation report, tier {}{}\n\n{}", name_of(data.tier),
                  chosen ? fmt::format(", {} of its {} claims", data.claims.size(), data.of_claims) : "", totals(data));
  if (data.folders.empty())
    text +=
        "\nChapters, sections, figures and equations are those of V. K. Chikkadi's thesis *Particle Dynamics "
        "Simulation of "
        "Gravity Driven Granular\nPoiseuille Flow*. nu: area fraction; e_n: normal restitution of two disks, 1 "
        "elastic; "
        "beta_w: tangential restitution of a wall, 1 smooth;\nd, W, L: diameter of a disk, width and length of the "
        "channel; "
        "T: granular temperature; N_1: first normal stress difference; Kn: Knudsen\nnumber. Refuted: the simulation "
        "contradicts the source, as the claim expects and its page shows.\n";
  text += "\n## Red or inconclusive\n\n" + troubles(data);
  text +=
      "\n## Claims\n\n" + claims_table(data) +
      "\nMargin: distance from the mean to the nearest edge of its band in standard errors (se), negative outside; of "
      "an exact check\nhow far its worst value is from the band's centre. CPU time counts shared runs for each claim "
      "that reads them.\n";
  if (!picture.empty())
    text += fmt::format(
        "\n## Bias and scatter\n\n{}\n"
        "Each point is a check, in half widths of its band around the band's centre; the bar is its "
        "confidence interval.\nA claim passes when all its bars lie in the shaded band.{}\n",
        plot_markdown("bias and scatter of all claims", picture), picture_caption);
  return text + departures(data) + earlier_pages(data, earlier) + limits_link(data) + errata_link(data) +
         runs_table(data) + reproduction(data) + provenance(data);
}

}  // namespace gpf
