#include "verify/audit/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/io/record.hpp"
#include "verify/audit/findings.hpp"
#include "verify/planner.hpp"
#include "verify/validate.hpp"
#include "verify/verdict_file.hpp"

namespace gpf {
namespace {

/// Both values are equal as far as the file says.
bool agree(double a, double b, Interval band) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return true;
  const double scale = std::max({std::abs(a), std::abs(b), std::isfinite(band.width()) ? band.width() : 0.0});
  return std::abs(a - b) <= baseline_precision * scale;
}

bool judged_alike(const ClaimEstimate& a, const ClaimEstimate& b) {
  const auto same = [](double x, double y) { return x == y || std::abs(x - y) <= baseline_precision * std::abs(x); };
  return a.exact == b.exact && a.share == b.share && same(a.band.lo, b.band.lo) && same(a.band.hi, b.band.hi);
}

bool agree(const ClaimEstimate& a, const ClaimEstimate& b) {
  return std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                    [&](double x, double y) { return agree(x, y, a.band); });
}

/// By claim, and by label with its ordinal where a claim has several of that label.
std::map<std::pair<std::string, std::string>, const ClaimEstimate*> by_label(const EvidenceSet& set) {
  std::map<std::pair<std::string, std::string>, const ClaimEstimate*> found;
  for (const ClaimEstimate& e : set.numbers) {
    int ordinal = 1;
    std::string label = e.label;
    while (!found.emplace(std::pair{e.claim, label}, &e).second) label = fmt::format("{} ({})", e.label, ++ordinal);
  }
  return found;
}

/// Whether something of the old baseline is gone, or judged otherwise.
bool unseen(const EvidenceSet& before, const EvidenceSet& after) {
  for (const auto& [name, run] : before.runs)
    if (!after.runs.contains(name)) return true;
  const auto old = by_label(before), now = by_label(after);
  return std::any_of(old.begin(), old.end(), [&](const auto& entry) {
    const auto found = now.find(entry.first);
    return found == now.end() || !judged_alike(*entry.second, *found->second);
  });
}

}  // namespace

EvidenceSet baseline_evidence(const std::filesystem::path& store, const std::filesystem::path& reference) {
  EvidenceSet set;
  const std::uint64_t program = program_hash();
  Demand demand;
  for (const Claim& claim : load_claims(reference / "claims")) {
    if (!claim.judged_in(Tier::quick)) continue;
    if (!std::filesystem::exists(verdict_path(store, Tier::quick, claim.id)))
      throw InputError(fmt::format("'{}' has no verdict on claim '{}'", store.string(), claim.id),
                       "a baseline is made of all claims of tier quick",
                       fmt::format("gpf validate --tier quick --store {}", store.string()));
    const Verdict verdict = read_verdict(store, Tier::quick, claim.id);
    if (verdict.claim_hash != claim.text_hash || (program != 0 && verdict.program_hash != program))
      throw InputError(fmt::format("the verdict on claim '{}' in '{}' is out of date", claim.id, store.string()),
                       "the claim file or the program has changed since",
                       fmt::format("gpf validate --tier quick --store {}", store.string()));
    for (const JudgedCheck& check : verdict.checks) set.numbers.push_back(estimate_of(claim.id, check));
    add_demand(demand, claim, Tier::quick, looks_up_to(claim.replicas_in(Tier::quick)).front());
  }
  const RecordStore records(store, trust_in(Tier::quick));
  SceneLibrary scenes(reference);
  for (const auto& [name, replicas] : demand)
    for (const NamedScene& scene : scenes.of(name))
      for (int replica = 0; replica < replicas; ++replica) {
        const std::string run = fmt::format("{} #{}", scene.name, replica + 1);
        const auto record = records.load(replica_of(scene, replica, 0));
        if (!record)
          throw InputError(fmt::format("'{}' lacks the record of {}", store.string(), run),
                           "a baseline is made of all runs of the first look",
                           fmt::format("gpf validate --tier quick --store {}", store.string()));
        set.runs[run].name = run;
        set.runs[run].trace_hash = record->trace_hash;
      }
  return set;
}

std::vector<std::string> baseline_differences(const EvidenceSet& baseline, const EvidenceSet& now) {
  std::vector<std::string> lines;
  for (const auto& [name, run] : baseline.runs) {
    const auto found = now.runs.find(name);
    if (found == now.runs.end())
      lines.push_back(fmt::format("run {} is no longer made", name));
    else if (found->second.trace_hash != run.trace_hash)
      lines.push_back(fmt::format("run {}: trace hash {}, in the baseline {}", name,
                                  hexadecimal(found->second.trace_hash), hexadecimal(run.trace_hash)));
  }
  for (const auto& [name, run] : now.runs)
    if (!baseline.runs.contains(name)) lines.push_back(fmt::format("run {} is not in the baseline", name));
  const auto before = by_label(baseline), after = by_label(now);
  for (const auto& [label, a] : before) {
    const auto found = after.find(label);
    if (found == after.end())
      lines.push_back(fmt::format("claim {} no longer has: {}", label.first, label.second));
    else if (!judged_alike(*a, *found->second))
      lines.push_back(fmt::format("claim {}, {}: another kind or band", label.first, label.second));
    else if (!agree(*a, *found->second))
      lines.push_back(fmt::format("claim {}, {}: {:.9g}, in the baseline {:.9g}", label.first, label.second,
                                  fmt::join(found->second->values, " "), fmt::join(a->values, " ")));
  }
  for (const auto& [label, b] : after)
    if (!before.contains(label))
      lines.push_back(fmt::format("claim {} is not in the baseline with: {}", label.first, label.second));
  return lines;
}

PhysicsChange least_class(const EvidenceSet& before, const EvidenceSet& after) {
  const AuditFindings found = find_differences(before, after);
  ClassLimits limits;
  limits.relative = baseline_precision;
  const PhysicsChange change = class_of(found, limits);
  const bool replay_could_tell = change == PhysicsChange::same_physics && !found.other_trajectories.empty();
  if (unseen(before, after)) return std::max(change, PhysicsChange::same_physics);
  return replay_could_tell ? PhysicsChange::roundoff : change;
}

}  // namespace gpf
