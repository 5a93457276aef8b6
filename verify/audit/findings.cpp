#include "verify/audit/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace gpf {
namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (std::isnan(x) && std::isnan(y));
  });
}

bool inside(const ClaimEstimate& number) {
  return std::all_of(number.values.begin(), number.values.end(), [&](double x) { return number.band.contains(x); });
}

bool measured(const ClaimEstimate& number) {
  return std::any_of(number.values.begin(), number.values.end(), [](double x) { return std::isfinite(x); });
}

std::string label_of(const ClaimEstimate& number) { return fmt::format("{}: {}", number.claim, number.label); }

void measured_otherwise(const RunDigest& a, const RunDigest& b, AuditFindings& found) {
  found.other_measurements.push_back(a.name);
  if (a.sums.size() != b.sums.size()) {
    found.other_layout = true;
    found.largest_relative_sum = INFINITY;
    return;
  }
  // What differs in no sum is a structure that they do not show.
  double largest = a.sums == b.sums ? INFINITY : 0;
  for (std::size_t k = 0; k < a.sums.size(); ++k) {
    if (a.sums[k] == b.sums[k] || (std::isnan(a.sums[k]) && std::isnan(b.sums[k]))) continue;
    const double relative = std::abs(b.sums[k] - a.sums[k]) / std::max(a.sizes[k], b.sizes[k]);
    largest = std::max(largest, std::isnan(relative) ? INFINITY : relative);
  }
  found.largest_relative_sum = std::max(found.largest_relative_sum, largest);
}

/// A run's scene: "<scene> #<replica>" without the replica.
std::string scene_of(const std::string& run) { return run.substr(0, run.rfind(" #")); }

void compare_runs(const EvidenceSet& before, const EvidenceSet& after, AuditFindings& found) {
  std::set<std::string> scenes_of_both, scenes_before;
  for (const auto& [key, a] : before.runs) {
    scenes_before.insert(scene_of(a.name));
    const auto other = after.runs.find(key);
    if (other == after.runs.end()) {
      found.runs_only_before.push_back(a.name);
      continue;
    }
    ++found.runs;
    scenes_of_both.insert(scene_of(a.name));
    const RunDigest& b = other->second;
    if (a.trace_hash != b.trace_hash || a.contacts != b.contacts)
      found.other_trajectories.push_back(a.name);
    else if (a.measured != b.measured)
      measured_otherwise(a, b, found);
  }
  for (const auto& [key, b] : after.runs)
    if (!before.runs.contains(key)) found.runs_only_after.push_back(b.name);
  std::set_difference(scenes_before.begin(), scenes_before.end(), scenes_of_both.begin(), scenes_of_both.end(),
                      std::back_inserter(found.not_compared));
  for (const auto* side : {&before, &after})
    for (const std::string& record : side->missing_records)
      found.not_compared.push_back(fmt::format("the record {}", record));
  for (auto* names :
       {&found.other_trajectories, &found.other_measurements, &found.runs_only_before, &found.runs_only_after})
    std::sort(names->begin(), names->end());
}

void compare_verdicts(const EvidenceSet& before, const EvidenceSet& after, AuditFindings& found) {
  for (const auto& [id, a] : before.claims) {
    const auto other = after.claims.find(id);
    if (other == after.claims.end()) {
      found.lost.push_back(fmt::format("claim {}", id));
      continue;
    }
    const ClaimState& b = other->second;
    if (a.outcome != b.outcome || a.green != b.green) found.flips.push_back({id, a, b});
  }
}

/// Whether the claim is judged on both sides by the same file.
bool same_file(const EvidenceSet& before, const EvidenceSet& after, const std::string& claim) {
  const auto a = before.claims.find(claim), b = after.claims.find(claim);
  return a != before.claims.end() && b != after.claims.end() && a->second.claim_hash == b->second.claim_hash;
}

bool is_red(const ClaimState& claim) { return !claim.green && claim.outcome != Outcome::inconclusive; }

double mean_of(const std::vector<double>& values) { return summarise(values).mean; }

