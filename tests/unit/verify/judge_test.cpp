#include "verify/judge.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "gpf/base/error.hpp"

using namespace gpf;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

Claim claim_expected_to_be(Expectation expected) {
  Claim claim;
  claim.id = "test";
  claim.expected = expected;
  return claim;
}

Check check_of(std::vector<double> values, Interval band, bool exact = false) {
  return {"quantity", std::move(values), band, exact, 0, band.centre()};
}

Verdict judge_once(std::vector<Check> checks, int looks = 1) {
  Evidence evidence;
  evidence.checks = std::move(checks);
  return judge(claim_expected_to_be(Expectation::reproduced), Tier::quick, evidence, 4, 1, looks);
}

/// Mean 0, deviation s: t_interval = +- t s/2 for four values.
std::vector<double> four_about(double mean, double s) {
  const double a = s * std::sqrt(0.75);
  return {mean - a, mean - a, mean + a, mean + a};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(judge_one_check)

// 95 % lower bounds over two looks (.025 each): 8 of 8 .631, 7 of 8 .473, 14 of 16 .617.
BOOST_AUTO_TEST_CASE(a_share_is_a_class_when_most_replicas_have_the_label) {
  const auto judged = [](std::size_t hits, std::size_t trials) {
    Check check = check_of(std::vector<double>(trials, 0), majority);
    std::fill_n(check.values.begin(), hits, 1.0);
    check.share = true;
    return judge_once({check}, 2).checks[0];
  };
  BOOST_CHECK(judged(4, 4).outcome == Outcome::inconclusive);
  BOOST_TEST(judged(4, 4).replicas_needed > 4);
  BOOST_TEST(judged(4, 4).replicas_needed <= 8);
  BOOST_CHECK(judged(8, 8).outcome == Outcome::pass);
  BOOST_TEST(std::abs(judged(8, 8).interval.lo - std::pow(0.025, 1.0 / 8)) < 1e-12);
  BOOST_CHECK(judged(7, 8).outcome == Outcome::inconclusive);
  BOOST_CHECK(judged(14, 16).outcome == Outcome::pass);
  BOOST_CHECK(judged(0, 4).outcome == Outcome::inconclusive);  // 1/16
  BOOST_CHECK(judged(0, 8).outcome == Outcome::fail);          // 1/256 < .005
  BOOST_CHECK(judged(1, 8).outcome == Outcome::inconclusive);  // 9/256
  BOOST_TEST(std::isinf(judged(4, 8).replicas_needed));        // on the edge
}

BOOST_AUTO_TEST_CASE(looks_double_from_four_up_to_the_cap) {
  const auto same = [](int cap, std::vector<int> looks) { return looks_up_to(cap) == looks; };
  BOOST_TEST(same(32, {4, 8, 16, 32}));
  BOOST_TEST(same(16, {4, 8, 16}));
  BOOST_TEST(same(4, {4}));
  BOOST_TEST(same(1, {1}));
  BOOST_TEST(same(1000, {4, 8, 16, 32}));
}

// The interval of four values is mean +- t_{1-alpha, 3} s/2 with t_{0.99, 3} = 4.5407 (tables): half width 2.2704 s.
BOOST_AUTO_TEST_CASE(the_interval_decides_between_pass_fail_and_neither) {
  const Interval band{-1, 1};
  const auto outcome = [&](double mean, double s) { return judge_once({check_of(four_about(mean, s), band)}).outcome; };
  BOOST_CHECK(outcome(0, 0.43) == Outcome::pass);            // +-0.976
  BOOST_CHECK(outcome(0, 0.45) == Outcome::inconclusive);    // +-1.022
  BOOST_CHECK(outcome(0.9, 0.04) == Outcome::pass);          // up to 0.991
  BOOST_CHECK(outcome(0.9, 0.05) == Outcome::inconclusive);  // up to 1.014
  BOOST_CHECK(outcome(1.1, 0.04) == Outcome::fail);          // from 1.009
  BOOST_CHECK(outcome(1.1, 0.05) == Outcome::inconclusive);  // from 0.986
  BOOST_CHECK(outcome(-1.1, 0.04) == Outcome::fail);
}

BOOST_AUTO_TEST_CASE(more_looks_cost_wider_intervals) {
  const Check check = check_of(four_about(0, 0.43), {-1, 1});
  const Verdict one = judge_once({check}, 1), four = judge_once({check}, 4);
  BOOST_TEST(one.alpha == 0.01);
  BOOST_TEST(four.alpha == 0.0025);
  BOOST_TEST(four.checks[0].interval.width() > one.checks[0].interval.width());
  BOOST_CHECK(four.outcome == Outcome::inconclusive);
}

BOOST_AUTO_TEST_CASE(an_open_band_has_one_edge) {
  const Interval positive{0, infinity};
  BOOST_CHECK(judge_once({check_of(four_about(1, 0.4), positive)}).outcome == Outcome::pass);
  BOOST_CHECK(judge_once({check_of(four_about(-1, 0.4), positive)}).outcome == Outcome::fail);
  BOOST_CHECK(judge_once({check_of(four_about(0.5, 0.4), positive)}).outcome == Outcome::inconclusive);
}

BOOST_AUTO_TEST_CASE(the_number_of_replicas_that_would_decide_is_estimated) {
  // t_{0.99, R-1} s/sqrt(R) <= 1 with s = 1: R = 9 (t_{0.99, 8} = 2.896 <= 3) but not 8 (t_{0.99, 7} = 2.998 > 2.828).
  const Verdict centre = judge_once({check_of(four_about(0, 1), {-1, 1})});
  BOOST_TEST(centre.checks[0].replicas_needed == 9);
  // Close to an edge it takes more: distance 0.1, s = 1, t about 2.33: (2.33/0.1)^2 = 543, a little more for t.
  const Verdict edge = judge_once({check_of(four_about(0.9, 1), {-1, 1})});
  BOOST_TEST(edge.checks[0].replicas_needed > 543);
  BOOST_TEST(edge.checks[0].replicas_needed < 550);
  const Verdict on_edge = judge_once({check_of(four_about(1, 1), {-1, 1})});
  BOOST_TEST(on_edge.checks[0].replicas_needed == infinity);
  const Verdict decided = judge_once({check_of(four_about(0, 0.1), {-1, 1})});
  BOOST_TEST(decided.checks[0].replicas_needed == 0);
}

BOOST_AUTO_TEST_CASE(one_replica_decides_nothing_that_needs_statistics) {
  BOOST_CHECK(judge_once({check_of({0}, {-1, 1})}).outcome == Outcome::inconclusive);
  BOOST_CHECK(judge_once({check_of({0}, {-infinity, infinity})}).outcome == Outcome::inconclusive);
}

BOOST_AUTO_TEST_CASE(a_value_that_was_not_measured_leaves_the_check_open) {
  BOOST_CHECK(judge_once({check_of({0, 0, nan_value, 0}, {-1, 1})}).outcome == Outcome::inconclusive);
  BOOST_CHECK(judge_once({check_of({}, {-1, 1})}).outcome == Outcome::inconclusive);
  BOOST_CHECK(judge_once({check_of({nan_value}, {-1, 1}, true)}).outcome == Outcome::inconclusive);
}

BOOST_AUTO_TEST_CASE(an_exact_check_needs_every_value_in_the_band) {
  const Verdict inside = judge_once({check_of({-0.5, 0.9, 1}, {-1, 1}, true)});
  BOOST_CHECK(inside.outcome == Outcome::pass);
  BOOST_TEST(inside.checks[0].interval.lo == -0.5);
  BOOST_TEST(inside.checks[0].interval.hi == 1);
  BOOST_CHECK(judge_once({check_of({0, 0, 0, 1.0001}, {-1, 1}, true)}).outcome == Outcome::fail);
  BOOST_CHECK(judge_once({check_of({0}, {-1, 1}, true)}).outcome == Outcome::pass);  // one replica is enough
}

BOOST_AUTO_TEST_CASE(values_without_scatter_are_judged_by_their_place) {
  BOOST_CHECK(judge_once({check_of({0.5, 0.5, 0.5, 0.5}, {-1, 1})}).outcome == Outcome::pass);
  BOOST_CHECK(judge_once({check_of({1.5, 1.5, 1.5, 1.5}, {-1, 1})}).outcome == Outcome::fail);
}

BOOST_AUTO_TEST_CASE(a_look_that_does_not_exist_is_an_error) {
  const Claim claim = claim_expected_to_be(Expectation::reproduced);
  BOOST_CHECK_THROW(judge(claim, Tier::quick, {}, 4, 2, 1), InputError);
  BOOST_CHECK_THROW(judge(claim, Tier::quick, {}, 4, 0, 1), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(judge_a_claim)

BOOST_AUTO_TEST_CASE(all_checks_must_pass_and_one_failure_is_enough) {
  const Check good = check_of(four_about(0, 0.1), {-1, 1}), open = check_of(four_about(0, 1), {-1, 1}),
              bad = check_of(four_about(3, 0.1), {-1, 1});
  BOOST_CHECK(judge_once({good, good}).outcome == Outcome::pass);
  BOOST_CHECK(judge_once({good, open}).outcome == Outcome::inconclusive);
  BOOST_CHECK(judge_once({good, open, bad}).outcome == Outcome::fail);
  BOOST_CHECK(judge_once({}).outcome == Outcome::inconclusive);
}

// Interval from 1.009 (above): p is a little below 0.01. Alone that fails; among two checks Holm wants 0.005.
BOOST_AUTO_TEST_CASE(failing_takes_more_when_there_are_more_checks) {
  const Check outside = check_of(four_about(1.1, 0.04), {-1, 1}), good = check_of(four_about(0, 0.1), {-1, 1});
  BOOST_CHECK(judge_once({outside}).outcome == Outcome::fail);
  const Verdict two = judge_once({outside, good});
  BOOST_CHECK(two.outcome == Outcome::inconclusive);
  BOOST_CHECK(two.checks[0].outcome == Outcome::inconclusive);
  BOOST_TEST(two.checks[0].replicas_needed > 4);
  // Exact checks are no tests and take no part in the correction.
  BOOST_CHECK(judge_once({outside, check_of({0}, {-1, 1}, true)}).outcome == Outcome::fail);
}

BOOST_AUTO_TEST_CASE(a_failed_health_check_makes_any_claim_inconclusive) {
  Evidence evidence;
  evidence.checks = {check_of(four_about(0, 0.1), {-1, 1})};
  evidence.health = {{"good", true, ""}};
  const Claim claim = claim_expected_to_be(Expectation::reproduced);
  BOOST_CHECK(judge(claim, Tier::quick, evidence, 4, 1, 1).outcome == Outcome::pass);
  evidence.health.push_back({"steady", false, "z = 7"});
  const Verdict verdict = judge(claim, Tier::quick, evidence, 4, 1, 1);
  BOOST_CHECK(verdict.outcome == Outcome::inconclusive);
  BOOST_TEST(!verdict.green);
  BOOST_TEST(verdict.summary.find("steady: z = 7") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(green_is_agreement_with_the_expectation) {
  using enum Outcome;
  using enum Expectation;
  for (const Outcome outcome : {pass, fail, inconclusive})
    for (const Expectation expected : {reproduced, refuted, unresolved})
      BOOST_TEST(agrees(outcome, expected) == (static_cast<int>(outcome) == static_cast<int>(expected)));
  Evidence evidence;
  evidence.checks = {check_of(four_about(3, 0.1), {-1, 1})};
  BOOST_TEST(judge(claim_expected_to_be(refuted), Tier::quick, evidence, 4, 1, 1).green);
  BOOST_TEST(!judge(claim_expected_to_be(reproduced), Tier::quick, evidence, 4, 1, 1).green);
}

BOOST_AUTO_TEST_CASE(outcomes_have_names) {
  for (const Outcome o : {Outcome::pass, Outcome::fail, Outcome::inconclusive})
    BOOST_CHECK(outcome_named(name_of(o)) == o);
  BOOST_CHECK_THROW(outcome_named("maybe"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
