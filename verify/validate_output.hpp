// What `gpf validate` prints.
#pragma once

#include <string>
#include <vector>

#include "gpf/base/error.hpp"
#include "verify/judge.hpp"

namespace gpf {

struct ValidateOptions;

/// A run that failed, or a claim that could not be judged.
struct ValidateProblem {
  std::string what, why;
  ExitStatus status;
};

/// "green", "red" or "open" (inconclusive where a decision was expected).
std::string_view colour_of(const Verdict& verdict);

/// One line per claim, those that are not green first, and a line of totals.
void print_table(const ValidateOptions& options, const std::vector<Verdict>& verdicts);

/// {"tier", "claims": [{"id", "outcome", "expected", "green", "replicas", "summary", "cpu_seconds", "records"}],
/// "problems"}
void print_json(const ValidateOptions& options, const std::vector<Verdict>& verdicts,
                const std::vector<ValidateProblem>& problems);

/// On standard error.
void print_problems(const std::vector<ValidateProblem>& problems);

}  // namespace gpf
