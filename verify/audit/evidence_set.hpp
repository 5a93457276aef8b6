// What one version of the program has shown: its runs, and the numbers and verdicts that it made of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "gpf/scene/scene.hpp"
#include "verify/audit/shifts.hpp"
#include "verify/judge.hpp"

namespace gpf {

/// A record, as far as two of them are compared.
struct RunDigest {
  std::string name;  ///< "<scene> #<replica>", or what the record is called where its scene is not known
  std::uint64_t trace_hash = 0;
  std::uint64_t measured = 0;  ///< hash of all bits that were measured
  std::vector<double> sums;    ///< what was measured: tallies over all blocks, arrays, history, states
  std::vector<double> sizes;   ///< of each of them, the sum of the sizes of what was added
  std::uint64_t contacts = 0;  ///< pair contacts
  double time = 0, epoch_length = 0, cpu_seconds = 0;
  std::string build, session;  ///< JSON of the provenance
};

/// A verdict without its numbers.
struct ClaimState {
  Outcome outcome = Outcome::inconclusive;
  bool green = false;
  std::uint64_t claim_hash = 0;
  std::string summary;
};

struct EvidenceSet {
  std::map<std::string, RunDigest> runs;     ///< by the canonical text of scene and run
  std::vector<ClaimEstimate> numbers;        ///< of all claims, in their order by id
  std::map<std::string, ClaimState> claims;  ///< by id
  std::vector<std::string> missing_records;  ///< names of records that the verdicts read and that are gone
};

/// Names of runs by their canonical text: each scene in <reference>/scenes with its first 32 replicas of the quick
/// tier. Empty when there is no such folder; files that this program cannot read are left out.
std::map<std::string, std::string> run_names(const std::filesystem::path& reference);

/// The verdicts of the quick tier in a store - all, or those of `claims` that are there - and the records that they
/// read. Throws InputError when there is no verdict or one is damaged.
EvidenceSet read_evidence(const std::filesystem::path& store, const std::map<std::string, std::string>& names,
                          const std::vector<std::string>& claims = {});

/// The number of a judged check.
ClaimEstimate estimate_of(const std::string& claim, const JudgedCheck& check);

/// Whether a folder is a store: it has verdicts of the quick tier.
bool is_store(const std::filesystem::path& folder);

}  // namespace gpf
