// All that a run needs to go on to the same bits: the engine at the start of an epoch.
#pragma once

#include <cstdint>
#include <vector>

namespace gpf {

/// What the event loop has done.
struct EventCounts {
  std::uint64_t pair_contacts = 0;  ///< pair collisions resolved
  std::uint64_t wall_contacts = 0;  ///< wall collisions resolved
  std::uint64_t crossings = 0;      ///< cell boundaries crossed
  std::uint64_t stale = 0;          ///< scheduled contacts examined but not executed: a partner had changed

  [[nodiscard]] std::uint64_t examined() const { return pair_contacts + wall_contacts + crossings + stale; }
};

/// Positions and velocities in the falling frame, by disk; times since the start of the epoch.
struct EngineState {
  std::int64_t epoch = 0;
  double frame_velocity = 0;  ///< of the frame against the laboratory, at the start of the epoch
  double frame_offset = 0;    ///< lab x = x + frame_offset, modulo the period
  std::vector<double> x, y, vx, vy;
  std::vector<double> last_contact;  ///< <= 0; -infinity: none yet
  std::uint64_t trace_hash = 0;
  EventCounts counts;
};

}  // namespace gpf
