#include "verify/estimators/pair_functions.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/sampled_record.hpp"

namespace gpf::test {
namespace {

const std::string channel = long_channel(900, 41);
const Scene scene = made_record(channel, [](const SetTally&) {}).scene;

/// States of random points with independent velocities of mean {3, 1}.
std::vector<State> independent_states(std::size_t count) {
  std::vector<State> states;
  for (std::size_t s = 0; s < count; ++s)
    states.push_back(random_state(scene, s + 1, [s](Vec2, std::size_t disk) {
      const Vec2 v = gaussian_pair(s + 77, disk);
      return Vec2{3 + v.x, 1 + v.y};
    }));
  return states;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(pair_functions)

/// Independent pairs of points: the counted share has the error (p (1 - p)/n)^(1/2); 4.5 of them fail once in 10^5.
BOOST_AUTO_TEST_CASE(a_strip_holds_random_pairs_as_the_formula_says) {
  const Strip strip{1.7, 40};
  constexpr int pairs = 200000;
  for (const double r : {0.4, 1.6, 1.8, 3.0, 11.0, 20.0}) {
    int near = 0;
    for (std::uint64_t k = 0; k < pairs; ++k) {
      const double x = std::remainder(strip.length * (uniform(1, k) - uniform(2, k)), strip.length);
      const double y = strip.height * (uniform(3, k) - uniform(4, k));
      near += x * x + y * y < r * r;
    }
    const double p = strip.within(r);
    BOOST_TEST_CONTEXT("r " << r) BOOST_TEST(std::abs(near - p * pairs) < 4.5 * std::sqrt(p * (1 - p) * pairs));
  }
}

/// ... and its derivative is the integral over the arc that lies inside.
BOOST_AUTO_TEST_CASE(the_formula_is_the_integral_over_the_arc_inside) {
  const Strip strip{1.7, 40};
  for (const double r : {0.5, 1.69, 1.71, 6.0}) {
    double integral = 0;
    constexpr int steps = 200000;
    for (int k = 0; k < steps; ++k)
      integral += std::max(strip.height - r * std::sin((k + 0.5) * std::numbers::pi / (2 * steps)), 0.0);
    integral *= std::numbers::pi / (2 * steps);
    const double h = 1e-4, slope = (strip.within(r + h) - strip.within(r - h)) / (2 * h);
    BOOST_TEST(slope == 4 * r / (strip.height * strip.height * strip.length) * integral,
               boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(random_points_have_g_of_one_at_the_wall_too) {
  const Record record = sampled_record(channel, independent_states(40));
  for (const int bin : {0, 4, 8}) {
    const std::vector<double> g = PairFunctions(record, {bin, 17 - bin}).pair_correlation();
    double low = 0, high = 0;
    for (std::size_t k = 0; k < 60; ++k) low += g[k] / 60;       // up to 3 d: about 12000 pairs
    for (std::size_t k = 120; k < 220; ++k) high += g[k] / 100;  // 6 to 11 d
    BOOST_TEST(std::abs(low - 1) < 0.06);
    BOOST_TEST(std::abs(high - 1) < 0.03);
  }
}

BOOST_AUTO_TEST_CASE(beyond_half_the_length_there_is_no_g) {
  const std::string text = long_channel(450, 20);
  const Scene half = made_record(text, [](const SetTally&) {}).scene;
  const Record record = sampled_record(text, {random_state(half, 1, [](Vec2, std::size_t) { return Vec2{1, 0}; })});
  const std::vector<double> g = PairFunctions(record, {8}).pair_correlation();
  BOOST_TEST(std::isfinite(g[199]));
  BOOST_TEST(std::isnan(g[200]));
}

BOOST_AUTO_TEST_CASE(independent_velocities_have_only_the_correlation_that_is_forced) {
  const Record record = sampled_record(channel, independent_states(40));
  const PairFunctions pairs(record, {7, 10});
  BOOST_TEST(pairs.forced_offset() == -1 / 50.6, boost::test_tools::tolerance(0.05));  // 900/17.4 disks, less one
  BOOST_TEST(std::abs(pairs.mean_correlation(Component::xx, 0, 12) - pairs.forced_offset()) < 0.01);
  BOOST_TEST(std::abs(pairs.mean_correlation(Component::xx, 0, 12, Mean::long_time)) < 0.01);
  BOOST_TEST(std::abs(pairs.mean_correlation(Component::xy, 0, 12)) < 0.01);
  BOOST_TEST(std::abs(pairs.one_disk_xy()) < 0.05);
}

/// A bin that moves to and fro as one body: about the instantaneous mean nothing is left of it.
BOOST_AUTO_TEST_CASE(the_long_time_mean_keeps_the_motion_of_the_bin) {
  std::vector<State> states;
  for (const double push : {2.0, -2.0})
    states.push_back(random_state(scene, 9, [&](Vec2, std::size_t disk) {
      const Vec2 v = gaussian_pair(4, disk);
      return Vec2{5 + push + v.x, push};
    }));
  const PairFunctions pairs(sampled_record(channel, states), {8});
  BOOST_TEST(pairs.mean_correlation(Component::xx, 0, 12, Mean::long_time) == 0.8,
             boost::test_tools::tolerance(0.1));  // 4/(4 + 1)
  BOOST_TEST(std::abs(pairs.mean_correlation(Component::xx, 0, 12)) < 0.1);
  BOOST_TEST(pairs.mean_correlation(Component::yy, 0, 12) == 1, boost::test_tools::tolerance(1e-12));
}

/// c_y = u_x in the lower half and -u_x in the upper: the mirror image of each other.
BOOST_AUTO_TEST_CASE(bins_of_the_upper_half_are_seen_in_a_mirror) {
  const Record record = sampled_record(channel, {random_state(scene, 2, [](Vec2 place, std::size_t) {
                                         const double u = std::cos(2 * std::numbers::pi * place.x);
                                         return Vec2{u, place.y < 0.5 ? u : -u};
                                       })});
  for (const std::vector<int>& bins : {std::vector{3}, std::vector{14}, std::vector{3, 14}}) {
    const PairFunctions pairs(record, bins);
    BOOST_TEST(pairs.mean_correlation(Component::xy, 0, 2) > 0.7);
    BOOST_TEST(pairs.one_disk_xy() > 0.9);
  }
}

BOOST_AUTO_TEST_CASE(a_record_without_correlations_is_refused) {
  BOOST_CHECK_THROW(PairFunctions(made_record(channel, [](const SetTally&) {}), {8}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
