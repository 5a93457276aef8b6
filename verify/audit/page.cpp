#include "verify/audit/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "gpf/io/markdown.hpp"
#include "gpf/stats/interval.hpp"
#include "verify/audit/page_parts.hpp"
#include "verify/report_markdown.hpp"

namespace gpf {
namespace {

std::string moved_text(const AuditReport& report) {
  const AuditFindings& f = report.findings;
  if (report.same_sources)
    return "No file that simulates, measures or judges, and none that is judged, differs; nothing was run.";
  if (report.found == PhysicsChange::bitwise)
    return fmt::format("All {} runs have the same trace hashes and measured bits, all {} numbers of claims are equal.",
                       f.runs, f.numbers);
  std::vector<std::string> parts;
  if (!f.other_trajectories.empty())
    parts.push_back(fmt::format("{} of {} runs go other ways", f.other_trajectories.size(), f.runs));
  else if (!f.not_compared.empty())
    parts.push_back(fmt::format("the {} runs that could be compared are equal", f.runs));
  else if (!f.other_measurements.empty())
    parts.push_back(fmt::format("the trajectories of all {} runs are equal, {} were measured otherwise", f.runs,
                                f.other_measurements.size()));
  else
    parts.push_back(fmt::format("all {} runs are equal, {} of {} numbers of claims are not", f.runs,
                                f.numbers - f.equal_numbers, f.numbers));
  if (!f.not_compared.empty())
    parts.push_back(fmt::format("{} scene(s) or record(s) could not be compared", f.not_compared.size()));
  if (!f.same_trajectories()) {
    const auto named = moved_numbers(f.shifts);
    if (named.empty()) {
      parts.push_back(fmt::format("no number is named as moved (global p {:.2g})", f.shifts.global_p));
    } else {
      parts.push_back(fmt::format("{} number(s) moved (global p {:.2g}), foremost {} in claim {}", named.size(),
                                  f.shifts.global_p, markdown_text(named.front()->before.label),
                                  named.front()->before.claim));
    }
  } else if (f.equal_numbers < f.numbers) {
    parts.push_back(fmt::format("values differ by up to {:.2g} relative, {} half of their tolerance",
                                f.largest_relative, f.within_half_band ? "within" : "and some by more than"));
  }
  if (!f.broken_identities.empty())
    parts.push_back(fmt::format("{} exact number(s) lie in their band on one side only, among them {}",
                                f.broken_identities.size(), markdown_text(f.broken_identities.front())));
  if (!f.flips.empty()) parts.push_back(fmt::format("{} verdict(s) are others", f.flips.size()));
  if (!f.lost.empty()) parts.push_back(fmt::format("{} claim(s) or numbers got lost", f.lost.size()));
  std::string text = fmt::format("{}.", fmt::join(parts, "; "));
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string list_of(const std::string& title, const std::vector<std::string>& names, std::size_t most = 20) {
  if (names.empty()) return {};
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())));
  std::string text =
      fmt::format("{} ({}): {}", title, names.size(), markdown_text(fmt::format("{}", fmt::join(first, "; "))));
  return fmt::format("{}{}.\n\n", text, names.size() > most ? fmt::format(" and {} more", names.size() - most) : "");
}

std::string flips_part(const AuditFindings& f) {
  if (f.flips.empty()) return {};
  const auto said = [](const ClaimState& c) {
    return fmt::format("{}, {}", name_of(c.outcome), c.green ? "green" : "not green");
  };
  std::vector<std::vector<std::string>> rows;
  for (const VerdictFlip& flip : f.flips)
    rows.push_back({flip.claim, said(flip.before), said(flip.after), markdown_text(flip.after.summary)});
  return fmt::format("## Verdicts that are others\n\n{}\n", markdown_table({"claim", "before", "after", "now"}, rows));
}

/// Runs as "<scene> (<how many>)": replicas of a scene seldom differ in what became of them.
std::vector<std::string> scenes_of(const std::vector<std::string>& runs) {
  std::map<std::string, int> counts;
  for (const std::string& run : runs) ++counts[run.substr(0, run.rfind(" #"))];
  std::vector<std::string> scenes;
  for (const auto& [scene, count] : counts) scenes.push_back(fmt::format("{} ({})", scene, count));
  return scenes;
}

