// Ratios that should be one: a check for each, and one picture of all runs.
#pragma once

#include <string>
#include <vector>

#include "verify/evidence.hpp"

namespace gpf {

class RatioChecks {
 public:
  /// The claim's tolerance about one is the band of every check.
  explicit RatioChecks(const Claim& claim);

  /// One value per replica.
  void add(std::string label, std::vector<double> values);

  /// Checks and plot of all that were added.
  [[nodiscard]] Evidence evidence(std::string title, std::string ylabel) const;

 private:
  Interval band_;
  std::vector<Check> checks_;
};

}  // namespace gpf
