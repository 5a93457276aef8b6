// Random numbers: Philox's known answers, the portable logarithm, and Gaussian pairs against their distribution.
#include "gpf/base/random.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

namespace {

using namespace gpf;
using Words = std::array<std::uint32_t, 4>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr std::uint64_t seed = 20240917;

std::vector<double> gaussians(std::size_t pairs) {
  std::vector<double> values;
  for (std::uint64_t k = 0; k < pairs; ++k) {
    const Vec2 g = gaussian_pair(seed, k);
    values.push_back(g.x);
    values.push_back(g.y);
  }
  return values;
}

double mean_power(const std::vector<double>& values, int power) {
  double sum = 0;
  for (const double v : values) sum += std::pow(v, power);
  return sum / static_cast<double>(values.size());
}

BOOST_AUTO_TEST_SUITE(random_numbers)

BOOST_AUTO_TEST_CASE(philox_gives_the_known_answers) {
  // kat_vectors of Random123 (Salmon et al.), philox4x32 with 10 rounds. Our arguments hold the counter as (index,
  // stream), low words first.
  const auto same = [](const Words& a, const Words& b) {
    BOOST_CHECK_EQUAL_COLLECTIONS(a.begin(), a.end(), b.begin(), b.end());
  };
  const std::uint64_t ones = ~std::uint64_t{0};
  same(random_words(0, 0, 0), {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  same(random_words(ones, ones, ones), {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  same(random_words(0x299f31d0a4093822u, 0x0370734413198a2eu, 0x85a308d3243f6a88u),
       {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

BOOST_AUTO_TEST_CASE(replica_seeds_are_all_different) {
  // 40,000 seeds: two alike by chance once in 2^64/(8 10^8), 23 thousand million programs.
  std::set<std::uint64_t> seeds;
  for (std::uint64_t scene = 0; scene < 200; ++scene) {
    for (std::uint64_t replica = 0; replica < 200; ++replica) seeds.insert(replica_seed(scene, replica));
  }
  BOOST_TEST(seeds.size() == 40000u);
}

BOOST_AUTO_TEST_CASE(portable_log_is_the_logarithm) {
  // Worst where exponent ln 2 = .693 and 2 s sum = -.347 nearly cancel: the rounding of the former counts 1 epsilon of
  // the result, the four of the latter (m + 1, quotient, sum, product) 2, the last addition 1/2; the sum is below 4.
  double worst = 0;
  for (int k = -2000; k <= 2000; ++k) {
    const double x = std::exp(0.3541 * k);  // 1e-308 ... 1e307
    if (!std::isnormal(x)) continue;
    worst = std::max(worst, std::abs(portable_log(x) - std::log(x)) / std::max(std::abs(std::log(x)), 1e-300));
  }
  for (double x = 0.5; x < 2; x += 0.00013) {
    const double exact = std::log(x);
    worst = std::max(worst, std::abs(portable_log(x) - exact) / std::max(std::abs(exact), epsilon));
  }
  BOOST_TEST(worst < 4 * epsilon);
}

BOOST_AUTO_TEST_CASE(portable_log_at_exact_points) {
  BOOST_TEST(portable_log(1) == 0.0);
  BOOST_TEST(std::abs(portable_log(2) - std::numbers::ln2) <= epsilon * std::numbers::ln2);
  BOOST_TEST(std::abs(portable_log(std::numbers::e) - 1) <= 2 * epsilon);
  // One ulp above and below 1, where log(1 + x) = x - x^2/2.
  BOOST_TEST(std::abs(portable_log(1 + epsilon) / epsilon - 1) < 2 * epsilon);
  BOOST_TEST(std::abs(portable_log(1 - epsilon / 2) / (-epsilon / 2) - 1) < 2 * epsilon);
  BOOST_TEST(std::isfinite(portable_log(std::numeric_limits<double>::denorm_min())));
}

BOOST_AUTO_TEST_CASE(gaussian_moments) {
  // n = 400,000 values; each moment within 4.5 of its standard deviations sqrt((<g^2p> - <g^p>^2)/n), that is
  // sqrt(1, 2, 15, 96)/sqrt(n). False alarm for another seed: 4 x 6.8e-6; with this seed it holds or it does not.
  const std::vector<double> g = gaussians(200000);
  const double bound = 4.5 / std::sqrt(static_cast<double>(g.size()));
  BOOST_TEST(std::abs(mean_power(g, 1)) < bound);
  BOOST_TEST(std::abs(mean_power(g, 2) - 1) < bound * std::sqrt(2.0));
  BOOST_TEST(std::abs(mean_power(g, 3)) < bound * std::sqrt(15.0));
  BOOST_TEST(std::abs(mean_power(g, 4) - 3) < bound * std::sqrt(96.0));
}

BOOST_AUTO_TEST_CASE(gaussian_distribution) {
  // Kolmogorov-Smirnov: sqrt(n) D > 2.65 has probability 2 exp(-2 2.65^2) = 1.6e-6.
  std::vector<double> g = gaussians(200000);
  std::sort(g.begin(), g.end());
  const double n = static_cast<double>(g.size());
  double distance = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double p = std::erfc(-g[k] / std::numbers::sqrt2) / 2, below = static_cast<double>(k) / n;
    distance = std::max({distance, p - below, below + 1 / n - p});
  }
  BOOST_TEST(std::sqrt(n) * distance < 2.65);
}

BOOST_AUTO_TEST_CASE(gaussian_numbers_are_independent) {
  // Correlations of the two of a pair, of neighbouring indices, of neighbouring keys, and of squares (which the
  // rejection in the polar method could couple): each within 4.5 standard deviations, 1/sqrt(n), or 2/sqrt(n) for
  // squares.
  const std::size_t n = 100000;
  double pair = 0, squares = 0, index = 0, key = 0;
  for (std::uint64_t k = 0; k < n; ++k) {
    const Vec2 g = gaussian_pair(seed, k);
    pair += g.x * g.y;
    squares += (g.x * g.x - 1) * (g.y * g.y - 1);
    index += g.x * gaussian_pair(seed, k + 1).x;
    key += g.x * gaussian_pair(seed + 1, k).x;
  }
  const double bound = 4.5 * std::sqrt(static_cast<double>(n));
  BOOST_TEST(std::abs(pair) < bound);
  BOOST_TEST(std::abs(squares) < 2 * bound);
  BOOST_TEST(std::abs(index) < bound);
  BOOST_TEST(std::abs(key) < bound);
}

BOOST_AUTO_TEST_CASE(gaussian_pairs_are_a_function_of_key_and_index) {
  BOOST_CHECK(gaussian_pair(5, 7) == gaussian_pair(5, 7));
  BOOST_CHECK(!(gaussian_pair(5, 7) == gaussian_pair(5, 8)));
  BOOST_CHECK(!(gaussian_pair(5, 7) == gaussian_pair(6, 7)));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
