#include "verify/audit/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/io/markdown.hpp"
#include "gpf/stats/interval.hpp"
#include "verify/report_markdown.hpp"
#include "verify/verdict_summary.hpp"

namespace gpf {
namespace {

constexpr std::size_t most_rows = 40;

double mean_of(const ClaimEstimate& e) { return summarise(e.values).mean; }

std::string mean_text(const ClaimEstimate& e) {
  const ReplicaSummary s = summarise(e.values);
  return s.count < 2 ? fmt::format("{:.6g}", s.mean) : number_with_error(s.mean, s.standard_error());
}

double standard_errors(const Shift& s) { return s.error > 0 ? std::abs(s.difference) / s.error : INFINITY; }

/// What is judged by statistics.
std::string statistics(const Shifts& shifts) {
  const std::vector<const Shift*> moved = moved_numbers(shifts);
  std::string text;
  std::vector<std::vector<std::string>> rows;
  for (const Shift* s : moved) {
    if (rows.size() == most_rows) break;
    rows.push_back({s->before.claim, markdown_text(s->before.label), mean_text(s->before), mean_text(s->after),
                    number_with_error(s->difference, s->error), fmt::format("{:.4f}", s->p_adjusted),
                    band_text(s->before.band)});
  }
  if (!rows.empty())
    text += fmt::format(
        "{}\n", markdown_table({"claim", "number", "before", "after", "difference", "adjusted p", "band"}, rows));
  if (moved.size() > rows.size()) text += fmt::format("{} more moved.\n\n", moved.size() - rows.size());
  std::size_t equal = 0, equivalent = 0, unresolved = 0;
  std::vector<double> detectable;  // of those unresolved, in standard errors
  for (const Shift& s : shifts.all) {
    equal += s.moved == Moved::no;
    equivalent += s.moved == Moved::equivalent;
    if (s.moved != Moved::unresolved) continue;
    ++unresolved;
    if (s.error > 0 && std::isfinite(s.detectable)) detectable.push_back(s.detectable / s.error);
  }
  text += fmt::format(
      "Of {} numbers {} moved, {} are the same bits, {} are equivalent (90 % interval of the difference "
      "within half of the tolerance), {} are unresolved",
      shifts.all.size(), moved.size(), equal, equivalent, unresolved);
  if (!detectable.empty()) {
    std::nth_element(detectable.begin(), detectable.begin() + static_cast<std::ptrdiff_t>(detectable.size() / 2),
                     detectable.end());
    text += fmt::format(
        ": of these a shift of {:.1f} standard errors of the difference (median) would be found at 90 % power",
        detectable[detectable.size() / 2]);
  }
  return fmt::format("{}. Global p of \"nothing moved\": {:.4f}.\n\n", text, shifts.global_p);
}

/// Differences that need no statistics: of identities, or of anything on equal trajectories.
std::string exact_differences(const AuditFindings& f, bool equal_trajectories) {
  std::vector<const Shift*> differing;
  std::size_t harmless = 0;
  const auto collect = [&](const std::vector<Shift>& shifts) {
    for (const Shift& s : shifts) {
      if (s.moved == Moved::no) continue;
      if (!equal_trajectories && s.moved == Moved::equivalent)
        ++harmless;
      else
        differing.push_back(&s);
    }
  };
  collect(f.shifts.identities);
  if (equal_trajectories) collect(f.shifts.all);
  const std::string others =
      harmless == 0
          ? ""
          : fmt::format("{} exact numbers differ by less than half of their tolerance, on other trajectories.\n\n",
                        harmless);
  if (differing.empty()) return others;
  const auto rank = [](const Shift* s) {
    return std::abs(s->difference) / std::max(half_tolerance(s->before.band, mean_of(s->before)), 1e-300);
  };
  std::stable_sort(differing.begin(), differing.end(),
                   [&](const Shift* a, const Shift* b) { return rank(a) > rank(b); });
  std::vector<std::vector<std::string>> rows;
  for (const Shift* s : differing) {
    if (rows.size() == most_rows) break;
    rows.push_back({s->before.claim, markdown_text(s->before.label), fmt::format("{:.9g}", mean_of(s->before)),
                    fmt::format("{:.9g}", mean_of(s->after)),
                    fmt::format("{:.3g}", mean_of(s->after) - mean_of(s->before)), band_text(s->before.band)});
  }
  std::string text =
      equal_trajectories ? "On equal trajectories every difference is exact.\n\n" : "Exact numbers that differ:\n\n";
  text += fmt::format("{}\n", markdown_table({"claim", "number", "before", "after", "difference", "band"}, rows));
  if (differing.size() > rows.size())
    text += fmt::format("{} more differ, by less of their tolerance.\n\n", differing.size() - rows.size());
  return text + others;
}

}  // namespace

std::vector<const Shift*> moved_numbers(const Shifts& shifts) {
  std::vector<const Shift*> moved;
  for (const Shift& s : shifts.all)
    if (s.moved == Moved::yes) moved.push_back(&s);
  std::stable_sort(moved.begin(), moved.end(), [](const Shift* a, const Shift* b) {
    return a->p_adjusted != b->p_adjusted ? a->p_adjusted < b->p_adjusted : standard_errors(*a) > standard_errors(*b);
  });
  return moved;
}

std::string moved_part(const AuditFindings& f) {
  if (f.equal_numbers == f.numbers) return {};
  const bool equal_trajectories = f.same_trajectories();
  std::string text = "## What moved\n\n";
  if (!equal_trajectories) text += statistics(f.shifts);
  return text + exact_differences(f, equal_trajectories);
}

std::string first_difference_part(const ReplayedDifference& first) {
  const EventDifference& e = first.event;
  std::string text = fmt::format("## First difference\n\nRun {}, epoch {}", markdown_text(first.run), e.epoch);
  using How = EventDifference::Kind;
  switch (e.kind) {
    case How::numbers:
      text += fmt::format(", event {}: {}.", e.event, partners_text(e.before));
      break;
    case How::exchange:
      text += fmt::format(", event {}: {} before {}, now the other way round.", e.event, partners_text(e.before),
                          partners_text(e.after));
      break;
    case How::partners:
      text += fmt::format(", event {}: {} at {:.17g} of the epoch before, {} at {:.17g} after.", e.event,
                          partners_text(e.before), e.before.time, partners_text(e.after), e.after.time);
      break;
    case How::state:
      text += ": positions or velocities differ in bits that no contact of this and the next two epochs shows.";
      break;
  }
  if (e.other_start) text += " The states differ from the start of the run.";
  text += "\n\n";
  if (e.numbers.empty()) return text;
  std::vector<std::vector<std::string>> rows;
  for (const NumberDifference& n : e.numbers)
    rows.push_back({n.name, fmt::format("{:.17g}", n.before), fmt::format("{:.17g}", n.after),
                    fmt::format("{:.3g}", n.after - n.before), fmt::format("{:.3g}", n.relative),
                    fmt::format("{:.4g}", n.ulps)});
  return fmt::format(
      "{}{}\nUnits in the last place are those of the epoch's length for times, and of the event's largest "
      "component for velocities.\n\n",
      text, markdown_table({"", "before", "after", "difference", "relative", "ulp"}, rows));
}

}  // namespace gpf
