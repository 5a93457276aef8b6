// Example of reference/guide/estimator.md: an estimator and its test.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <limits>

#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/scene_values.hpp"
#include "verify/judge.hpp"

namespace gpf {

/// How much of gravity's power is lost at the walls: at least the claim's parameter least_share, in every scene.
Evidence estimate_wall_share(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  Series points{.label = "gpf, mean and standard error over replicas"};
  for (const SceneValues& scene : by_area_fraction(records)) {
    const std::vector<double> power = scene.of("gravity_power"), lower = scene.of("wall_loss_lower"),
                              upper = scene.of("wall_loss_upper");
    const std::vector<double> share =
        per_replica(scene.replicas(), [&](std::size_t r) { return (lower[r] + upper[r]) / power[r]; });
    const double nu = scene.scene().area_fraction();
    add_point(points, nu, share);
    evidence.checks.push_back({.label = fmt::format("{}: power lost at the walls", scene.name()),
                               .values = share,
                               .band = {claim.parameter("least_share"), std::numeric_limits<double>::infinity()},
                               .x = nu,
                               .reference = std::numeric_limits<double>::quiet_NaN()});
  }
  evidence.plot = {.title = "Where the work of gravity goes",
                   .xlabel = "mean area fraction",
                   .ylabel = "share lost at the walls",
                   .series = {points}};
  return evidence;
}

}  // namespace gpf

using namespace gpf;
using namespace gpf::test;

namespace {

/// A record in which gravity does the work 10 and the walls take that much of it.
Record record_with(double wall_loss) {
  return made_record(channel_text(0.3), [&](const SetTally& set) {
    set(Tally::gravity_work, 0, 10);
    for (const int wall : {lower, upper}) set(Tally::wall_loss, wall, wall_loss / 2);
  });
}

Outcome judged(double wall_loss) {
  Claim claim = made_claim(0, {{"least_share", 0.5}});
  claim.transient = true;  // records made by hand have no history to be steady in
  SceneRecords records;
  for (const double scatter : {-0.2, -0.1, 0.1, 0.2}) records["made"].push_back(record_with(wall_loss + scatter));
  return judge(claim, Tier::quick, estimate_wall_share(claim, Tier::quick, records), 4, 1, 1).outcome;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_share_is_that_of_the_tallies) {
  const Claim claim = made_claim(0, {{"least_share", 0.5}});
  const Evidence evidence = estimate_wall_share(claim, Tier::quick, {{"made", {record_with(7)}}});
  BOOST_TEST(evidence.checks.at(0).values.at(0) == 0.7, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_judge_tells_more_than_half_from_less) {
  BOOST_TEST((judged(7) == Outcome::pass));
  BOOST_TEST((judged(5) == Outcome::inconclusive));
  BOOST_TEST((judged(3) == Outcome::fail));
}
