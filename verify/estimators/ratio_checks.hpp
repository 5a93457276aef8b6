// Ratios that should be one: a check for each, and one picture of all runs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verify/evidence.hpp"

namespace gpf {

class RatioChecks {
 public:
  /// The claim's tolerance about one is the band of every check.
  explicit RatioChecks(const Claim& claim);

  /// ratio(record) of each replica.
  template <class Ratio>
  void add(std::string label, const std::vector<Record>& replicas, Ratio&& ratio) {
    std::vector<double> values;
    for (const Record& record : replicas) values.push_back(ratio(record));
    add(std::move(label), std::move(values));
  }

  /// Checks and plot of all that were added.
  [[nodiscard]] Evidence evidence(std::string title, std::string ylabel) const;

 private:
  void add(std::string label, std::vector<double> values);

  Interval band_;
  std::vector<Check> checks_;
};

}  // namespace gpf
