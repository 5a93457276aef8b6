// The trials must be able to fail: faults of the kinds that they look for, made on purpose.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "unit/stats/synthetic.hpp"
#include "verify/trial/audit_trial.hpp"
#include "verify/trial/judge_trial.hpp"
#include "verify/trial/seed_trial.hpp"

using namespace gpf;

namespace {

/// Runs whose numbers are independent: two in each of the trial's scenes.
TrialRuns made_runs(std::size_t replicas) {
  TrialRuns runs;
  for (std::size_t scene = 0; scene < trial_scenes().size(); ++scene) {
    const auto noise = synthetic::white(77 + scene, 2 * replicas);
    runs.labels.push_back({"a", "b"});
    runs.runs.emplace_back();
    for (std::size_t r = 0; r < replicas; ++r)
      runs.runs[scene].push_back({100000 * scene + r, {noise[2 * r], noise[2 * r + 1]}});
  }
  return runs;
}

std::vector<std::string> outside(const std::vector<TrialResult>& results) {
  std::vector<std::string> names;
  for (const TrialResult& r : results)
    if (r.outside) names.push_back(r.what);
  return names;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(trial)

BOOST_AUTO_TEST_CASE(a_rate_is_outside_when_chance_does_not_explain_it) {
  BOOST_TEST(!at_most("", 10, 1000, 0.01).outside);
  BOOST_TEST(!at_most("", 18, 1000, 0.01).outside);  // P(18 or more) = 0.014
  BOOST_TEST(at_most("", 22, 1000, 0.01).outside);   // P(22 or more) = 0.0007
  BOOST_TEST(!at_most("", 1000, 1000, 1).outside);   // nothing stated
  BOOST_TEST(at_most("", 1000, 1000, 1).stated.empty());
  BOOST_TEST(expected_by_chance("", 0.0009, "", "uniform").outside);
  BOOST_TEST(expected_by_chance("", NAN, "", "uniform").outside);
  BOOST_TEST(!expected_by_chance("", 0.0011, "", "uniform").outside);
}

// Four looks without sharing alpha among them would err as if each were the only one: so does a claim whose replicas
// are correlated, which is what the rates rest on.
BOOST_AUTO_TEST_CASE(replicas_that_are_not_independent_break_the_rates) {
  SyntheticClaim claim = value_claim(1, false);
  claim.replica = [truth = claim.replica, last = ReplicaValues{}](Draws& draws) mutable {
    const ReplicaValues fresh = truth(draws);
    last = last.empty() ? fresh : ReplicaValues{1 + 0.9 * (last[0] - 1) + 0.44 * (fresh[0] - 1)};
    return last;
  };
  const OutcomeCounts n = judged_outcomes(claim, 1000);
  BOOST_TEST(at_most("", n.pass, n.claims, claim.most_pass).outside);
}

BOOST_AUTO_TEST_CASE(independent_runs_raise_no_alarm) {
  const TrialRuns runs = made_runs(40 * 2 * replicas_a_side);
  const AuditTrial audit = try_audits(runs);
  BOOST_TEST(audit.audits == 40U);
  BOOST_TEST(audit.numbers == 8U);
  BOOST_TEST(outside(audit.results).empty());
  BOOST_TEST(outside(try_seeds(runs, 10000, 200)).empty());
}

// Each version with a random step of its own, as when its replicas share something: audits call that a change.
BOOST_AUTO_TEST_CASE(replicas_that_share_a_step_raise_false_alarms) {
  TrialRuns runs = made_runs(40 * 2 * replicas_a_side);
  const auto steps = synthetic::white(5, 80);
  for (std::size_t r = 0; r < runs.runs[0].size(); ++r) runs.runs[0][r].values[0] += steps[r / replicas_a_side];
  const auto names = outside(try_audits(runs).results);
  BOOST_TEST(std::count(names.begin(), names.end(), "audits that name a number") == 1);
  BOOST_TEST(names.size() > 2U);
}

BOOST_AUTO_TEST_CASE(repeated_and_correlated_replicas_are_found) {
  TrialRuns runs = made_runs(1000);
  runs.runs[2][7].trace_hash = runs.runs[1][3].trace_hash;
  for (std::size_t r = 0; r < 1000; ++r) runs.runs[1][r].values[0] += 0.3 * runs.runs[0][r].values[0];
  for (std::size_t r = 1; r < 1000; ++r) runs.runs[3][r].values[1] += 0.3 * runs.runs[3][r - 1].values[1];
  const auto names = outside(try_seeds(runs, 10000, 200));
  const std::vector<std::string> expected{"repeated trace hashes of runs", "measured numbers, replicas r and r + 1",
                                          "measured numbers, the same replica of e_n .90 and .91"};
  BOOST_TEST(names == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
