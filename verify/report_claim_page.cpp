#include "verify/report_claim_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gpf/io/markdown.hpp"
#include "verify/duration_text.hpp"
#include "verify/plot_files.hpp"
#include "verify/report_check.hpp"
#include "verify/report_markdown.hpp"
#include "verify/verdict_summary.hpp"

namespace gpf {
namespace {

/// Longer tables are folded, and the tightest rows shown above.
constexpr std::size_t longest_open_table = 12, rows_above_folded_table = 5;

std::string section(std::string_view title, const std::string& text) {
  return text.empty() ? "" : fmt::format("\n## {}\n\n{}", title, text);
}

/// A list of all items but `not_this`.
std::string list(const std::vector<std::string>& items, std::string_view not_this = {}) {
  std::string text;
  for (const std::string& item : items)
    if (item != not_this) text += fmt::format("- {}\n", markdown_text(item));
  return text;
}

/// Of a tier that reads fewer scenes than a higher one: what is stated is tested in part.
std::string part_text(const Claim& claim, Tier tier) {
  const std::size_t here = claim.scenes_in(tier).size(), all = claim.scenes_in(Tier::full).size();
  if (here >= all) return {};
  return fmt::format("\nIn part: this tier reads {} of the {} scenes that the claim has in higher tiers.\n", here, all);
}

std::string head(const Claim& claim, const Verdict& verdict) {
  std::string text = fmt::format("# {}: {}\n\n[All claims](../README.md)\n\n", claim.id, markdown_text(claim.title));
  text += fmt::format("> {}\n\n", markdown_text(claim.statement));
  text += fmt::format("**Source:** chapter {}, {}\n\n", claim.chapter, markdown_text(claim.source));
  text += fmt::format("**Method:** {}\n\n", markdown_text(claim.method));
  text += fmt::format("**Verdict: {}.** {}\n", verdict_text_of(verdict), markdown_text(verdict.summary));
  if (!claim.expected_because.empty())
    text += fmt::format("\n**Why {}:** {}\n", name_of(claim.expected), markdown_text(claim.expected_because));
  text += fmt::format("\nTier {}, {} replica(s), look {}", name_of(verdict.tier), verdict.replicas, verdict.look);
  const auto statistical = [&](bool share) {
    return std::any_of(verdict.checks.begin(), verdict.checks.end(),
                       [&](const JudgedCheck& c) { return !c.check.exact && c.check.share == share; });
  };
  if (statistical(false)) text += fmt::format("; each end of an interval errs with probability {:.2g}", verdict.alpha);
  if (statistical(true))  // judged at its own level, shared over as many looks
    text += fmt::format("; each end of the interval of a share errs with probability {:.2g}",
                        verdict.alpha * share_alpha_per_direction / alpha_per_direction);
  return text + ".\n" + part_text(claim, verdict.tier);
}

std::string table_of(const std::vector<JudgedCheck>& checks, const std::vector<std::size_t>& rows) {
  std::vector<std::vector<std::string>> cells;
  for (const std::size_t i : rows) {
    const JudgedCheck& c = checks[i];
    const std::string outcome(name_of(c.outcome));
    cells.push_back({fmt::format("{}", i + 1), markdown_text(c.check.label), value_text(c), interval_text(c),
                     band_text(c.check.band), margin_text(c),
                     c.outcome == Outcome::pass ? outcome : fmt::format("**{}**", outcome)});
  }
  return markdown_table({"#", "check", "mean", "interval", "band", "margin", "outcome"}, cells);
}

std::string checks_text(const Verdict& verdict) {
  const auto& checks = verdict.checks;
  if (checks.empty()) return {};
  const std::string all = table_of(checks, tightest(checks, checks.size()));
  std::string text = all;
  if (checks.size() > longest_open_table)
    text = fmt::format("The tightest:\n\n{}\n<details>\n<summary>All {} checks</summary>\n\n{}\n</details>\n",
                       table_of(checks, tightest(checks, rows_above_folded_table)), checks.size(), all);
  const bool beyond = std::any_of(checks.begin(), checks.end(), [](const JudgedCheck& c) {
    return c.outcome == Outcome::inconclusive && (c.interval.lo > c.check.band.hi || c.interval.hi < c.check.band.lo);
  });
  if (beyond)
    text +=
        "\nInconclusive although its interval lies outside of the band: with so many checks one would be seen there by "
        "chance, and Holm's correction asks for more.\n";
  return text +
         "\nMargin: distance from the mean to the nearest edge of its band in standard errors (se), negative "
         "outside; of an exact check how far its worst value is from the band's centre.\n";
}

std::string budget_text(const Claim& claim, const Verdict& verdict) {
  std::string text;
  if (!claim.tolerance.empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const ToleranceTerm& term : claim.tolerance)
      rows.push_back({markdown_text(term.name), fmt::format("{:.4g}", term.value), markdown_text(term.evidence)});
    rows.push_back({"**total**", fmt::format("{:.4g}", claim.tolerance_total()), ""});
    text =
        markdown_table({"term", fmt::format("half width ({})", markdown_text(claim.tolerance_unit)), "evidence"}, rows);
  }
  if (const std::string unused = unused_tolerance(verdict.checks); !unused.empty())
    text += fmt::format("{}**Ratchet:** {}\n", text.empty() ? "" : "\n", markdown_text(unused));
  return text;
}

/// Failures one by one; passed checks by kind, which is the name up to a colon.
std::string health_text(const std::vector<HealthCheck>& health) {
  std::string text;
  std::vector<std::pair<std::string, std::vector<const HealthCheck*>>> kinds;
  for (const HealthCheck& h : health) {
    if (!h.passed) {
      text += fmt::format("- **failed:** {}: {}\n", markdown_text(h.name), markdown_text(h.detail));
      continue;
    }
    const std::string kind = h.name.substr(0, h.name.find(": "));
    auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == kind; });
    if (found == kinds.end()) found = kinds.insert(found, {kind, {}});
    found->second.push_back(&h);
  }
  for (const auto& [kind, passed] : kinds)
    text += passed.size() == 1 ? fmt::format("- passed: {}: {}\n", markdown_text(passed.front()->name),
                                             markdown_text(passed.front()->detail))
                               : fmt::format("- passed: {}, {} times\n", markdown_text(kind), passed.size());
  return text;
}

