// Soft disks: a lone contact's restitution and duration, the order of the steps, walls, conservation and budgets.
#include "gpf/methods/soft_disks.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/scene/start.hpp"

using namespace gpf;

namespace {

Scene scene(Geometry geometry, std::int32_t particles, double width = 10) {
  Scene s;
  s.geometry = geometry;
  s.particles = particles;
  s.width_over_diameter = width;
  s.length_over_width = 1.5;
  return s;
}

/// Velocities of two disks after a head-on contact at relative speed 1, of momentum 0.
double restitution_found(double e, int steps) {
  Scene s = scene(Geometry::periodic, 2);
  s.normal_restitution = e;
  // The gap is no whole number of steps.
  SoftDisks soft(s, {0.01, steps}, {{{0.5, 0.5}, {0.61234, 0.5}}, {{0.5, 0}, {-0.5, 0}}});
  soft.advance(0.1);
  const State after = soft.state();
  BOOST_TEST(std::abs(after.velocity[0].x + after.velocity[1].x) < 1e-14);
  return after.velocity[1].x - after.velocity[0].x;
}

/// A gas of `particles` that has been mixed for a while.
State mixed(const Scene& s) { return start_state(s); }

}  // namespace

BOOST_AUTO_TEST_SUITE(soft_disks)

BOOST_AUTO_TEST_CASE(a_lone_contact_has_the_restitution_of_the_scene) {
  for (const double e : {1.0, 0.9, 0.5, 0.2})
    BOOST_TEST(std::abs(restitution_found(e, 2000) - e) < 2e-3, "e " << e << ": " << restitution_found(e, 2000));
}

