#include "verify/audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"
#include "verify/audit/git.hpp"
#include "verify/audit/replay.hpp"
#include "verify/claim.hpp"
#include "verify/file_lock.hpp"

namespace gpf {
namespace {

/// Replays the run with the fewest contacts whose hashes differ.
void find_first_difference(const AuditOptions& options, const Side& before, const Side& after, const EvidenceSet& a,
                           const EvidenceSet& b, AuditReport& report) {
  if (report.findings.other_trajectories.empty()) return;
  if (!before.has_program() || !after.has_program()) {
    report.why_no_replay =
        "Stores without their programs cannot be replayed: audit the revisions to see the first event that differs.";
    return;
  }
  const std::pair<const std::string, RunDigest>* shortest = nullptr;
  for (const auto& run : a.runs) {
    const auto other = b.runs.find(run.first);
    if (other == b.runs.end() || other->second.trace_hash == run.second.trace_hash) continue;
    if (shortest == nullptr || run.second.contacts < shortest->second.contacts) shortest = &run;
  }
  if (shortest == nullptr) return;
  const auto& [text, run] = *shortest;
  fmt::print(stderr, "gpf audit: replaying {}\n", run.name);
  try {
    const auto epochs = static_cast<std::int64_t>(std::ceil(run.time / run.epoch_length));
    const auto event = replay({text, epochs, run.epoch_length, before.program, after.program, options.sides.work,
                               [&] { stop_if_asked(options.sides); }, options.sides.stop});
    if (event)
      report.findings.first = {run.name, *event};
    else
      report.why_no_replay =
          fmt::format("The engines agree on {} to its end: what differs is how a run is set up or watched.", run.name);
  } catch (const InputError& error) {
    report.why_no_replay = error.what();
  }
}

void compare_cost(const AuditOptions& options, const Side& before, const Side& after, const EvidenceSet& a,
                  const EvidenceSet& b, AuditReport& report) {
  if (!before.has_program() || !after.has_program()) {
    report.cost = cost_of_records(a, b);
    return;
  }
  fmt::print(stderr, "gpf audit: measuring cost\n");
  try {
    report.cost = measure_cost(before.program, after.program, options.sides.work, 5, options.sides.stop);
  } catch (const Error& error) {
    stop_if_asked(options.sides);
    report.findings.notes.push_back(fmt::format("Cost was not measured: {}", error.what()));
  }
}

/// Claims that were asked for and have a verdict on neither side.
void find_unjudged(const std::vector<std::string>& asked, const EvidenceSet& a, const EvidenceSet& b,
                   AuditFindings& findings) {
  for (const std::string& id : asked)
    if (!a.claims.contains(id) && !b.claims.contains(id))
      findings.lost.push_back(fmt::format("claim {} (judged on neither side)", id));
}

/// The claims of tier quick in a tree; none when this program cannot read them.
std::vector<std::string> quick_claims(const std::filesystem::path& reference) {
  std::vector<std::string> ids;
  try {
    for (const Claim& claim : load_claims(reference / "claims"))
      if (claim.judged_in(Tier::quick)) ids.push_back(claim.id);
  } catch (const Error&) {
    ids.clear();
  }
  return ids;
}

/// One audit at a time in a folder of trees and programs.
std::optional<FileLock> locked(const SideOptions& options) {
  std::error_code ignored;  // a folder that cannot be made is reported with the lock
  std::filesystem::create_directories(options.work, ignored);
  auto lock = FileLock::wait(options.work / "audit.lock", options.stop);
  stop_if_asked(options);
  return lock;
}

}  // namespace

AuditReport audit(const AuditOptions& options) {
  Side before = side_named(options.before, options.sides), after = side_named(options.after, options.sides);
  AuditReport report;
  report.before = before.name;
  report.after = after.name;
  report.declared = options.declared;
  const bool programs = before.has_program() && after.has_program();
  if (programs && !options.sides.rebuild && same_sources(before.name, after.name)) {
    report.same_sources = true;
    return report;
  }
  const auto lock = before.has_program() || after.has_program() ? locked(options.sides) : std::nullopt;
  for (Side* side : {&before, &after}) {
    build(*side, options.sides);
    fill_store(*side, options.sides);
  }
  const std::filesystem::path reference = after.has_program() ? after.tree / "reference" : options.reference;
  const auto names = run_names(reference);
  const EvidenceSet a = read_evidence(before.store, names, options.sides.claims),
                    b = read_evidence(after.store, names, options.sides.claims);
  report.findings = find_differences(a, b);
  const bool all = options.sides.claims.empty();
  find_unjudged(all && lock ? quick_claims(reference) : options.sides.claims, a, b, report.findings);
  for (const Side* side : {&before, &after})
    for (const std::string& note : side->notes) report.findings.notes.push_back(note);
  find_first_difference(options, before, after, a, b, report);
  report.found = class_of(report.findings);
  report.environment = environment_of(a, b);
  compare_cost(options, before, after, a, b, report);
  return report;
}

}  // namespace gpf
