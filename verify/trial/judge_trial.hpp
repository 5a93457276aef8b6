// The judge on synthetic claims: how often it errs, and how often it decides.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "verify/trial/synthetic_claims.hpp"
#include "verify/trial/trial_result.hpp"

namespace gpf {

struct OutcomeCounts {
  std::size_t pass = 0, fail = 0, claims = 0;
};

/// Judges `claims` claims with the sequence of looks that a validation makes: again with more replicas until decided or
/// at the cap. The key of each claim's random numbers follows from kind, truth and number.
OutcomeCounts judged_outcomes(const SyntheticClaim& claim, std::size_t claims);

/// One kind and truth.
struct JudgedKind {
  std::string kind, truth;
  OutcomeCounts counts;
  TrialResult pass, fail;
};

struct JudgeTrial {
  std::vector<JudgedKind> kinds;
  std::vector<TrialResult> fieller;  ///< misses of Fieller's interval of a zero crossing
  Plot power;                        ///< pass and fail against the truth

  [[nodiscard]] std::vector<TrialResult> results() const;  ///< all of them
};

/// Markdown table, one row for each kind and truth.
std::string table_of(const std::vector<JudgedKind>& kinds);

/// About `claims` claims of each kind and truth (a quarter of it where they are large).
JudgeTrial try_judge(std::size_t claims);

}  // namespace gpf
