// What a change of the program does to results, as its author declares it and as an audit finds it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gpf {

/// From the mildest to the strongest; each allows what stands before it.
enum class PhysicsChange {
  bitwise,       ///< nothing moves
  roundoff,      ///< the last bits of single events
  same_physics,  ///< other trajectories or samples, equal statistics
  new_physics
};

std::string_view name_of(PhysicsChange change);

/// "bitwise", "roundoff" (or "round-off"), "same physics", "new physics"; `_` or `-` may stand for the blank, and
/// capitals do not count. Throws InputError that lists them.
PhysicsChange physics_change_named(std::string_view name);

/// The strongest of the values of trailers `Physics-Change`, one a line; bitwise when there is none. Throws InputError.
PhysicsChange strongest_declared(std::string_view trailers);

}  // namespace gpf