std::string runs_part(const AuditFindings& f) {
  std::string text = list_of("Scenes (runs) of other trajectories", scenes_of(f.other_trajectories), 100);
  text += list_of("Of the same trajectories, measured otherwise", scenes_of(f.other_measurements), 100);
  text += list_of("Not compared, because no run of it is on both sides", f.not_compared, 100);
  text += list_of("Only before", scenes_of(f.runs_only_before), 100);
  text += list_of("Only after", scenes_of(f.runs_only_after), 100);
  if (!f.other_measurements.empty())
    text += f.other_layout
                ? "Other sums are kept, so they cannot be compared one by one.\n\n"
                : fmt::format("Measured sums differ by up to {:.2g} of what was added up.\n\n", f.largest_relative_sum);
  return text.empty() ? text : fmt::format("## Scenes affected\n\n{}", text);
}

std::string environment_part(const std::vector<EnvironmentFact>& facts) {
  std::vector<std::vector<std::string>> rows;
  for (const EnvironmentFact& fact : facts)
    if (fact.before != fact.after) rows.push_back({fact.name, markdown_text(fact.before), markdown_text(fact.after)});
  if (facts.empty()) return {};
  if (rows.empty()) return "## Environment\n\nThe same commit, compiler, flags, libraries and CPU.\n\n";
  return fmt::format("## Environment\n\n{}\n", markdown_table({"", "before", "after"}, rows));
}

std::string cost_part(const CostComparison& cost) {
  const auto nanoseconds = [](const std::vector<double>& rounds) {
    return fmt::format("{:.1f} to {:.1f}", 1e9 * *std::min_element(rounds.begin(), rounds.end()),
                       1e9 * *std::max_element(rounds.begin(), rounds.end()));
  };
  std::string text = "## Cost\n\n";
  if (cost.interleaved)
    text += fmt::format(
        "CPU time per collision, after over before: {:.3f} (ratio of medians of {} interleaved rounds; of single "
        "rounds "
        "{:.3f} to {:.3f}; {} ns before, {} ns after). Peak memory {:.1f} MB before, {:.1f} MB after.\n\n",
        cost.ratio, cost.before.size(), cost.least, cost.most, nanoseconds(cost.before), nanoseconds(cost.after),
        cost.memory_before / 1e6, cost.memory_after / 1e6);
  else
    text += fmt::format(
        "CPU time per collision, after over before: {:.3f}, from what the records say of themselves: made at other "
        "times "
        "and not interleaved, so the machine's load is part of it.\n\n",
        cost.ratio);
  return text;
}

}  // namespace

std::string answer_of(const AuditReport& report) {
  std::string text = fmt::format("**{}**", name_of(report.found));
  if (report.declared)
    text +=
        fmt::format(", declared {}: **{}**", name_of(*report.declared), report.rejected() ? "rejected" : "accepted");
  return fmt::format("{}. {}", text, moved_text(report));
}

std::string audit_page(const AuditReport& report) {
  const AuditFindings& f = report.findings;
  std::string text = fmt::format("# Audit of {} against {}\n\n{}\n\n", markdown_text(report.after),
                                 markdown_text(report.before), answer_of(report));
  if (report.same_sources) return text;
  text += moved_part(f);
  text += list_of("Exact numbers that lie in their band on one side only", f.broken_identities);
  text += list_of("No longer there", f.lost);
  text += flips_part(f);
  text += runs_part(f);
  if (!f.other_trajectories.empty())
    text += f.first ? first_difference_part(*f.first)
                    : fmt::format("## First difference\n\n{}\n\n", markdown_text(report.why_no_replay));
  text += environment_part(report.environment);
  if (report.cost) text += cost_part(*report.cost);
  for (const std::string& note : f.notes) text += fmt::format("{}\n\n", markdown_text(note));
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace gpf
