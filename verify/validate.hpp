// From claims to verdicts: runs what is missing, judges, looks again where a claim is undecided.
#pragma once

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "verify/claim.hpp"
#include "verify/review.hpp"
#include "verify/run_pool.hpp"
#include "verify/validate_output.hpp"

namespace gpf {

struct ValidateOptions {
  Tier tier = Tier::quick;
  std::vector<std::string> claims;  ///< ids; empty: all of the tier
  std::filesystem::path store = "records", reference = "reference";
  int jobs = 1;                        ///< runs at a time
  int replicas = 0;                    ///< quick: look once, with so many, whatever the caps; 0: as the claims say
  std::uint64_t release_seed = 0;      ///< standard and full: mixed into the replicas' seeds; 0: that of this version
  std::vector<std::string> only_runs;  ///< scenes: make the records of the first look, judge nothing
  bool json = false;                   ///< one JSON object on standard output instead of the table
  bool confirm = true;                 ///< standard and full: a failed claim gets its confirmation run
  double checkpoint_period = 60;       ///< seconds
  const volatile std::sig_atomic_t* stop = nullptr;
  RunFunction run = simulate;
  EstimatorLookup estimators = estimator_named;
  std::vector<std::string> command;  ///< for the records' provenance
};

struct ValidateResult {
  std::vector<Verdict> verdicts;
  std::vector<ValidateProblem> problems;
  bool stopped = false;  ///< by a signal: whatever was finished is in the store
};

/// Runs and judges, with progress on standard error; verdicts are written into the store. Throws as validate().
ValidateResult judge_claims(const ValidateOptions& options);

/// Seeds of the quick tier are fixed: with bit-reproducible runs a verdict can only change when the program does. In
/// the other tiers they are fresh for each release (from its version, or as given) and printed; a claim that then fails
/// although it should not gets one confirmation run with new seeds, whose verdict counts, and the first one's summary
/// among its notes. Two such fails in a row have probability 1e-4 per direction.
///
/// Every verdict is written into the store (verdict_file.hpp). Prints a table, or one JSON object, on standard output,
/// and progress on standard error. Returns the program's exit status: 0 all green; 1 a claim is decided against its
/// expectation (or an `unresolved` one is decided); 77 otherwise, when a claim that should be decided is not; 75
/// stopped by a signal; 2, 3 or 4 when a run failed or a claim could not be judged, whatever the others say. Throws
/// InputError for an unknown claim or scene, a release seed in the quick tier, or a number of replicas in another.
int validate(const ValidateOptions& options);

/// The release seed that stands for this version of gpf.
std::uint64_t default_release_seed();

/// Hash of the running program's file, which stands in a verdict for the judge and estimators that made it; 0 when it
/// cannot be read.
std::uint64_t program_hash();

}  // namespace gpf
