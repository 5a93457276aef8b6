// Whether the last commit declares what its baseline shows.
#pragma once

#include <optional>
#include <string>

#include "verify/audit/physics_change.hpp"

namespace gpf {

struct CommitCheck {
  std::string skipped;  ///< why nothing can be said: no git, no parent, no baseline in it; empty: the rest counts
  PhysicsChange shown = PhysicsChange::bitwise;     ///< at least of this class
  PhysicsChange declared = PhysicsChange::bitwise;  ///< by the trailers Physics-Change of HEAD^1..HEAD

  [[nodiscard]] bool rejected() const { return skipped.empty() && shown > declared; }
};

/// Compares reference/baseline.csv of HEAD with that of its first parent, in the repository of the current folder. A
/// merge may declare in any commit that it brings. Throws InputError for a trailer or a baseline that cannot be read.
CommitCheck check_last_commit();

}  // namespace gpf
