#include "verify/drift.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

using gpf::drift_test;
using gpf::DriftTest;

namespace {

using Replicas = std::vector<std::vector<double>>;

/// Stationary AR(1) series, variance 1, with a correlation time of `tau` blocks (0: white).
Replicas series(std::size_t replicas, std::size_t blocks, double tau, std::mt19937_64& generator) {
  const double rho = tau > 0 ? std::exp(-1 / tau) : 0;
  std::normal_distribution<double> normal;
  Replicas result;
  for (std::size_t r = 0; r < replicas; ++r) {
    auto& s = result.emplace_back();
    for (double x = normal(generator); s.size() < blocks; x = rho * x + std::sqrt(1 - rho * rho) * normal(generator))
      s.push_back(x);
  }
  return result;
}

struct Rates {
  double halves = 0, first_quarter = 0;
};

Rates false_alarms(std::size_t replicas, std::size_t blocks, double tau, double level, int experiments) {
  std::mt19937_64 generator(7);
  Rates rates;
  for (int e = 0; e < experiments; ++e) {
    const DriftTest test = drift_test(series(replicas, blocks, tau, generator));
    rates.halves += (test.halves_p < level) / static_cast<double>(experiments);
    rates.first_quarter += (test.first_quarter_p < level) / static_cast<double>(experiments);
  }
  return rates;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(drift)

// Two replicas, four blocks, by hand: rows (0 0 1 1) and (0 0 1 3). Course (0 0 1 2), mean 3/4; row means 1/2 and 1.
// Residuals (row - its mean) - (course - its mean): first row 1/4 1/4 1/4 -3/4, second the opposite; squares 2 x 12/16.
// Variance of a cell 1.5/3 = 1/2, of the course 1/4. Halves: (1 + 2)/2 = 3/2, error 1/2, t = 3 with 3 degrees of
// freedom: two-sided p = 0.05767 (tables: t_{.975} = 3.18). First quarter: 0 - 1 = -1, error sqrt(1/4 x 4/3) = 0.577,
// t = 1.732: p = 0.18169.
BOOST_AUTO_TEST_CASE(a_small_table_agrees_with_the_hand_calculation) {
  const DriftTest test = drift_test({{0, 0, 1, 1}, {0, 0, 1, 3}});
  BOOST_TEST(test.halves_p == 0.05767, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(test.first_quarter_p == 0.18169, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(levels_of_replicas_do_not_matter_and_blocks_are_averaged) {
  const DriftTest plain = drift_test({{0, 0, 1, 1}, {0, 0, 1, 3}});
  const DriftTest shifted = drift_test({{5, 5, 6, 6}, {-2, -2, -1, 1}});
  BOOST_TEST(shifted.halves_p == plain.halves_p, boost::test_tools::tolerance(1e-12));
  // Two blocks to a quarter, and one more at the start that is left out.
  const DriftTest longer = drift_test({{9, -1, 1, 0, 0, 1, 1, 0, 2}, {9, 1, -1, 2, -2, 1, 1, 3, 3}});
  BOOST_TEST(longer.halves_p == plain.halves_p, boost::test_tools::tolerance(1e-12));
}

// The documented rates, each within four standard deviations of a measured rate (4 sqrt(0.0027/20000) = 0.0015).
BOOST_AUTO_TEST_CASE(stationary_series_raise_false_alarms_at_the_stated_rate) {
  const double level = 0.0027;
  for (const std::size_t replicas : {4U, 8U}) {
    const Rates white = false_alarms(replicas, 64, 0, level, 20000);
    BOOST_TEST(std::abs(white.halves - level) < 0.0015);
    BOOST_TEST(std::abs(white.first_quarter - level) < 0.0015);
  }
  const Rates slow = false_alarms(4, 128, 10, level, 20000);  // window: 13 correlation times
  BOOST_TEST(slow.halves < 0.0060);
  BOOST_TEST(slow.first_quarter < 0.0060);
}

// The end of a transient in the window: a fall by five standard deviations of a block with a time of an eighth of the
// window. Its part in the first quarter's mean is 5 x (1/2)(1 - e^-2) = 2.2, against an error of (1/sqrt(16))
// sqrt(4/3)/2.
BOOST_AUTO_TEST_CASE(a_start_up_that_was_not_discarded_is_seen) {
  std::mt19937_64 generator(11);
  for (int e = 0; e < 100; ++e) {
    Replicas replicas = series(4, 64, 0, generator);
    for (auto& s : replicas)
      for (std::size_t b = 0; b < s.size(); ++b) s[b] += 5 * std::exp(-static_cast<double>(b) / 8);
    BOOST_TEST(drift_test(replicas).first_quarter_p < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(a_constant_does_not_drift_and_a_step_without_noise_does) {
  BOOST_TEST(drift_test({{1, 1, 1, 1}, {2, 2, 2, 2}}).halves_p == 1);
  BOOST_TEST(drift_test({{1, 1, 2, 2}, {1, 1, 2, 2}}).halves_p == 0);
}

BOOST_AUTO_TEST_CASE(too_little_data_gives_no_answer) {
  BOOST_TEST(std::isnan(drift_test({{1, 2, 3, 4}}).halves_p));
  BOOST_TEST(std::isnan(drift_test({{1, 2, 3}, {1, 2, 3}}).first_quarter_p));
  BOOST_TEST(std::isnan(drift_test({}).halves_p));
}

BOOST_AUTO_TEST_SUITE_END()