std::string drawings_text(const Verdict& verdict, const ClaimPictures& pictures) {
  std::string text;
  for (std::size_t k = 0; k < pictures.drawings.size(); ++k) {
    const std::string title = markdown_text(verdict.drawings[k].title);
    text += fmt::format("{}{}:\n\n![{}]({})\n", k == 0 ? "" : "\n", title, title, pictures.drawings[k]);
  }
  return text;
}

std::string cost_text(const Claim& claim, const Verdict& verdict, const std::string& folders) {
  std::string text = fmt::format("{} of CPU time", duration_text(verdict.cpu_seconds));
  const std::vector<std::string> scenes = claim.scenes_in(verdict.tier);
  if (scenes.empty())
    text += ", without the run of a scene.\n";
  else
    text += fmt::format(", runs that other claims read as well included: {} run(s) each of {}.\n", verdict.replicas,
                        fmt::join(scenes, ", "));
  text += fmt::format("\n    gpf validate --tier {}{}", name_of(verdict.tier), folders);
  if (verdict.release_seed != 0) text += fmt::format(" --release-seed {}", verdict.release_seed);
  return text + fmt::format(" {}\n", verdict.claim_id);
}

}  // namespace

std::string verdict_text_of(const Verdict& verdict) {
  return fmt::format("{}, {}", name_of(verdict.outcome),
                     verdict.green ? fmt::format("as expected ({})", name_of(verdict.expected))
                                   : fmt::format("expected {}", name_of(verdict.expected)));
}

std::string claim_page(const JudgedClaim& judged, const ClaimPictures& pictures,
                       const std::vector<ReleaseEntry>& history, const std::string& folders) {
  const auto& [claim, verdict] = judged;
  std::string text = page_marker + head(claim, verdict);
  if (!pictures.checks.empty())
    text += section(
        "Value, interval and band",
        fmt::format("{}\n{}\n", plot_markdown("checks of " + claim.id, pictures.checks), pictures.checks_caption));
  if (!pictures.plot.empty()) text += section("Plot", plot_markdown(claim.id, pictures.plot));
  if (!pictures.drawings.empty()) text += section("Snapshots", drawings_text(judged.verdict, pictures));
  text += section("Checks", checks_text(verdict));
  text += section("Tolerance budget", budget_text(claim, verdict));
  text += section("Health checks", health_text(verdict.health));
  text += section("Notes", list(verdict.notes, unused_tolerance(verdict.checks)));
  text += section("What it is there to catch", list(claim.catches));
  text += section("History", history_table(history));
  return text + section("Cost, and how to reproduce it", cost_text(claim, verdict, folders));
}

}  // namespace gpf
