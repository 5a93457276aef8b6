// Where a straight line crosses zero, with Fieller's interval.
#pragma once

#include "gpf/stats/fit.hpp"
#include "gpf/stats/interval.hpp"

namespace gpf {

struct Crossing {
  double at = 0;      ///< -intercept/slope
  Interval interval;  ///< the x at which the line is compatible with zero; infinite ends when they are not bounded

  [[nodiscard]] bool bounded() const;
};

/// Zero of the fitted line and all x with |line(x)| <= `quantile` standard errors of line(x) (Fieller, J. R. Stat. Soc.
/// B 16, 175 (1954)). Bounded exactly when the slope differs from 0 by more than `quantile` of its errors; otherwise
/// the interval is (-infinity, infinity), which contains Fieller's unbounded set.
/// @throws InputError unless quantile > 0 and the slope is not 0.
Crossing zero_crossing(const LineFit& line, double quantile);

}  // namespace gpf
