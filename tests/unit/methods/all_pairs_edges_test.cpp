// The all-pairs oracle where it must not go on, or only just may: overlaps, contacts without time between them,
// collapse, and what cannot be used.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/methods/all_pairs.hpp"
#include "unit/methods/all_pairs_scene.hpp"

using namespace gpf;
using namespace gpf::test;

BOOST_AUTO_TEST_SUITE(all_pairs_edges)

BOOST_AUTO_TEST_CASE_TEMPLATE(inelastic_collapse_is_an_error_and_tc_avoids_it, Real, Reals) {
  // Three in a line can collapse below e = 7 - 4 sqrt(3) = 0.0718, never above: the middle one bounces ever faster
  // between two that close in.
  Scene s = scene(Geometry::channel, 3);
  s.normal_restitution = 0.05;
  const State start{{{0.5, 0.5}, {0.8, 0.5}, {1.2, 0.5}}, {{1, 0}, {0.6, 0}, {-1.1, 0}}};
  AllPairs<Real> without(s, start);
  BOOST_CHECK_EXCEPTION(without.advance(0.9), PhysicsError, [](auto& error) {
    return mentions(error, {"inelastic collapse", "tc_time"});
  });
  BOOST_TEST(without.time() < 0.3);

  Scene with_tc = s, tamer = s;
  with_tc.tc_time = 1e-4;
  tamer.normal_restitution = 0.1;
  for (const Scene& other : {with_tc, tamer}) {
    AllPairs<Real> oracle(other, start);
    oracle.advance(0.9);  // before they meet again round the period
    BOOST_TEST(oracle.sums().pair_contacts >= 3);
    BOOST_TEST(oracle.sums().pair_contacts < 20);
    const State after = oracle.state();
    BOOST_TEST(after.velocity[0].x < after.velocity[1].x);
    BOOST_TEST(after.velocity[1].x < after.velocity[2].x);
    check_near(after.velocity[0].x + after.velocity[1].x + after.velocity[2].x, 0.5);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_pair_a_few_ulp_inside_contact_collides_now_if_it_approaches, Real, Reals) {
  const Scene s = scene(Geometry::periodic, 2);
  const double gap = s.diameter() * (1 - 20 * std::numeric_limits<double>::epsilon());
  AllPairs<Real> nearing(s, {{{0.5, 0.3}, {0.5 + gap, 0.3}}, {{0.4, 0}, {0.1, 0}}});
  BOOST_TEST(nearing.step().time == 0);
  check_vector(nearing.state().velocity[0], {0.1, 0});

  AllPairs<Real> receding(s, {{{0.5, 0.3}, {0.5 + gap, 0.3}}, {{0.1, 0}, {0.4, 0}}});
  check_near(receding.step().time, (2.1 - 2 * s.diameter()) / 0.3, 1e-13);  // round the period; 1/0.3 of roundings
}

BOOST_AUTO_TEST_CASE_TEMPLATE(deeper_overlaps_are_errors_with_the_disks_and_the_depth, Real, Reals) {
  const Scene s = scene(Geometry::channel, 3);
  const double d = s.diameter();
  const State pair{{{0.5, 0.3}, {1.5, 0.3}, {1.5 + 0.75 * d, 0.3}}, {{}, {}, {}}};
  BOOST_CHECK_EXCEPTION(AllPairs<Real>(s, pair), PhysicsError, [](auto& error) {
    return mentions(error, {"disk 1 overlaps disk 2", "(0.25 d)"});
  });
  const State across{{{0.01, 0.3}, {1.5, 0.3}, {2.1 - 0.02, 0.3}}, {{}, {}, {}}};
  BOOST_CHECK_EXCEPTION(AllPairs<Real>(s, across), PhysicsError,
                        [](auto& error) { return mentions(error, {"disk 0 overlaps disk 2"}); });
  const State sunk{{{0.5, 0.5}, {1.5, 0.375 * d}, {1.0, 0.5}}, {{}, {}, {}}};
  BOOST_CHECK_EXCEPTION(AllPairs<Real>(s, sunk), PhysicsError, [](auto& error) {
    return mentions(error, {"disk 1 overlaps the lower wall", "(0.125 d)"});
  });
  const State raised{{{0.5, 1 - 0.25 * d}, {1.5, 0.5}, {1.0, 0.5}}, {{}, {}, {}}};
  BOOST_CHECK_EXCEPTION(AllPairs<Real>(s, raised), PhysicsError, [](auto& error) {
    return mentions(error, {"disk 0 overlaps the upper wall", "(0.25 d)"});
  });
}

BOOST_AUTO_TEST_CASE(in_single_precision_round_off_is_that_of_single_precision) {
  Scene s = scene(Geometry::channel, 2);
  const double d = s.diameter();
  AllPairs<float> oracle(s, {{{0.5, 0.3}, {0.5 + d * (1 - 1e-6), 0.3}}, {{0.4, 0}, {0.1, 0}}});
  BOOST_TEST(oracle.step().time == 0);  // inside each other by less than a float can tell
  check_vector(oracle.state().velocity[0], {0.1, 0}, 1e-7);
  check_vector(oracle.state().velocity[1], {0.4, 0}, 1e-7);
  BOOST_CHECK_THROW(AllPairs<float>(s, {{{0.5, 0.3}, {0.5 + 0.98 * d, 0.3}}, {{}, {}}}), PhysicsError);
  const State deep{{{0.5, 0.3}, {0.5 + d * (1 - 1e-6), 0.3}}, {{}, {}}};
  BOOST_CHECK_THROW(AllPairs<double>(s, deep), PhysicsError);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(newtons_cradle_passes_the_blow_on_in_one_instant, Real, Reals) {
  Scene s = scene(Geometry::channel, 6);
  const double d = s.diameter();
  State start{{{0.3, 0.5}}, {{0.7, 0}}};
  for (int k = 0; k < 5; ++k) start.position.push_back({0.8 + k * d, 0.5}), start.velocity.push_back({});
  AllPairs<Real> oracle(s, start);
  for (std::int32_t k = 0; k < 5; ++k) {
    const auto event = oracle.step();
    BOOST_TEST(event.a == k);
    BOOST_TEST(event.b == k + 1);
    check_near(event.time, (0.5 - d) / 0.7);
  }
  const State after = oracle.state();
  for (std::size_t k = 0; k < 5; ++k) check_vector(after.velocity[k], {});
  check_vector(after.velocity[5], {0.7, 0});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_inelastic_cradle_is_no_collapse, Real, Reals) {
  // A touching row at e = 0.9 needs several contacts per disk in the instant of the blow, and then lets go.
  Scene s = scene(Geometry::channel, 6);
  s.normal_restitution = 0.9;
  const double d = s.diameter();
  State start{{{0.3, 0.5}}, {{0.7, 0}}};
  for (int k = 0; k < 5; ++k) start.position.push_back({0.8 + k * d, 0.5}), start.velocity.push_back({});
  AllPairs<Real> oracle(s, start);
  oracle.advance((0.5 - d) / 0.7 + 0.1);
  const State after = oracle.state();
  double momentum = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    momentum += after.velocity[k].x;
    if (k > 0) BOOST_TEST(after.velocity[k - 1].x <= after.velocity[k].x);
  }
  check_near(momentum, 0.7);
  check_near(oracle.energy(), 0.7 * 0.7 / 2 - oracle.sums().pair_loss);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_used_is_refused) {
  const Scene good = scene(Geometry::periodic, 1);
  const State start{{{0.5, 0.5}}, {{0.3, 0.1}}};
  BOOST_CHECK_THROW(AllPairs<double>(good, State{}), InputError);
  BOOST_CHECK_THROW(AllPairs<double>(good, (State{{{0.5, 0.5}, {1, 0.5}}, {{}, {}}})), InputError);
  BOOST_CHECK_THROW(AllPairs<double>(good, (State{{{0.5, 0.5}}, {}})), InputError);
  BOOST_CHECK_THROW(AllPairs<double>(good, (State{{{0.5, std::nan("")}}, {{}}})), InputError);
  Scene none = good;
  none.particles = 0;
  BOOST_CHECK_THROW(AllPairs<double>(none, State{}), InputError);
  Scene short_one = good;
  short_one.length_over_width = 2 * good.diameter();
  BOOST_CHECK_THROW(AllPairs<double>(short_one, start), InputError);
  Scene narrow = good;
  narrow.width_over_diameter = 2;
  BOOST_CHECK_THROW(AllPairs<double>(narrow, start), InputError);

  AllPairs<double> alone(good, start);
  alone.advance(2);
  BOOST_CHECK_THROW(alone.advance(1.5), InputError);
  BOOST_CHECK_THROW(alone.advance(std::numeric_limits<double>::infinity()), InputError);
}

BOOST_AUTO_TEST_CASE(a_step_without_a_contact_to_come_is_an_error) {
  const auto expected = [](auto& error) { return mentions(error, {"no contact is to come"}); };
  AllPairs<double> alone(scene(Geometry::periodic, 1), {{{0.5, 0.5}}, {{0.3, 0.1}}});
  BOOST_CHECK_EXCEPTION(alone.step(), PhysicsError, expected);
  AllPairs<double> passing(scene(Geometry::periodic, 2), {{{0.5, 0.3}, {0.5, 0.7}}, {{0.3, 0}, {-0.4, 0}}});
  BOOST_CHECK_EXCEPTION(passing.step(), PhysicsError, expected);
}

BOOST_AUTO_TEST_SUITE_END()
