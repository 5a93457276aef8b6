// One disk in free flight, and what is known of its next contact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
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

  /// Begins a flight, of which no contact is known. It is written in the pieces in which neighbours read it, or larger
  /// ones: what has just been written goes straight to who reads all or a part of a piece, while others must wait for
  /// it to reach the memory.
  void begin(const Flight& f) {
    const Four start{f.x, f.y, f.vx, f.vy};
    std::memcpy(&flight, &start, sizeof start);
    forget(f.time);
  }
  /// No contact is known.
  void forget() { forget(flight.time); }

 private:
  using Two = double __attribute__((vector_size(16)));
  using Four = double __attribute__((vector_size(32)));

  void forget(double time) {
    const Two times{time, never};
    std::memcpy(&flight.time, &times, sizeof times);
    partner = -1;
  }
};
static_assert(sizeof(Disk) == 64 && offsetof(Disk, contact) == sizeof(Flight));

}  // namespace gpf
