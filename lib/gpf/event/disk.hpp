// One disk in free flight, and what is known of its next contact.
#pragma once

#include <cstdint>
#include <limits>

namespace gpf {

using Index = std::int32_t;

inline constexpr double never = std::numeric_limits<double>::infinity();

/// State after the disk's last event, in the frame that falls with gravity, where every flight is a straight line.
/// Real is double, or a Lane of several disks that are looked at together.
template <class Real>
struct FlightOf {
  Real x, y;  ///< multiples of the PositionGrid's quantum
  Real vx, vy;
  Real time;  ///< of that event, since the start of the epoch
};
using Flight = FlightOf<double>;

/// All that a neighbour needs to know of a disk, in one cache line.
struct alignas(64) Disk {
  Flight flight;
  double contact = never;            ///< time of the next contact that this disk has found
  Index partner = -1;                ///< of that contact
  std::uint32_t partner_events = 0;  ///< of the partner when the contact was found
  std::uint32_t events = 0;          ///< contacts in this epoch: what was predicted at another number is stale
  Index id = 0;                      ///< the disk's number in the scene
};
static_assert(sizeof(Disk) == 64);

}  // namespace gpf
