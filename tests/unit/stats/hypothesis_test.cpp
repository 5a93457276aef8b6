// p-values against worked examples, against the intervals they belong to, and their uniformity under the null
// hypothesis.
#include "gpf/stats/hypothesis.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/error.hpp"
#include "synthetic.hpp"

namespace {

using namespace gpf;
using Numbers = std::vector<double>;

/// Largest distance of sorted values from the uniform distribution, times sqrt(n) (Kolmogorov-Smirnov).
double distance_from_uniform(Numbers p) {
  std::sort(p.begin(), p.end());
  const double n = static_cast<double>(p.size());
  double distance = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double below = static_cast<double>(k) / n;
    distance = std::max({distance, p[k] - below, below + 1 / n - p[k]});
  }
  return distance * std::sqrt(n);
}

BOOST_AUTO_TEST_SUITE(hypothesis)

BOOST_AUTO_TEST_CASE(chi2_in_closed_form) {
  // Two degrees of freedom: exp(-chi2/2); four: (1 + chi2/2) exp(-chi2/2). One: erfc(sqrt(chi2/2)).
  BOOST_TEST(chi2_p_value(3.7, 2) == std::exp(-1.85), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(chi2_p_value(3.7, 4) == 2.85 * std::exp(-1.85), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(chi2_p_value(3.7, 1) == std::erfc(std::sqrt(1.85)), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(chi2_p_value(0, 5) == 1.0);
  BOOST_CHECK_THROW(chi2_p_value(-1, 3), InputError);
  BOOST_CHECK_THROW(chi2_p_value(1, 0), InputError);
}

BOOST_AUTO_TEST_CASE(welch_by_hand) {
  // Means 3 and 7, variances 2.5 and 40/3, counts 5 and 4: squared errors .5 and 10/3.
  const WelchTest t = welch(summarise(Numbers{1, 2, 3, 4, 5}), summarise(Numbers{3, 5, 9, 11}));
  BOOST_TEST(t.difference == -4.0);
  BOOST_TEST(t.error == std::sqrt(0.5 + 10.0 / 3), boost::test_tools::tolerance(1e-14));
  const double dof = std::pow(0.5 + 10.0 / 3, 2) / (0.25 / 4 + 100.0 / 27);
  BOOST_TEST(t.degrees_of_freedom == dof, boost::test_tools::tolerance(1e-14));
  // The p-value is the alpha at which the interval just touches 0.
  BOOST_TEST(std::abs(t.interval(t.p_value / 2).hi) < 1e-9);
}

BOOST_AUTO_TEST_CASE(equal_variances_and_counts_give_students_test) {
  // Then the degrees of freedom are 2(R - 1).
  const WelchTest t = welch(summarise(Numbers{1, 2, 3}), summarise(Numbers{11, 12, 13}));
  BOOST_TEST(t.degrees_of_freedom == 4.0, boost::test_tools::tolerance(1e-14));
  // t = -10/sqrt(2/3); P(|t| > x) with 4 degrees of freedom = 1 - (3/2) s + (1/2) s^3 with s = x/sqrt(x^2 + 4).
  const double x = 10 / std::sqrt(2.0 / 3), s = x / std::sqrt(x * x + 4);
  BOOST_TEST(t.p_value == 1 - 1.5 * s + 0.5 * s * s * s, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(auditing_a_version_against_itself_gives_uniform_p_values) {
  // 2000 Welch tests of 8 against 8 from one distribution. sqrt(n) D > 2.23 has probability 2 exp(-2 2.23^2) = 1e-4;
  // the Welch approximation itself is off by less than .002 here, .09 in sqrt(n) D.
  Numbers p;
  for (std::uint64_t key = 0; key < 2000; ++key) {
    const Numbers g = synthetic::white(key, 16);
    p.push_back(welch(summarise(std::span(g).first(8)), summarise(std::span(g).last(8))).p_value);
  }
  BOOST_TEST(distance_from_uniform(p) < 2.23 + 0.09);
}

BOOST_AUTO_TEST_CASE(identical_versions) {
  // Bitwise equal runs have no scatter in the difference to test: equal means are equal, other means differ for
  // certain.
  const ReplicaSummary a{2, 0, 4}, b{3, 0, 4};
  BOOST_TEST(welch(a, a).p_value == 1.0);
  BOOST_TEST(welch(a, b).p_value == 0.0);
  BOOST_TEST(equivalence_p_value(welch(a, b), 1.5) == 0.0);
  BOOST_TEST(equivalence_p_value(welch(a, b), 0.5) == 1.0);
}

BOOST_AUTO_TEST_CASE(equivalence_agrees_with_its_interval) {
  const double alpha = 0.05;
  int equivalent = 0;
  for (std::uint64_t key = 0; key < 300; ++key) {
    const Numbers g = synthetic::white(key, 16);
    const WelchTest t = welch(summarise(std::span(g).first(8)), summarise(std::span(g).last(8)));
    const bool within = Interval{-1.2, 1.2}.contains(t.interval(alpha));
    BOOST_TEST((equivalence_p_value(t, 1.2) < alpha) == within);
    equivalent += within ? 1 : 0;
  }
  // The case must be a mixed one, or the comparison says nothing.
  BOOST_TEST(equivalent > 30);
  BOOST_TEST(equivalent < 290);
}

BOOST_AUTO_TEST_CASE(equivalence_is_rarely_claimed_for_a_difference_of_the_margin) {
  // True difference exactly the margin: claimed with probability alpha = .05 at most; 2000 pairs: 100 +- 9.7.
  int claimed = 0;
  for (std::uint64_t key = 0; key < 2000; ++key) {
    Numbers g = synthetic::white(key + 40000, 16);
    for (std::size_t k = 0; k < 8; ++k) g[k] += 3;
    const WelchTest t = welch(summarise(std::span(g).first(8)), summarise(std::span(g).last(8)));
    claimed += equivalence_p_value(t, 3) < 0.05 ? 1 : 0;
  }
  BOOST_TEST(claimed > 100 - 4 * 9.7);
  BOOST_TEST(claimed < 100 + 4 * 9.7);
}

BOOST_AUTO_TEST_CASE(outside_a_band_agrees_with_the_interval) {
  const Interval band{0.8, 2};
  int disjoint = 0;
  for (std::uint64_t key = 0; key < 300; ++key) {
    const ReplicaSummary s = summarise(synthetic::white(key, 6));
    const bool apart = band.disjoint(t_interval(s, 0.05));
    BOOST_TEST((outside_band_p_value(s, band) < 0.05) == apart);
    disjoint += apart ? 1 : 0;
  }
  BOOST_TEST(disjoint > 30);
  BOOST_TEST(disjoint < 270);
  BOOST_TEST(outside_band_p_value({1, 0.5, 4}, band) == 1.0);
  BOOST_TEST(std::isnan(outside_band_p_value({std::numeric_limits<double>::quiet_NaN(), 0.5, 4}, band)));
}

BOOST_AUTO_TEST_CASE(holm_by_hand) {
  // .01 x 4, .02 x 3, .03 x 2 = .06, and .04 lifted to .06; given out of order.
  const Numbers p = {0.04, 0.01, 0.03, 0.02};
  const Numbers expected = {0.06, 0.04, 0.06, 0.06};
  const Numbers adjusted = holm(p);
  for (std::size_t k = 0; k < p.size(); ++k) {
    BOOST_TEST(adjusted[k] == expected[k], boost::test_tools::tolerance(1e-14));
  }
  BOOST_TEST(holm(Numbers{0.9, 0.8})[0] == 1.0);
  BOOST_TEST(holm({}).empty());
  BOOST_CHECK_THROW(holm(Numbers{0.1, 1.1}), InputError);
  BOOST_CHECK_THROW(holm(Numbers{std::numeric_limits<double>::quiet_NaN()}), InputError);
}

BOOST_AUTO_TEST_CASE(holm_keeps_the_family_wise_error_rate) {
  // 18 bins without any effect, rejected anywhere with probability 1 - (1 - .05/18)^18 = .0488; 3000 profiles: 146
  // +- 11.8.
  int alarms = 0;
  for (std::uint64_t key = 0; key < 3000; ++key) {
    Numbers p = synthetic::white(key + 90000, 18);
    for (double& v : p) v = std::erfc(-v / std::sqrt(2.0)) / 2;  // uniform
    const Numbers adjusted = holm(p);
    alarms += *std::min_element(adjusted.begin(), adjusted.end()) <= 0.05 ? 1 : 0;
  }
  BOOST_TEST(std::abs(alarms - 146) < 4 * 11.8);
}

BOOST_AUTO_TEST_CASE(refusals) {
  const ReplicaSummary one{1, 0, 1}, two{1, 1, 2};
  BOOST_CHECK_THROW(welch(one, two), InputError);
  BOOST_CHECK_THROW(welch(two, one), InputError);
  BOOST_CHECK_THROW(equivalence_p_value(welch(two, two), 0), InputError);
  BOOST_CHECK_THROW(static_cast<void>(welch(two, two).interval(0.7)), InputError);
  BOOST_CHECK_THROW(outside_band_p_value(one, {0, 1}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
