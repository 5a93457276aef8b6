// What an estimator makes of records: numbers, each with the band in which the claim wants it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "gpf/io/record.hpp"
#include "gpf/stats/interval.hpp"
#include "verify/claim.hpp"

namespace gpf {

/// One inequality of a claim. Pass when the confidence interval of the mean of `values` lies inside `band`, fail when
/// it is disjoint from it. An open side is infinite: sign and order claims have one-sided bands, `same` claims bands of
/// +-margin about zero for a difference.
struct Check {
  std::string label;           ///< for example "Z at nu 0.30" or "bin 4, kurtosis of u_x"
  std::vector<double> values;  ///< one per replica, independent
  Interval band;
  bool exact = false;    ///< an identity: every value must lie in the band, no statistics
  double x = 0;          ///< abscissa (bin centre, nu, ...) where the checks form a profile
  double reference = 0;  ///< centre of the band where it has one, else NaN
  /// Values are 1 for a replica that has the label which a class claim states, else 0; the band is one of the
  /// proportion of all replicas that have it (majority for "it is of that class").
  bool share = false;
};

/// Band of a share: a class is what more than half of all replicas are.
inline constexpr Interval majority{0.5, 1};

/// A precondition of trust, judged apart from the claim: when one fails the claim is inconclusive.
struct HealthCheck {
  std::string name;  ///< for example "stationary: first half against second, scene channel-nu30"
  bool passed;
  std::string detail;
  double chance = 0;  ///< of a failure as large as this one when nothing is wrong; 0 for what holds to round-off
};

/// A picture that is no plot, for the claim's page.
struct Drawing {
  std::string title;
  std::string svg;  ///< an SVG document
};

struct Evidence {
  std::vector<Check> checks;
  std::vector<HealthCheck> health;  ///< the estimator's own; the judge adds those that hold for every record
  Plot plot;                        ///< the picture for the claim's page
  std::vector<Drawing> drawings;    ///< shown below it
  std::vector<std::string> notes;   ///< sentences for the page: definitions, both readings, what else was seen
  double extra_cpu_seconds = 0;     ///< spent in the estimator itself (oracle runs)
};

/// Records of a scene, one per replica, in order of replica number.
using SceneRecords = std::map<std::string, std::vector<Record>, std::less<>>;

/// Turns records into evidence. Must not depend on anything but its arguments.
using Estimator = Evidence (*)(const Claim& claim, Tier tier, const SceneRecords& records);

/// The estimator of that name. Throws InputError that lists the known ones.
Estimator estimator_named(std::string_view name);

}  // namespace gpf
