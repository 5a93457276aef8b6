// The jackknife against closed forms and against ensembles with known truth.
#include "gpf/stats/jackknife.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/stats/blocks.hpp"
#include "synthetic.hpp"

namespace {

using namespace gpf;
using Numbers = std::vector<double>;
using Sums = std::span<const double>;

BOOST_AUTO_TEST_SUITE(jackknife_estimates)

BOOST_AUTO_TEST_CASE(of_a_mean_is_the_block_error) {
  // One count per block: the pseudo-values of sum/count are the values themselves.
  const Numbers values = synthetic::autoregressive(21, 256, 0.8);
  Numbers sums;
  for (const double v : values) sums.insert(sums.end(), {v, 1.0});
  const auto result = jackknife(sums, values.size(), [](Sums s) { return Numbers{s[0] / s[1]}; });
  const BlockError expected = block_error(values);
  // Pseudo-values lose the factor B = 256 of precision: 256 epsilon relative to values of order 1.
  BOOST_REQUIRE(result.size() == 1u);
  BOOST_TEST(std::abs(result[0].mean - expected.mean) < 1e-12);
  BOOST_TEST(result[0].error == expected.error, boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(of_a_square_by_hand) {
  // Blocks 1 ... 8, q = (mean)^2 = 20.25. Pseudo-value of block b: 8 (36/8)^2 - 7 ((36 - b)/7)^2.
  Numbers sums, pseudo;
  for (int b = 1; b <= 8; ++b) {
    sums.insert(sums.end(), {1.0 * b, 1.0});
    pseudo.push_back(8 * 20.25 - 7 * std::pow((36 - b) / 7.0, 2));
  }
  const auto result = jackknife(sums, 8, [](Sums s) { return Numbers{std::pow(s[0] / s[1], 2)}; });
  BOOST_TEST(result[0].mean == 20.25);
  BOOST_TEST(result[0].error == block_error(pseudo).error, boost::test_tools::tolerance(1e-12));
  // Linear theory: 2 x mean x its error, 2 x 4.5 x sqrt(42/56) = 7.79; curvature is of second order in (1/8).
  BOOST_TEST(result[0].error == 9 * std::sqrt(0.75), boost::test_tools::tolerance(1.0 / 8));
}

BOOST_AUTO_TEST_CASE(of_a_ratio_of_correlated_sums) {
  // Numerator 3 x denominator + small noise: the naive errors of the two sums would be far too large for the ratio.
  // True variance of the ratio: .1^2/(B <count>^2) for counts 10 + normal: .01/(B 100) up to 1 %.
  double squares = 0;
  const std::size_t blocks = 64;
  for (std::uint64_t key = 0; key < 200; ++key) {
    const Numbers a = synthetic::white(key, blocks), b = synthetic::white(key + 7777, blocks);
    Numbers sums;
    for (std::size_t k = 0; k < blocks; ++k) {
      const double count = 10 + a[k];
      sums.insert(sums.end(), {3 * count + 0.1 * b[k], count});
    }
    const Estimate ratio = jackknife(sums, blocks, [](Sums s) { return Numbers{s[0] / s[1]}; })[0];
    BOOST_TEST(std::abs(ratio.mean - 3) < 6 * ratio.error);
    squares += ratio.error * ratio.error;
  }
  // One error^2 scatters by about 20 %, the mean of 200 by 1.4 %; level selection may add up to 10 %.
  const double relative = squares / 200 / (0.01 / (blocks * 100.0));
  BOOST_TEST(relative > 1 - 0.01 - 3 * 0.014);
  BOOST_TEST(relative < 1.11 + 3 * 0.014);
}

BOOST_AUTO_TEST_CASE(of_a_kurtosis) {
  // 64 blocks of 100 Gaussian numbers: variance of the kurtosis 24/n = 24/6400.
  double squares = 0;
  for (std::uint64_t key = 0; key < 60; ++key) {
    const Numbers g = synthetic::white(key + 300, 6400);
    Numbers sums(64 * 3, 0.0);
    for (std::size_t k = 0; k < g.size(); ++k) {
      const std::size_t row = 3 * (k / 100);
      sums[row] += 1;
      sums[row + 1] += g[k] * g[k];
      sums[row + 2] += std::pow(g[k], 4);
    }
    const Estimate kurtosis = jackknife(sums, 64, [](Sums s) { return Numbers{s[2] * s[0] / (s[1] * s[1])}; })[0];
    squares += kurtosis.error * kurtosis.error;
  }
  // One error^2 scatters by 18 % (Gaussian) to 30 % (the tails of g^4): 4 % for 60; curvature and level selection 10 %.
  const double relative = squares / 60 / (24.0 / 6400);
  BOOST_TEST(relative > 1 - 3 * 0.04);
  BOOST_TEST(relative < 1.10 + 3 * 0.04);
}

BOOST_AUTO_TEST_CASE(correlated_blocks_are_dealt_with) {
  const double phi = 0.8, truth = synthetic::variance_of_mean(1024, phi);
  double squares = 0;
  for (std::uint64_t key = 0; key < 60; ++key) {
    const Numbers x = synthetic::autoregressive(key + 900, 1024, phi);
    Numbers sums;
    for (const double v : x) sums.insert(sums.end(), {5 + v, 1.0});
    const Estimate e = jackknife(sums, x.size(), [](Sums s) { return Numbers{std::exp(s[0] / s[1])}; })[0];
    squares += std::pow(e.error / e.mean, 2);  // the relative error of exp(mean) is the error of the mean
  }
  // 1/8 of error^2 may be hidden; one scatters by 30 %, 60 by 4 %.
  const double relative = squares / 60 / truth;
  BOOST_TEST(relative > 1 - 0.125 - 3 * 0.04);
  BOOST_TEST(relative < 1.10 + 3 * 0.04);
}

BOOST_AUTO_TEST_CASE(empty_bins) {
  // Tallies: sum and count of a bin that is always, never, and once occupied.
  Numbers sums;
  for (int b = 0; b < 16; ++b) sums.insert(sums.end(), {1.0 * b, 1, 0, 0, b == 5 ? 3.0 : 0.0, b == 5 ? 1.0 : 0.0});
  const auto result = jackknife(sums, 16, [](Sums s) { return Numbers{s[0] / s[1], s[2] / s[3], s[4] / s[5]}; });
  BOOST_TEST(std::isfinite(result[0].error));
  BOOST_TEST(std::isnan(result[1].mean));
  BOOST_TEST(std::isnan(result[1].error));
  BOOST_TEST(result[2].mean == 3.0);
  BOOST_TEST(std::isnan(result[2].error));
}

BOOST_AUTO_TEST_CASE(few_blocks_give_no_error) {
  const Numbers sums = {1, 2, 3, 4, 5, 6, 7};
  const auto result = jackknife(sums, 7, [](Sums s) { return Numbers{s[0]}; });
  BOOST_TEST(result[0].mean == 28.0);
  BOOST_TEST(std::isnan(result[0].error));
}

BOOST_AUTO_TEST_CASE(refuses_what_it_cannot_use) {
  const Numbers sums(12, 1.0);
  const auto one = [](Sums s) { return Numbers{s[0]}; };
  BOOST_CHECK_THROW(jackknife(sums, 0, one), InputError);
  BOOST_CHECK_THROW(jackknife(sums, 5, one), InputError);
  BOOST_CHECK_THROW(jackknife({}, 3, one), InputError);
  bool first = true;
  BOOST_CHECK_THROW(jackknife(sums, 3,
                              [&](Sums) {
                                const Numbers result(first ? 2u : 1u, 0.0);
                                first = false;
                                return result;
                              }),
                    InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