/// How far two series of values are apart, for a judgement without statistics.
void measure_difference(const ClaimEstimate& a, const ClaimEstimate& b, AuditFindings& found) {
  const double width = a.band.width();
  const double half_band = std::isfinite(width) ? width / 2 : 0;
  const std::size_t both = std::min(a.values.size(), b.values.size());
  for (std::size_t k = 0; k < both; ++k) {
    const double x = a.values[k], y = b.values[k];
    if (x == y || (std::isnan(x) && std::isnan(y))) continue;
    const double relative = std::abs(y - x) / std::max({std::abs(x), std::abs(y), half_band});
    found.largest_relative = std::max(found.largest_relative, std::isnan(relative) ? INFINITY : relative);
  }
  if (a.values.size() != b.values.size()) found.largest_relative = INFINITY;
  const double before = mean_of(a.values), difference = std::abs(mean_of(b.values) - before);
  if (!(difference <= half_tolerance(a.band, before))) found.within_half_band = false;
}

}  // namespace

double half_tolerance(Interval band, double mean) {
  if (!band.contains(mean)) return 0;
  const bool below = std::isfinite(band.lo), above = std::isfinite(band.hi);
  if (below && above) return band.width() / 4;
  return below ? (mean - band.lo) / 2 : above ? (band.hi - mean) / 2 : 0;
}

AuditFindings find_differences(const EvidenceSet& before, const EvidenceSet& after) {
  AuditFindings found;
  compare_runs(before, after, found);
  compare_verdicts(before, after, found);
  // The k-th number of a claim and label is the partner of the k-th on the other side.
  std::map<std::pair<std::string, std::string>, std::deque<ClaimEstimate>> others;
  for (const ClaimEstimate& b : after.numbers) others[{b.claim, b.label}].push_back(b);
  std::vector<ClaimEstimate> paired_before, paired_after;
  std::size_t shortened = 0;
  for (ClaimEstimate a : before.numbers) {
    std::deque<ClaimEstimate>& partners = others[{a.claim, a.label}];
    if (partners.empty()) {
      if (same_file(before, after, a.claim)) found.lost.push_back(label_of(a));
      continue;
    }
    ClaimEstimate b = std::move(partners.front());
    partners.pop_front();
    const std::size_t both = std::min(a.values.size(), b.values.size());
    if (!a.exact && !b.exact && a.values.size() != b.values.size() && both >= 2) {
      a.values.resize(both);
      b.values.resize(both);
      ++shortened;
    }
    a.exact = b.exact = a.exact || b.exact;
    ++found.numbers;
    if (same_bits(a.values, b.values)) {
      ++found.equal_numbers;
    } else {
      measure_difference(a, b, found);
      if (a.exact && inside(a) != inside(b)) found.broken_identities.push_back(label_of(a));
    }
    if (measured(a) && !measured(b)) found.lost.push_back(fmt::format("{} (not a number)", label_of(a)));
    paired_before.push_back(std::move(a));
    paired_after.push_back(std::move(b));
  }
  if (found.equal_numbers < found.numbers) found.shifts = compare(paired_before, paired_after);
  if (shortened > 0)
    found.notes.push_back(fmt::format(
        "{} numbers have more replicas on one side: only those that both sides have were compared.", shortened));
  return found;
}

PhysicsChange class_of(const AuditFindings& found, const ClassLimits& limits) {
  const bool turned_red = std::any_of(found.flips.begin(), found.flips.end(),
                                      [](const VerdictFlip& f) { return f.before.green && is_red(f.after); });
  if (turned_red || !found.lost.empty() || !found.broken_identities.empty()) return PhysicsChange::new_physics;
  const bool numbers_equal = found.equal_numbers == found.numbers;
  if (found.same_trajectories()) {
    if (numbers_equal && found.other_measurements.empty()) return PhysicsChange::bitwise;
    if (std::max(found.largest_relative, found.largest_relative_sum) <= limits.relative) return PhysicsChange::roundoff;
    // Sums that no claim shows to be harmless: none of them has moved with it.
    return found.within_half_band && !numbers_equal ? PhysicsChange::same_physics : PhysicsChange::new_physics;
  }
  if (found.shifts.global_p <= limits.global_alpha || found.shifts.identity_moved()) return PhysicsChange::new_physics;
  return found.not_compared.empty() && found.first && found.first->event.largest_ulps <= limits.ulps
             ? PhysicsChange::roundoff
             : PhysicsChange::same_physics;
}

}  // namespace gpf
