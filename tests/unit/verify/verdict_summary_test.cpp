#include "verify/verdict_summary.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

using namespace gpf;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Verdict judged(std::vector<Check> checks) {
  Evidence evidence;
  evidence.checks = std::move(checks);
  return judge({}, Tier::quick, evidence, 4, 1, 1);
}

/// Deviation 0.1, so +-0.227 (judge_test.cpp).
std::vector<double> about(double mean) {
  const double a = 0.1 * 0.86602540378443865;
  return {mean - a, mean - a, mean + a, mean + a};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(verdict_summary)

BOOST_AUTO_TEST_CASE(numbers_have_the_digits_that_their_uncertainty_leaves) {
  BOOST_TEST(rounded(2.06326, 0.0123) == "2.063");
  BOOST_TEST(rounded(2.06326, 0.99) == "2.06");
  BOOST_TEST(rounded(-0.5, 0.227) == "-0.50");
  BOOST_TEST(rounded(1234567, 1000) == "1.2346e+06");
  BOOST_TEST(rounded(1e-15, 2e-16) == "1.00e-15");
  BOOST_TEST(rounded(3, 0) == "3");
  BOOST_TEST(rounded(infinity, 1) == "inf");
}

BOOST_AUTO_TEST_CASE(a_pass_shows_the_tightest_check) {
  const Verdict v = judged({{"roomy", about(0), {-5, 5}}, {"tight", about(0.5), {-1, 1}}});
  BOOST_TEST(deciding_check(v)->check.label == "tight");
  BOOST_TEST(v.summary == "tight: 0.50 +- 0.23, wanted [-1, 1] (2 of 2 checks pass)");
}

BOOST_AUTO_TEST_CASE(a_fail_shows_the_check_furthest_outside) {
  const Verdict v = judged({{"good", about(0), {-1, 1}}, {"bad", about(3), {-1, 1}}, {"worse", about(9), {-1, 1}}});
  BOOST_TEST(v.summary == "worse: 9.00 +- 0.23, wanted [-1, 1] (2 of 3 checks fail)");
}

BOOST_AUTO_TEST_CASE(an_open_verdict_says_how_many_replicas_would_decide) {
  const Verdict v = judged({{"open", about(0.9), {-1, infinity}}, {"wide", about(0), {-0.2, 0.2}}});
  BOOST_TEST(v.summary.starts_with("wide: 0.00 +- 0.23, wanted [-0.2, 0.2] (1 of 2 checks undecided); about 5"));
  BOOST_TEST(judged({{"edge", about(1), {1, infinity}}}).summary ==
             "edge: 1.00 +- 0.23, wanted >= 1; on the edge of its band, more replicas would not decide");
}

BOOST_AUTO_TEST_CASE(exact_unmeasured_and_missing_checks_have_words) {
  BOOST_TEST(judged({{"drift", {1e-15, 2e-15}, {-1e-12, 1e-12}, true}}).summary ==
             "drift: 1e-15 ... 2e-15, wanted [-1e-12, 1e-12]");
  BOOST_TEST(judged({{"none", {}, {0, 1}}}).summary == "none: no values");
  BOOST_TEST(judged({{"gap", {1, std::numeric_limits<double>::quiet_NaN()}, {0, 2}}}).summary ==
             "gap: not measured in every replica");
  BOOST_TEST(judged({{"single", {1}, {0, 2}}}).summary == "single: 1, one replica gives no error");
  BOOST_TEST(judged({}).summary == "the estimator found nothing to check");
  BOOST_TEST(deciding_check(judged({})) == nullptr);
}

BOOST_AUTO_TEST_CASE(a_band_that_is_hardly_used_is_reported) {
  const auto note = [](std::vector<Check> checks) { return unused_tolerance(judged(std::move(checks)).checks); };
  BOOST_TEST(!note({{"a", about(0), {-3, 3}}}).empty());                           // 0.227/3 = 7.6 %
  BOOST_TEST(note({{"a", about(0), {-2, 2}}}).empty());                            // 11 %
  BOOST_TEST(note({{"a", about(0.2), {-3, 3}}}).empty());                          // 14 %
  BOOST_TEST(note({{"a", about(0), {-3, 3}}, {"b", about(0), {-1, 1}}}).empty());  // one of them uses its own
  BOOST_TEST(note({{"a", about(9), {0, infinity}}}).empty());                      // an inequality
  BOOST_TEST(note({{"a", about(0), {-3, 3}}, {"b", about(9), {-1, 1}}}).empty());  // a fail: no advice
  const Verdict v = judged({{"a", about(0), {-3, 3}}});
  BOOST_TEST(v.notes.size() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()
