#include "verify/report_check.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "unit/verify/synthetic_claim.hpp"
#include "verify/verdict_summary.hpp"

using gpf::JudgedCheck;
using gpf::Outcome;
using gpf::test::check;
using gpf::test::infinity;

namespace {

std::vector<JudgedCheck> judged(std::vector<gpf::Check> checks) {
  return gpf::test::judged("a", std::move(checks)).verdict.checks;
}

/// One check of an identity, whose values must all lie in the band.
gpf::Check exact(std::vector<double> values, gpf::Interval band) {
  return {"exact", std::move(values), band, true, 0, 0};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(report_check)

BOOST_AUTO_TEST_CASE(a_band_becomes_minus_one_to_one) {
  const auto c = judged({check("a", 3.5, 0.01, {2, 4})}).front();  // centre 3, half width 1
  const auto scaled = gpf::scaled_to_band(c);
  BOOST_REQUIRE(scaled.has_value());
  BOOST_TEST(scaled->value == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(scaled->lo == c.interval.lo - 3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(scaled->hi == c.interval.hi - 3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(!gpf::scaled_to_bound(c).has_value());
}

BOOST_AUTO_TEST_CASE(a_bound_is_measured_in_standard_errors_from_the_wanted_side) {
  // 0.4 from the bound with a standard error of 0.1, once inside and once outside.
  const auto checks = judged({check("a", 0.4, 0.1, {0, infinity}), check("b", 0.4, 0.1, {-infinity, 0})});
  BOOST_TEST(gpf::scaled_to_bound(checks[0])->value == 4, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(gpf::scaled_to_bound(checks[1])->value == -4, boost::test_tools::tolerance(1e-12));
  for (const JudgedCheck& c : checks) {
    BOOST_TEST(!gpf::scaled_to_band(c).has_value());
    BOOST_TEST(gpf::scaled_to_bound(c)->lo < gpf::scaled_to_bound(c)->hi);
  }
  BOOST_TEST(gpf::margin_text(checks[0]) == "4.0 se");
  BOOST_TEST(gpf::margin_text(checks[1]) == "-4.0 se");
}

BOOST_AUTO_TEST_CASE(checks_that_cannot_be_scaled) {
  const auto checks = judged({check("no width", 0, 0.1, {1, 1}), exact({}, {0, 1}), exact({0.5}, {0, infinity})});
  for (const JudgedCheck& c : checks) {
    BOOST_TEST(!gpf::scaled_to_band(c).has_value());
    BOOST_TEST(!gpf::scaled_to_bound(c).has_value());
  }
}

BOOST_AUTO_TEST_CASE(numbers_in_words) {
  const auto checks = judged(
      {check("a", 0.123456, 0.01, {0, 1}), exact({0.25, 0.3}, {0, 1}), exact({}, {0, 1}), exact({7}, {-infinity, 8})});
  BOOST_TEST(gpf::value_text(checks[0]) == "0.123");  // the interval reaches 0.045 to each side
  BOOST_TEST(gpf::interval_text(checks[0]) == "[0.078, 0.169]");
  BOOST_TEST(gpf::value_text(checks[1]) == "0.25 ... 0.3");
  BOOST_TEST(gpf::interval_text(checks[1]) == "exact");
  BOOST_TEST(gpf::margin_text(checks[1]) == "exact, 50 % of band");
  BOOST_TEST(gpf::value_text(checks[2]) == "-");
  BOOST_TEST(gpf::margin_text(checks[2]) == "-");
  BOOST_TEST(gpf::value_text(checks[3]) == "7");
  BOOST_TEST(gpf::margin_text(checks[3]) == "exact");
  BOOST_TEST(gpf::band_text({0.5, 1.5}) == "[0.5, 1.5]");
  BOOST_TEST(gpf::band_text({-infinity, 8}) == "<= 8");
  BOOST_TEST(gpf::band_text({8, infinity}) == ">= 8");
}

BOOST_AUTO_TEST_CASE(the_tightest_are_failed_then_undecided_then_near_an_edge) {
  const auto checks = judged({check("far", 0, 0.01, {-1, 1}), check("near", 0.9, 0.01, {-1, 1}),
                              check("open", 0.99, 0.01, {-1, 1}), check("out", 2, 0.01, {-1, 1})});
  BOOST_REQUIRE((checks[2].outcome == Outcome::inconclusive));
  BOOST_REQUIRE((checks[3].outcome == Outcome::fail));
  const auto first = [&](std::size_t count) { return gpf::tightest(checks, count); };
  BOOST_TEST(first(1) == std::vector<std::size_t>({3}));
  BOOST_TEST(first(2) == std::vector<std::size_t>({2, 3}));
  BOOST_TEST(first(3) == std::vector<std::size_t>({1, 2, 3}));
  BOOST_TEST(first(9) == std::vector<std::size_t>({0, 1, 2, 3}));
}

BOOST_AUTO_TEST_SUITE_END()
