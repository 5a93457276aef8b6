// The last test of the suite: is every required claim judged, by this program, and as expected?
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "verify/claim.hpp"

namespace gpf {

struct GateOptions {
  Tier tier = Tier::quick;
  std::filesystem::path store, reference;
  std::uint64_t program_hash = 0;  ///< verdicts of another program are stale; 0: not compared
};

/// What is wrong with the suite, one sentence each; empty when the gate is green. Runs and judges nothing. Found are
/// - ids in claims/required.txt without a claim file, and claim files that are not listed there;
/// - claims of the tier without a verdict, or with one that is not green: decided against the expectation, or
///   inconclusive without being listed as `unresolved`;
/// - stale verdicts: on another text of the claim, another physics version, another program, or other runs than the
///   claim's scenes describe now; and records that are gone or damaged since.
/// Throws StorageError, InputError when claims or scenes cannot be read.
std::vector<std::string> gate_findings(const GateOptions& options);

}  // namespace gpf
