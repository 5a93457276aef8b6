// The mean of each check's values, in the order of the checks.
#pragma once

#include <vector>

#include "verify/evidence.hpp"

namespace gpf::test {

inline std::vector<double> means(const Evidence& evidence) {
  std::vector<double> result;
  for (const Check& check : evidence.checks) {
    double sum = 0;
    for (const double v : check.values) sum += v;
    result.push_back(sum / static_cast<double>(check.values.size()));
  }
  return result;
}

}  // namespace gpf::test
