// The committed baseline: what this version of the program gives in the quick tier, so small that a change can be read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verify/audit/evidence_set.hpp"
#include "verify/audit/physics_change.hpp"

namespace gpf {

/// Values have nine significant digits in the file, so two that differ by less than this (relative) are equal.
inline constexpr double baseline_precision = 1e-8;

/// The evidence in a store of the quick tier as a baseline keeps it: the runs of each claim's first look, by name, with
/// their trace hashes, and the values of all checks. Throws InputError when the store lacks a verdict or a record, or a
/// verdict is that of another claim file or program.
EvidenceSet baseline_evidence(const std::filesystem::path& store, const std::filesystem::path& reference);

/// CSV with a line for each run (run,<scene> #<replica>,<trace hash>) and each check (check,<claim>,"<label>",<kind>,
/// <band's ends>,<values, separated by blanks>), sorted.
std::string baseline_text(const EvidenceSet& evidence);

/// What such a text says. Throws InputError, with `name` and the line.
EvidenceSet parse_baseline(std::string_view text, std::string_view name);

/// What differs between a baseline and a store's evidence, one line each; empty when nothing does. Equal values agree
/// to baseline_precision, or to as much of their band's width; kinds and bands count too.
std::vector<std::string> baseline_differences(const EvidenceSet& baseline, const EvidenceSet& now);

/// The mildest class that a change may have whose baselines are these. Other trajectories with equal statistics may be
/// round-off: no baseline can tell, so roundoff stands for them. What is gone, or is judged by another band, makes it
/// same physics at least: nothing shows any more that it did not move.
PhysicsChange least_class(const EvidenceSet& before, const EvidenceSet& after);

}  // namespace gpf
