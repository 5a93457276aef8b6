// One measured rate of the judge, the audit or the seeds, beside what is stated of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gpf {

/// A result lies outside of what is stated when sampling alone would show one so far off, or further, at most so often.
inline constexpr double trial_alpha = 0.001;

struct TrialResult {
  std::string what;
  std::string measured;  ///< with its error
  std::string stated;    ///< empty: nothing is stated of it
  bool outside = false;
};

/// "0.0123 ± 0.0011": hits/trials with its binomial error.
std::string rate_text(std::size_t hits, std::size_t trials);

/// A rate that is stated to be at most `most`; 1 or more: nothing is stated.
TrialResult at_most(std::string what, std::size_t hits, std::size_t trials, double most);

/// A p-value of what is stated; `statement` says that.
TrialResult expected_by_chance(std::string what, double p, std::string measured, std::string statement);

/// Markdown table of results, with a column "within stated".
std::string table_of(const std::vector<TrialResult>& results);

}  // namespace gpf
