// One disk in free flight.
#pragma once

#include <cstdint>

namespace gpf {

using Index = std::int32_t;

/// State after the disk's last event, in the frame that falls with gravity, where every flight is a straight line.
/// Real is double, or a Lane of several disks that are looked at together.
template <class Real>
struct FlightOf {
  Real x, y;  ///< multiples of the PositionGrid's quantum
  Real vx, vy;
  Real time;  ///< of that event, since the start of the epoch
};
using Flight = FlightOf<double>;

}  // namespace gpf
