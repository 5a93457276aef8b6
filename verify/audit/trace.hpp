// A trajectory in so much detail that two programs can be compared event by event.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/event/engine_state.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// A run at the end of an epoch; epoch 0 is its start.
struct EpochMark {
  std::int64_t epoch = 0;
  std::uint64_t trace_hash = 0;  ///< of all contacts so far
  std::uint64_t contacts = 0;    ///< so far, with disks and walls
  std::uint64_t state_hash = 0;  ///< of all positions and velocities

  friend bool operator==(const EpochMark&, const EpochMark&) = default;
};

/// One contact after it has been resolved.
struct TracedContact {
  double time = 0;                     ///< since the start of its epoch: to the last bit what the engine worked with
  std::int32_t first = 0, second = 0;  ///< numbers of disks; second -1: lower wall, -2: upper wall
  std::array<double, 4> velocity{};    ///< laboratory frame, x and y of the first, then of the second; 0 of a wall

  friend bool operator==(const TracedContact&, const TracedContact&) = default;
};

/// Marks of the start and of `epochs` epochs, told one by one; from the start of the scene, or from a checkpoint.
/// Throws PhysicsError as the engine does.
void trace_epochs(const Scene& scene, const std::optional<EngineState>& from, std::int64_t epochs,
                  const std::function<void(const EpochMark&)>& tell);

/// Every contact of epoch `epoch`, which ends with the mark of that number: the first is 1. In the order in which they
/// happen. Throws InputError when it lies before the checkpoint, PhysicsError as the engine does.
std::vector<TracedContact> trace_contacts(const Scene& scene, const std::optional<EngineState>& from,
                                          std::int64_t epoch);

/// One line each, without its end: "epoch hash contacts state_hash" and "time first second vx vy vx vy", numbers with
/// 17 significant digits, so that equal lines are equal bits.
std::string text_of(const EpochMark& mark);
std::string text_of(const TracedContact& contact);

/// What such lines say. Throws InputError for any other line.
std::vector<EpochMark> parse_marks(std::string_view text);
std::vector<TracedContact> parse_contacts(std::string_view text);

}  // namespace gpf
