// Block errors against series whose true error is known.
#include "gpf/stats/blocks.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "synthetic.hpp"

namespace {

using namespace gpf;

BOOST_AUTO_TEST_SUITE(blocks)

BOOST_AUTO_TEST_CASE(by_hand) {
  // 1 -1 1 -1 ...: naive error sqrt(16/(16 15)); all pair averages are 0, so longer blocks add nothing.
  std::vector<double> series;
  for (int k = 0; k < 16; ++k) series.push_back(k % 2 == 0 ? 1 : -1);
  const BlockError result = block_error(series);
  BOOST_TEST(result.mean == 0.0);
  BOOST_TEST(result.error == std::sqrt(1.0 / 15), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(result.blocking_level == 0);
  BOOST_TEST(result.blocks == 16u);
  BOOST_TEST(result.plateau);
}

BOOST_AUTO_TEST_CASE(repeated_values_are_one_block) {
  // Each of 64 independent values is repeated 8 times: levels 0 ... 3 grow, level 3 has the error of the 64 values.
  const std::vector<double> values = synthetic::white(11, 64);
  std::vector<double> series;
  for (const double v : values) series.insert(series.end(), 8, v);
  const BlockError result = block_error(series);
  BOOST_TEST(result.blocking_level >= 3);
  BOOST_TEST(result.mean == block_error(values).mean, boost::test_tools::tolerance(1e-12));
  // The error of the error at 64 blocks is 1/sqrt(126) = 9 %, at the 8 blocks of the last level 27 %: 3 of those apart.
  BOOST_TEST(std::abs(result.error / block_error(values).error - 1) < 3 * 0.27);
}

BOOST_AUTO_TEST_CASE(independent_values_keep_their_naive_error) {
  // Over 200 series of 1024 the mean squared error must be 1/1024. One error^2 scatters by sqrt(2/1023) = 4.4 % at
  // level 0, more where a longer block was taken: at most 20 %, so 1.4 % for the mean of 200. Taking the larger of
  // several levels can only bias it upwards; the rule is made to let that be below 10 % (8 % over 10,000 series). Of
  // those, .2 % had no plateau: .4 of 200, and 5 with probability 1e-4.
  double squares = 0;
  int plateaus = 0;
  for (std::uint64_t key = 0; key < 200; ++key) {
    const BlockError result = block_error(synthetic::white(key, 1024));
    squares += result.error * result.error;
    plateaus += result.plateau ? 1 : 0;
  }
  const double ratio = squares / 200 * 1024;
  BOOST_TEST(ratio > 1 - 3 * 0.014);
  BOOST_TEST(ratio < 1.10 + 3 * 0.014);
  BOOST_TEST(plateaus > 195);
}

BOOST_AUTO_TEST_CASE(correlated_series_get_their_true_error) {
  // phi = exp(-1/20): 8192 values are worth about 205. Blocks at least 4(g - 1) long hide at most 1/8 of error^2;
  // the scatter of one error^2 at some 30 blocks is 28 %, of the mean over 100 series 2.8 %. .3 % of such series show
  // no plateau: .3 of 100, and 4 with probability 3e-4.
  const double phi = std::exp(-1.0 / 20), truth = synthetic::variance_of_mean(8192, phi);
  double squares = 0;
  int misses = 0, plateaus = 0;
  for (std::uint64_t key = 1000; key < 1100; ++key) {
    const BlockError result = block_error(synthetic::autoregressive(key, 8192, phi));
    plateaus += result.plateau ? 1 : 0;
    BOOST_TEST(result.blocking_level >= 4);  // blocks shorter than 16 could not hold the 40 that belong together
    squares += result.error * result.error;
    misses += std::abs(result.mean) > 1.96 * result.error ? 1 : 0;
  }
  const double ratio = squares / 100 / truth;
  BOOST_TEST(ratio > 1 - 0.125 - 3 * 0.028);
  BOOST_TEST(ratio < 1.10 + 3 * 0.028);
  BOOST_TEST(plateaus > 96);
  // Coverage: 5 % of 100, 6.5 % with errors that scatter by 14 % and are a little low. 17 or more: probability 3e-4.
  BOOST_TEST(misses < 17);
}

BOOST_AUTO_TEST_CASE(a_slow_mode_under_fast_noise_is_found) {
  // 90 % white noise and 10 % of variance with a correlation time of 100: the first level shows a correlation of .1
  // only, but the true variance of the mean is 20 times the naive one.
  const std::size_t n = 32768;
  const double phi = std::exp(-1.0 / 100);
  const double truth = 0.1 * synthetic::variance_of_mean(n, phi) + 0.9 / static_cast<double>(n);
  double squares = 0;
  for (std::uint64_t key = 2000; key < 2030; ++key) {
    std::vector<double> series = synthetic::autoregressive(key, n, phi);
    const std::vector<double> noise = synthetic::white(key + 50000, n);
    for (std::size_t k = 0; k < n; ++k) series[k] = std::sqrt(0.1) * series[k] + std::sqrt(0.9) * noise[k];
    const BlockError result = block_error(series);
    squares += result.error * result.error;
  }
  // One error^2 scatters by 32 %, the mean of 30 by 5.8 %; 1/8 may be hidden.
  const double ratio = squares / 30 / truth;
  BOOST_TEST(ratio > 1 - 0.125 - 3 * 0.058);
  BOOST_TEST(ratio < 1.10 + 3 * 0.058);
}

BOOST_AUTO_TEST_CASE(a_fall_of_the_error_does_not_end_the_search) {
  // +-1 alternating, and a square wave of amplitude .3 and period 64. Pairs cancel the former, so level 1 has a smaller
  // error than level 0; half a period is a block at level 5: 32 blocks of +-.3, error .3/sqrt(31). Longer blocks
  // cancel.
  std::vector<double> series;
  for (int k = 0; k < 1024; ++k) series.push_back((k % 2 == 0 ? 1 : -1) + (k % 64 < 32 ? 0.3 : -0.3));
  const BlockError result = block_error(series);
  BOOST_TEST(result.blocking_level == 5);
  BOOST_TEST(result.error == 0.3 / std::sqrt(31.0), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(result.plateau);
}

BOOST_AUTO_TEST_CASE(a_series_too_short_for_its_correlation_has_no_plateau) {
  // 128 values with correlation time 100 hold about one independent value: no plateau in 10,000 other series.
  int plateaus = 0;
  for (std::uint64_t key = 3000; key < 3100; ++key) {
    plateaus += block_error(synthetic::autoregressive(key, 128, std::exp(-1.0 / 100))).plateau ? 1 : 0;
  }
  BOOST_TEST(plateaus == 0);

  // A drift is correlation without end: each level's error is larger.
  std::vector<double> drift;
  for (int k = 0; k < 256; ++k) drift.push_back(0.3 * k);
  BOOST_TEST(!block_error(drift).plateau);
  BOOST_TEST(block_error(drift).blocks == 8u);
}

BOOST_AUTO_TEST_CASE(shift_and_scale) {
  const std::vector<double> series = synthetic::autoregressive(5, 500, 0.7);
  std::vector<double> other;
  for (const double v : series) other.push_back(-4 * v + 16);  // exact but for the last bits of the sum
  const BlockError a = block_error(series), b = block_error(other);
  BOOST_TEST(b.mean == 16 - 4 * a.mean, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(b.error == 4 * a.error, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(b.blocking_level == a.blocking_level);
}

BOOST_AUTO_TEST_CASE(too_little_data) {
  const BlockError seven = block_error(std::vector<double>{1, 2, 3, 4, 5, 6, 7});
  BOOST_TEST(seven.mean == 4.0);
  BOOST_TEST(std::isnan(seven.error));
  BOOST_TEST(!seven.plateau);
  BOOST_TEST(std::isnan(block_error({}).mean));
  // Eight values: one level only, which nothing confirms. Their error is sqrt(42/(8 7)).
  const BlockError eight = block_error(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8});
  BOOST_TEST(eight.error == std::sqrt(42.0 / 56), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(!eight.plateau);
}

BOOST_AUTO_TEST_CASE(constant_and_undefined_series) {
  const BlockError constant = block_error(std::vector<double>(64, 2.5));
  BOOST_TEST(constant.mean == 2.5);
  BOOST_TEST(constant.error == 0.0);
  BOOST_TEST(constant.plateau);
  std::vector<double> series(64, 1.0);
  series[13] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(std::isnan(block_error(series).mean));
  BOOST_TEST(std::isnan(block_error(series).error));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