// Dashpots jump at the ends of a contact: first order. Springs do not: second order.
BOOST_AUTO_TEST_CASE(the_error_of_a_contact_falls_with_the_step) {
  const auto worst = [](double e, int steps) {
    double most = 0;  // over phases of the step at touching, which change with their number
    for (int more = 0; more < 5; ++more) most = std::max(most, std::abs(restitution_found(e, steps + more) - e));
    return most;
  };
  BOOST_TEST(worst(0.8, 400) < worst(0.8, 100) / 3);
  BOOST_TEST(worst(0.8, 100) < 0.02);
  BOOST_TEST(worst(1.0, 400) < worst(1.0, 100) / 10);
  BOOST_TEST(worst(1.0, 100) < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_contact_lasts_as_long_as_it_should) {
  Scene s = scene(Geometry::periodic, 2);
  s.normal_restitution = 0.7;
  SoftDisks soft(s, {0.01, 1000}, {{{0.5, 0.5}, {0.6, 0.5}}, {{0.5, 0}, {-0.5, 0}}});  // they touch
  soft.advance(0.0098);
  State state = soft.state();
  BOOST_TEST(state.position[1].x - state.position[0].x < s.diameter());
  soft.advance(0.0102);
  state = soft.state();
  BOOST_TEST(state.position[1].x - state.position[0].x > s.diameter());
  // The deepest overlap of a spring alone is v/omega; a dashpot makes it less.
  BOOST_TEST(soft.deepest_overlap() * s.diameter() < 0.01 / 3.14159);
  BOOST_TEST(soft.deepest_overlap() * s.diameter() > 0.8 * 0.01 / 3.14159);
}

BOOST_AUTO_TEST_CASE(a_wall_reflects_with_both_restitutions_once) {
  Scene s = scene(Geometry::channel, 1);
  s.wall_normal_restitution = 0.8;
  s.wall_tangential_restitution = {0.25, -0.5};
  for (const double side : {-1.0, 1.0}) {
    SoftDisks soft(s, {0.01, 2000}, {{{0.5, 0.5 + side * 0.4}}, {{1, side}}});
    soft.advance(0.1);
    const State after = soft.state();
    const std::size_t wall = side < 0 ? 0 : 1;
    BOOST_TEST(after.velocity[0].x == s.wall_tangential_restitution[wall]);
    BOOST_TEST(std::abs(after.velocity[0].y + 0.8 * side) < 2e-3);
    const SoftSums& sums = soft.sums();
    BOOST_TEST(sums.wall_tangential[wall] == 1 - s.wall_tangential_restitution[wall]);
    BOOST_TEST(std::abs(sums.wall_normal[wall] - 1.8) < 4e-3);
    const double beta = s.wall_tangential_restitution[wall];
    BOOST_TEST(std::abs(sums.wall_loss[wall] - (0.5 * (1 - 0.64) + 0.5 * (1 - beta * beta))) < 4e-3);
    BOOST_TEST(sums.wall_normal[1 - wall] == 0);
  }
}

BOOST_AUTO_TEST_CASE(an_elastic_gas_keeps_its_energy_to_second_order_and_its_momentum) {
  Scene s = scene(Geometry::periodic, 200, 20);
  s.length_over_width = 200 * 3.14159265358979 / 4 / 400 / 0.4;  // nu .4
  const auto drift = [&](int steps) {
    SoftDisks soft(s, {0.002, steps}, mixed(s));
    const double before = soft.kinetic_energy() + soft.contact_energy();
    double most = 0;
    for (int k = 1; k <= 50; ++k) {
      soft.advance(0.01 * k);
      most = std::max(most, std::abs(soft.kinetic_energy() + soft.contact_energy() - before) / before);
    }
    Vec2 momentum;
    const State state = soft.state();
    for (const Vec2 v : state.velocity) momentum = momentum + v;
    BOOST_TEST(std::abs(momentum.x) + std::abs(momentum.y) < 1e-10);
    return most;
  };
  const double coarse = drift(20), fine = drift(80);
  BOOST_TEST(coarse < 1e-2);
  BOOST_TEST(fine < coarse / 8);
}

BOOST_AUTO_TEST_CASE(the_energy_of_a_channel_balances) {
  Scene s = scene(Geometry::channel, 150, 15);
  s.length_over_width = 150 * 3.14159265358979 / 4 / 225 / 0.3;
  s.normal_restitution = 0.8;
  s.wall_normal_restitution = 0.9;
  s.wall_tangential_restitution = {0.6, -0.3};
  s.gravity = 1;
  const auto imbalance = [&](int steps) {
    SoftDisks soft(s, {0.004, steps}, mixed(s));
    const double before = soft.kinetic_energy();
    soft.advance(2);
    const SoftSums& sums = soft.sums();
    const double loss = sums.pair_loss + sums.wall_loss[0] + sums.wall_loss[1];
    return std::abs(soft.kinetic_energy() + soft.contact_energy() - before + loss - sums.gravity_work) / loss;
  };
  BOOST_TEST(imbalance(40) < 0.02);
  BOOST_TEST(imbalance(400) < 0.002);
}

// No pair is ever deeper in one another than the pairs that are in the list.
BOOST_AUTO_TEST_CASE(cells_miss_no_contact) {
  Scene s = scene(Geometry::periodic, 120, 12);
  s.length_over_width = 120 * 3.14159265358979 / 4 / 144 / 0.6;  // nu .6
  SoftDisks soft(s, {0.002, 40}, mixed(s));
  for (int k = 1; k <= 20; ++k) {
    soft.advance(0.05 * k);
    const State state = soft.state();
    for (std::size_t i = 0; i < state.position.size(); ++i)
      for (std::size_t j = i + 1; j < state.position.size(); ++j) {
        Vec2 r = state.position[j] - state.position[i];
        r.x -= s.length() * std::nearbyint(r.x / s.length());
        r.y -= std::nearbyint(r.y);
        BOOST_REQUIRE(std::sqrt(dot(r, r)) > s.diameter() * (1 - soft.deepest_overlap()) - 1e-12);
      }
  }
  BOOST_TEST(soft.deepest_overlap() > 0);
  BOOST_TEST(soft.deepest_overlap() < 0.1);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_is_refused) {
  Scene s = scene(Geometry::periodic, 2);
  const State start{{{0.5, 0.5}, {0.7, 0.5}}, {{1, 0}, {-1, 0}}};
  BOOST_CHECK_THROW(SoftDisks(s, {0, 50}, start), InputError);
  BOOST_CHECK_THROW(SoftDisks(s, {0.01, 1}, start), InputError);
  BOOST_CHECK_THROW(SoftDisks(s, {0.01, 50}, {{{0.5, 0.5}}, {{1, 0}}}), InputError);
  s.normal_restitution = 0;
  BOOST_CHECK_THROW(SoftDisks(s, {0.01, 50}, start), InputError);
  s.normal_restitution = 0.9;
  SoftDisks soft(s, {0.5, 50}, start);  // as long as the flight: they go through each other
  BOOST_CHECK_THROW(soft.advance(1), PhysicsError);
}

BOOST_AUTO_TEST_SUITE_END()
