// The chart points that this program gives its advice from: reference/methods.csv as it was built with.
#pragma once

#include <vector>

#include "verify/methods/chart.hpp"

namespace gpf {

/// Throws InputError when the table cannot be read.
std::vector<ChartPoint> advice_table();

}  // namespace gpf
