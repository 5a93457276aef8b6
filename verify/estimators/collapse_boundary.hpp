// From runs that collapsed or not to the restitution below which they do.
#pragma once

#include <cstddef>
#include <vector>

namespace gpf {

/// Where runs at evenly spaced restitutions first, first + step, ... stop to collapse: half a step below the first,
/// and a step more for each run that collapsed. Its mean over replicas is the mean of the boundary, wherever the share
/// of collapses falls from 1 to 0 between the ends of the grid (Spearman and Kaerber's estimate of a threshold); no
/// replica needs to be ordered in itself.
inline double collapse_boundary(double first, double step, const std::vector<bool>& collapsed) {
  double boundary = first - 0.5 * step;
  for (const bool c : collapsed) boundary += c ? step : 0;
  return boundary;
}

}  // namespace gpf
