// Collision rules against eqs. 2.3-2.5 and 2.9, and the TC model.
#include "gpf/event/rules.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "gpf/base/random.hpp"

using namespace gpf;

namespace {

constexpr double long_ago = std::numeric_limits<double>::infinity();

Scene scene_with(double normal, double tc_time = 0) {
  Scene scene;
  scene.particles = 2;
  scene.width_over_diameter = 7.4;
  scene.length_over_width = 1.3;
  scene.normal_restitution = normal;
  scene.wall_normal_restitution = 0.7;
  scene.wall_tangential_restitution = {0.9, -0.4};
  scene.tc_time = tc_time;
  return scene;
}

/// A contact of two disks: any normal, and a velocity of approach.
struct Meeting {
  Vec2 r, v1, v2;
};

Meeting meeting(std::uint64_t k, double d) {
  const Vec2 direction = gaussian_pair(3, k);
  Meeting m{(d / std::sqrt(dot(direction, direction))) * direction, gaussian_pair(4, k), gaussian_pair(5, k)};
  if (dot(m.v1 - m.v2, m.r) < 0) std::swap(m.v1, m.v2);
  return m;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rules)

BOOST_AUTO_TEST_CASE(pair_by_hand) {
  // Along x, disk 1 catches up with disk 2 at relative speed 2: J = (1 + e)/2 x 2 = 1.8, loss = (1 - e^2)/4 x 4 = .36.
  const SmoothDisks pair(scene_with(0.8));
  const PairOutcome outcome = pair({0.25, 0}, {2, 5}, long_ago);
  BOOST_TEST(outcome.impulse.x == 1.8, boost::test_tools::tolerance(4e-16));
  BOOST_TEST(outcome.impulse.y == 0);
  BOOST_TEST(outcome.energy_loss == 0.36, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(pair_restitution_and_loss_at_any_angle) {
  // Numbers of order 1 are rounded some ten times: 20 epsilon = 4e-15.
  constexpr double tolerance = 4e-15;
  for (const double e : {1.0, 0.99, 0.8, 0.3, 0.0}) {
    const SmoothDisks pair(scene_with(e));
    for (std::uint64_t k = 0; k < 500; ++k) {
      const Meeting m = meeting(k, 1 / 7.4);
      const PairOutcome outcome = pair(m.r, m.v1 - m.v2, long_ago);
      const Vec2 w1 = m.v1 - outcome.impulse, w2 = m.v2 + outcome.impulse;
      const Vec2 n = (1 / std::sqrt(dot(m.r, m.r))) * m.r;
      const Vec2 before = m.v1 - m.v2, after = w1 - w2;
      BOOST_TEST(std::abs(dot(after, n) + e * dot(before, n)) < tolerance * 8);
      BOOST_TEST(std::abs(cross(after, n) - cross(before, n)) < tolerance * 8);
      const double energy = (dot(m.v1, m.v1) + dot(m.v2, m.v2)) / 2, left = (dot(w1, w1) + dot(w2, w2)) / 2;
      BOOST_TEST(std::abs(energy - left - outcome.energy_loss) < tolerance * 8 * energy);
      BOOST_TEST(outcome.energy_loss >= 0);
      if (e == 1) BOOST_TEST(outcome.energy_loss == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(pair_that_is_a_little_off_contact_keeps_its_restitution) {
  // Round-off moves |r| by some ulp; with a normal r/|r| even 1 % changes nothing but the direction's length.
  const SmoothDisks pair(scene_with(1));
  for (std::uint64_t k = 0; k < 100; ++k) {
    const Meeting m = meeting(k, 1.01 / 7.4);
    const PairOutcome outcome = pair(m.r, m.v1 - m.v2, long_ago);
    const Vec2 w1 = m.v1 - outcome.impulse, w2 = m.v2 + outcome.impulse;
    const double energy = dot(m.v1, m.v1) + dot(m.v2, m.v2);
    BOOST_TEST(std::abs(dot(w1, w1) + dot(w2, w2) - energy) < 4e-15 * 8 * energy);
  }
}

BOOST_AUTO_TEST_CASE(pair_named_the_other_way_round_gets_the_opposite_impulse_bit_for_bit) {
  const SmoothDisks pair(scene_with(0.87));
  for (std::uint64_t k = 0; k < 500; ++k) {
    const Meeting m = meeting(k, 1 / 7.4);
    const PairOutcome p = pair(m.r, m.v1 - m.v2, long_ago), q = pair(-m.r, m.v2 - m.v1, long_ago);
    BOOST_TEST((p.impulse == -q.impulse));
    BOOST_TEST(p.energy_loss == q.energy_loss);
  }
}

BOOST_AUTO_TEST_CASE(tc_model_makes_early_contacts_elastic) {
  constexpr double tc = 0.125;
  const SmoothDisks pair(scene_with(0.5, tc));
  const FlatWalls wall(scene_with(0.5, tc));
  for (const double quiet : {0.0, 0.1, tc}) {  // "more than tc_time" dissipates: equal is still elastic
    BOOST_TEST(pair({0.25, 0}, {2, 0}, quiet).impulse.x == 2);
    BOOST_TEST(pair({0.25, 0}, {2, 0}, quiet).energy_loss == 0);
    BOOST_TEST(wall({1, -2}, lower, quiet).y == 2);
  }
  for (const double quiet : {std::nextafter(tc, 1.0), 1.0, long_ago}) {
    BOOST_TEST(pair({0.25, 0}, {2, 0}, quiet).impulse.x == 1.5);
    BOOST_TEST(pair({0.25, 0}, {2, 0}, quiet).energy_loss == 0.75);
    BOOST_TEST(wall({1, -2}, lower, quiet).y == 1.4, boost::test_tools::tolerance(4e-16));
  }
}

BOOST_AUTO_TEST_CASE(tc_time_zero_switches_the_model_off) {
  // Even for a second contact at the same instant, as in a row of touching disks.
  const SmoothDisks pair(scene_with(0.5, 0));
  const FlatWalls wall(scene_with(0.5, 0));
  for (const double quiet : {0.0, 5e-324, 1.0, long_ago}) {
    BOOST_TEST(pair({0.25, 0}, {2, 0}, quiet).impulse.x == 1.5);
    BOOST_TEST(wall({1, -2}, lower, quiet).y == 1.4, boost::test_tools::tolerance(4e-16));
  }
}

BOOST_AUTO_TEST_CASE(walls_by_hand) {
  const FlatWalls wall(scene_with(1));
  for (const double quiet : {long_ago, 0.5}) {
    BOOST_TEST((wall({3, -2}, lower, quiet) == Vec2{0.9 * 3, 0.7 * 2}));
    BOOST_TEST((wall({3, 2}, upper, quiet) == Vec2{-0.4 * 3, -0.7 * 2}));
  }
}

BOOST_AUTO_TEST_CASE(tangential_wall_restitution_acts_under_the_tc_model_too) {
  const FlatWalls wall(scene_with(1, 0.5));
  BOOST_TEST((wall({3, -2}, lower, 0.25) == Vec2{0.9 * 3, 2}));
  BOOST_TEST((wall({3, 2}, upper, 0.25) == Vec2{-0.4 * 3, -2}));
}

BOOST_AUTO_TEST_SUITE_END()
