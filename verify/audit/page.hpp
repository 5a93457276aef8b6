// The page of an audit: the answer first, then what moved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/audit/cost.hpp"
#include "verify/audit/environment.hpp"
#include "verify/audit/findings.hpp"

namespace gpf {

struct AuditReport {
  std::string before, after;  ///< as the user named the sides
  bool same_sources = false;  ///< nothing was run: no file that decides about results differs
  PhysicsChange found = PhysicsChange::bitwise;
  std::optional<PhysicsChange> declared;
  AuditFindings findings;
  std::string why_no_replay;  ///< where trajectories differ and nothing was replayed
  std::vector<EnvironmentFact> environment;
  std::optional<CostComparison> cost;

  /// The change is of a stronger class than was declared.
  [[nodiscard]] bool rejected() const { return declared && found > *declared; }
};

/// One or two sentences: the class found, the one declared, what moved.
std::string answer_of(const AuditReport& report);

/// The whole page, in markdown.
std::string audit_page(const AuditReport& report);

}  // namespace gpf
