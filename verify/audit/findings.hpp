// What differs between the evidence of two versions, and of which class that makes the change.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/audit/evidence_set.hpp"
#include "verify/audit/first_difference.hpp"
#include "verify/audit/physics_change.hpp"
#include "verify/audit/shifts.hpp"

namespace gpf {

/// A claim whose verdict is another.
struct VerdictFlip {
  std::string claim;
  ClaimState before, after;
};

/// The first event in which the two programs differ, in the shortest run that does.
struct ReplayedDifference {
  std::string run;
  EventDifference event;
};

struct AuditFindings {
  std::size_t runs = 0;                         ///< runs that both sides have
  std::vector<std::string> other_trajectories;  ///< those of other trace hashes
  std::vector<std::string> other_measurements;  ///< those of the same trace hash whose measured bits differ
  std::vector<std::string> runs_only_before, runs_only_after;
  /// Scenes before of which no run has a counterpart, and records that are gone: of these nobody knows whether they go
  /// other ways.
  std::vector<std::string> not_compared;

  std::size_t numbers = 0, equal_numbers = 0;  ///< checks on both sides; those of the same bits
  Shifts shifts;
  std::vector<std::string> broken_identities;  ///< exact checks inside their band on one side only
  /// Claims or checks that are gone although the claim's file is the same: what is no longer measured is not known to
  /// be as it was.
  std::vector<std::string> lost;
  std::vector<VerdictFlip> flips;
  double largest_relative = 0;      ///< difference of a value over the larger one or half of its band, the largest
  double largest_relative_sum = 0;  ///< of measured sums on equal trajectories, over the sizes of what was added
  bool other_layout = false;        ///< the sums are not the same ones, so that their sizes cannot be compared
  bool within_half_band = true;     ///< every mean differs by at most half of the tolerance
  std::vector<std::string> notes;   ///< what else a reader must know
  std::optional<ReplayedDifference> first;

  /// Whether all runs are known to go the same ways.
  [[nodiscard]] bool same_trajectories() const { return other_trajectories.empty() && not_compared.empty(); }
};

/// Sees what differs; the replay is left to the caller. Where the numbers of replicas differ those that both sides have
/// are compared. Values are judged by compare() only when trajectories differ: on equal ones a difference is exact.
AuditFindings find_differences(const EvidenceSet& before, const EvidenceSet& after);

struct ClassLimits {
  double ulps = 4096;          ///< of the first differing event, for round-off
  double relative = 1e-9;      ///< of values from equal trajectories, for round-off
  double global_alpha = 0.01;  ///< chance that the same physics on other trajectories is taken for a new one
};

/// bitwise: equal hashes, measured bits and values. On equal trajectories: roundoff up to limits.relative, same physics
/// up to half of the tolerance (not when only sums differ, of which no claim says how much they may). On others:
/// roundoff when the first differing event differs by no more than limits.ulps; same physics when it does not, or
/// cannot be replayed; both only if the p-value of "nothing moved" is above global_alpha and no identity has moved.
/// Where runs could not be compared it is same physics at least. New physics for everything else, for a broken
/// identity, a lost number and a verdict that was green and is now decided against its expectation.
PhysicsChange class_of(const AuditFindings& findings, const ClassLimits& limits = {});

/// Half of the tolerance of a number: a quarter of its band, or half of the way from `mean` to the only end that the
/// band has; 0 when the mean is not inside or there is no end.
double half_tolerance(Interval band, double mean);

}  // namespace gpf
