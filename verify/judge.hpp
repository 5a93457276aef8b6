// From evidence to a verdict, with stated error rates.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/event/physics_version.hpp"
#include "verify/claim.hpp"
#include "verify/evidence.hpp"

namespace gpf {

enum class Outcome { pass, fail, inconclusive };

/// One check after judgement.
struct JudgedCheck {
  Check check;
  ReplicaSummary summary;
  /// t-interval of the mean at this look's alpha; for a share its interval at this look's share_alpha; for an exact
  /// check the range of the values.
  Interval interval;
  Outcome outcome = Outcome::inconclusive;
  double replicas_needed = 0;  ///< estimate of the R that would decide an inconclusive check; 0 when decided
};

struct Verdict {
  std::string claim_id;
  Tier tier = Tier::quick;
  Outcome outcome = Outcome::inconclusive;
  Expectation expected = Expectation::reproduced;
  bool green = false;          ///< outcome agrees with the expectation
  int replicas = 0, look = 0;  ///< R used; 1 for the first look
  double alpha = 0;            ///< per direction, at this look
  std::vector<JudgedCheck> checks;
  std::vector<HealthCheck> health;
  Plot plot;
  std::vector<Drawing> drawings;
  std::vector<std::string> notes;
  double cpu_seconds = 0;            ///< of the runs that it read (shared with other claims) and its own
  std::string summary;               ///< one sentence: the tightest check with its number, interval and band
  std::vector<std::string> records;  ///< names of the records that it read
  std::uint64_t claim_hash = 0;      ///< Claim::text_hash of the file that was judged
  int physics_version = gpf::physics_version;
  std::uint64_t program_hash = 0;  ///< of the program that judged; 0: not known
  std::uint64_t release_seed = 0;  ///< mixed into the replicas' seeds; 0 in the quick tier, whose seeds are fixed
};

/// alpha is shared evenly over the looks that a claim's cap allows: alpha_k = alpha/looks (Bonferroni), so that looking
/// several times keeps the rates.
inline constexpr double alpha_per_direction = 0.01;

/// As alpha_per_direction, for the lower bound of a share: the stated class is the label of a proportion of all
/// replicas whose 95 % lower bound exceeds one half. 4 of 4 do not show that, whatever the number of looks; 8 of 8 do.
inline constexpr double share_alpha_per_direction = 0.05;

/// The numbers of replicas at which a claim with this cap is looked at: those of 4, 8, 16, 32 up to it; {1} for a cap
/// below 4.
std::vector<int> looks_up_to(int most_replicas);

/// Judges evidence from `replicas` replicas at look `look` of `looks`, both from 1.
///
/// A statistical check passes when its t-interval at alpha_k lies inside the band. It fails when its p-value of "the
/// true mean lies in the band", after Holm's correction over the statistical checks of the claim, is at most alpha_k;
/// for a claim of one check that is when interval and band are disjoint. An exact check passes when every value lies in
/// the band and fails otherwise. Without values, or with one that is not finite, a check is inconclusive.
///
/// A share is judged by Clopper and Pearson's interval instead: it passes when that at share_alpha_per_direction/looks
/// lies inside the band, and fails as the others do, at alpha_k with Holm's correction, by the binomial tail.
///
/// The claim passes when all checks pass - an intersection of tests, which needs no correction - and fails when one
/// fails. A failed health check, or no check at all, makes it inconclusive whatever the checks say.
///
/// Rates, over all looks together: a claim of which some check's true value lies on or outside a band's edge passes
/// with probability at most alpha (share_alpha_per_direction, if it is a share); a claim whose true values all lie in
/// their bands fails with probability at most alpha for each edge. Everything else is `inconclusive`, with the R that
/// would decide.
Verdict judge(const Claim& claim, Tier tier, const Evidence& evidence, int replicas, int look, int looks);

/// Green: reproduced and pass, refuted and fail, unresolved and inconclusive.
bool agrees(Outcome outcome, Expectation expected);

std::string_view name_of(Outcome outcome);
Outcome outcome_named(std::string_view name);  ///< Throws InputError.

}  // namespace gpf
