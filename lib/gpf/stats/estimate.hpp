// A measured number with its standard error.
#pragma once

#include <limits>

namespace gpf {

/// Mean and standard error, in the unit of what was measured. NaN means "not measured"; a finite mean with
/// a NaN error means "measured, but with too little data to give an error".
struct Estimate {
  double mean = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace gpf
