// The page "The judge on trial".
#pragma once

#include <filesystem>

#include "verify/trial/audit_trial.hpp"
#include "verify/trial/judge_trial.hpp"

namespace gpf {

struct Trial {
  JudgeTrial judge;
  AuditTrial audit;
  std::vector<TrialResult> seeds;
  double cpu_seconds = 0;
  bool quick = false;

  [[nodiscard]] std::vector<TrialResult> results() const;
  /// Results that lie outside of what is stated.
  [[nodiscard]] std::vector<TrialResult> outside() const;
};

/// Writes trial.md into `folder`, its pictures into `folder`/trial. Throws StorageError.
void write_trial_page(const Trial& trial, const std::filesystem::path& folder);

}  // namespace gpf
