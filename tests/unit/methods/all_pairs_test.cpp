// The all-pairs oracle, one contact at a time: each expected number is worked out by hand from the thesis' equations.
#include "gpf/methods/all_pairs.hpp"

#include <algorithm>
#include <array>
#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "gpf/base/error.hpp"
#include "unit/methods/all_pairs_scene.hpp"

using namespace gpf;
using namespace gpf::test;

BOOST_AUTO_TEST_SUITE(all_pairs)

BOOST_AUTO_TEST_CASE_TEMPLATE(head_on_pair_follows_eqs_2_3_to_2_6, Real, Reals) {
  Scene s = scene(Geometry::periodic, 2);
  const double e = s.normal_restitution = 0.83, d = s.diameter();
  AllPairs<Real> oracle(s, {{{0.2, 0.41}, {0.9, 0.41}}, {{0.7, 0.13}, {-0.4, 0.13}}});
  const auto event = oracle.step();

  check_near(event.time, (0.7 - d) / 1.1);
  BOOST_TEST(event.a == 0);
  BOOST_TEST(event.b == 1);
  const double impulse = (1 + e) / 2 * 1.1;
  check_vector(oracle.state().velocity[0], {0.7 - impulse, 0.13});
  check_vector(oracle.state().velocity[1], {-0.4 + impulse, 0.13});
  BOOST_TEST(oracle.sums().pair_contacts == 1);
  check_near(oracle.sums().pair_loss, (1 - e * e) * 1.1 * 1.1 / 4);
  check_near(oracle.sums().virial, d * impulse);
  check_near(oracle.energy(), (0.7 * 0.7 + 0.4 * 0.4) / 2 + 0.13 * 0.13 - (1 - e * e) * 1.1 * 1.1 / 4);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(oblique_pair_exchanges_only_normal_momentum, Real, Reals) {
  // Built backwards from the contact: r12 = d (0.8, 0.6) after 0.37, tangent (-0.6, 0.8).
  Scene s = scene(Geometry::periodic, 2);
  const double e = s.normal_restitution = 0.6, d = s.diameter(), t = 0.37;
  const Vec2 u1{0.5, 0.3}, u2{-0.35, 0.2}, r1{1.0, 0.5}, n{0.8, 0.6};
  const Vec2 r2 = r1 + d * n;
  AllPairs<Real> oracle(s, {{r1 - t * u1, r2 - t * u2}, {u1, u2}});
  const auto event = oracle.step();

  check_near(event.time, t);
  const double approach = dot(u1 - u2, n), impulse = (1 + e) / 2 * approach;
  BOOST_TEST(approach > 0);
  const State after = oracle.state();
  check_vector(after.position[0], r1);
  check_vector(after.position[1], r2);
  check_vector(after.velocity[0], u1 - impulse * n);
  check_vector(after.velocity[1], u2 + impulse * n);
  check_near(dot(after.velocity[1] - after.velocity[0], n), e * approach);         // eq. 2.3
  check_near(cross(after.velocity[1] - after.velocity[0], n), cross(u2 - u1, n));  // smooth
  check_near(oracle.sums().pair_loss, (1 - e * e) * approach * approach / 4);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(gravity_does_not_enter_pair_contact_times, Real, Reals) {
  Scene s = scene(Geometry::channel, 2);
  const State start{{{0.2, 0.41}, {0.9, 0.41}}, {{0.7, 0}, {-0.4, 0}}};
  AllPairs<Real> without(s, start);
  s.gravity = 1.7;
  AllPairs<Real> with(s, start);
  check_near(with.step().time, without.step().time);
  check_vector(with.state().velocity[0], without.state().velocity[0] + Vec2{1.7 * with.time(), 0});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(walls_follow_eq_2_9_with_a_beta_of_their_own, Real, Reals) {
  Scene s = scene(Geometry::channel, 1);
  s.gravity = 0.7;
  s.wall_tangential_restitution = {0.3, -0.4};
  const double e = s.wall_normal_restitution = 0.9, r = s.diameter() / 2;
  AllPairs<Real> oracle(s, {{{1.1, 0.45}}, {{0.2, -0.6}}});

  const double t1 = (0.45 - r) / 0.6, ux1 = 0.2 + 0.7 * t1;
  const auto first = oracle.step();
  check_near(first.time, t1);
  BOOST_TEST(first.a == 0);
  BOOST_TEST(first.b == AllPairsEvent::lower_wall);
  check_vector(oracle.state().velocity[0], {0.3 * ux1, e * 0.6});
  check_near(oracle.state().position[0].y, r);

  const double t2 = (1 - 2 * r) / (e * 0.6), ux2 = 0.3 * ux1 + 0.7 * t2;
  const auto second = oracle.step();
  check_near(second.time, t1 + t2);
  BOOST_TEST(second.b == AllPairsEvent::upper_wall);
  check_vector(oracle.state().velocity[0], {-0.4 * ux2, -e * e * 0.6});

  const auto& [below, above] = oracle.sums().wall;
  BOOST_TEST(below.contacts == 1);
  BOOST_TEST(above.contacts == 1);
  check_near(below.normal_impulse, (1 + e) * 0.6);
  check_near(above.normal_impulse, (1 + e) * e * 0.6);
  check_near(below.tangential_impulse, 0.7 * ux1);
  check_near(above.tangential_impulse, 1.4 * ux2);
  check_near(below.loss, (1 - 0.09) * ux1 * ux1 / 2 + (1 - e * e) * 0.36 / 2);
  check_near(above.loss, (1 - 0.16) * ux2 * ux2 / 2 + (1 - e * e) * e * e * 0.36 / 2);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(free_fall_is_exact_over_many_periods, Real, Reals) {
  Scene s = scene(Geometry::channel, 1);
  s.gravity = 0.7;
  AllPairs<Real> oracle(s, {{{1.1, 0.45}}, {{-3.1, 0}}});
  const double t = 23.5, fallen = -3.1 * t + 0.7 * t * t / 2;  // 120.4, 57 periods
  oracle.advance(t);
  // Numbers near 200 are rounded to 1.4e-14 each; a few of them.
  check_near(oracle.state().position[0].x, std::fmod(1.1 + fallen, 2.1), 1e-13);
  check_vector(oracle.state().velocity[0], {-3.1 + 0.7 * t, 0});
  check_near(oracle.gravity_work(), 0.7 * fallen, 1e-13);
  BOOST_TEST(oracle.time() == t);
}

BOOST_AUTO_TEST_CASE(one_disk_reaches_the_collisionless_limit) {
  // <u_x> = g t1 (1 + beta)/(2 (1 - beta)), t1 = (W - d)/|u_y|: the fixed point of u -> beta (u + g t1).
  for (const double beta : {0.9, 0.1, 0.0, -0.5}) {
    Scene s = scene(Geometry::channel, 1);
    s.gravity = 0.7;
    s.wall_tangential_restitution = {beta, beta};
    AllPairs<double> oracle(s, {{{1.1, 0.45}}, {{0.2, 0.6}}});
    for (int k = 0; k < 400; ++k) oracle.step();  // 0.9^400 = 5e-19 of the start is left
    const double t = oracle.time(), work = oracle.gravity_work();
    for (int k = 0; k < 50; ++k) oracle.step();
    const double mean = (oracle.gravity_work() - work) / (0.7 * (oracle.time() - t));
    const double t1 = (1 - s.diameter()) / 0.6;
    // 450 flights of about 10 periods, each rounded to 2e-16 of a period, over a displacement of 50 flights.
    check_near(mean / (0.7 * t1 * (1 + beta) / (2 * (1 - beta))), 1, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(contacts_reach_across_the_periodic_boundary, Real, Reals) {
  Scene s = scene(Geometry::periodic, 2);
  const double d = s.diameter(), t = 0.29;
  struct Case {
    Vec2 r1, n;
  };
  // Along x, along y, over the corner; the third normal is oblique.
  for (const auto& [r1, n] : {Case{{2.07, 0.4}, {1, 0}}, Case{{0.7, 0.97}, {0, 1}}, Case{{2.08, 0.96}, {0.6, 0.8}}}) {
    const Vec2 u1 = 0.31 * n, u2 = -0.17 * n;
    Vec2 r2 = r1 + d * n + (-t) * u2;
    r2.x = std::fmod(r2.x, 2.1), r2.y = std::fmod(r2.y, 1);
    AllPairs<Real> oracle(s, {{r1 - t * u1, r2}, {u1, u2}});
    check_near(oracle.step().time, t, 1e-14);  // differences near 0 of numbers near 2, divided by 0.48
    check_vector(oracle.state().velocity[0], -0.17 * n, 1e-14);
    check_vector(oracle.state().velocity[1], 0.31 * n, 1e-14);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_pair_may_meet_through_a_far_image, Real, Reals) {
  // Disk 2 runs past disk 1 three times, each time 0.0436 closer in y, and hits it at r12 = d (-0.6, 0.8) after 1.3:
  // one lap earlier the distance in y was 0.8 d + 0.0436 = 1.12 d, so it passed.
  for (const Geometry geometry : {Geometry::channel, Geometry::periodic}) {
    const Scene s = scene(geometry, 2);
    const double d = s.diameter(), t = 1.3;
    const Vec2 u1{0.2, 0}, u2{5.5, -0.11}, r1{1.0, 0.4};
    const Vec2 r2 = r1 + Vec2{-0.6 * d, 0.8 * d};
    AllPairs<Real> oracle(s, {{r1 - t * u1, r2 - t * u2}, {u1, u2}});
    const auto event = oracle.step();
    check_near(event.time, t, 1e-14);  // numbers near 7 are rounded to 9e-16
    BOOST_TEST(event.b == 1);
    const double impulse = dot(u1 - u2, {-0.6, 0.8});
    check_vector(oracle.state().velocity[0], u1 - impulse * Vec2{-0.6, 0.8}, 1e-13);  // normal off by 7e-15/d
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(tc_rule_looks_at_either_partners_last_contact, Real, Reals) {
  // Disk 0 leaves the lower wall at t = 0.2 and meets disk 1, at rest above it, after another 0.25.
  Scene s = scene(Geometry::channel, 2);
  const double d = s.diameter();
  s.wall_tangential_restitution = {0.5, 0.5};
  const double e = s.normal_restitution = 0.6;
  s.wall_normal_restitution = 1;
  const State start{{{0.96, d / 2 + 0.2}, {1, 1.5 * d + 0.25}}, {{0.4, -1}, {0.2, 0}}};  // the wall makes 0.4 0.2
  for (const double tc : {0.0, 0.24, 0.26}) {
    s.tc_time = tc;
    AllPairs<Real> oracle(s, start);
    check_near(oracle.step().time, 0.2);
    check_near(oracle.step().time, 0.45);
    const double used = tc > 0.25 ? 1 : e;
    check_vector(oracle.state().velocity[0], {0.2, (1 - used) / 2});
    check_vector(oracle.state().velocity[1], {0.2, (1 + used) / 2});
    check_near(oracle.sums().pair_loss, (1 - used * used) / 4);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(tc_rule_makes_walls_elastic_but_keeps_beta, Real, Reals) {
  // Disk 0 hits disk 1 at t = 0.1 (first contact: inelastic); disk 1 hits the upper wall 0.2/0.8 = 0.25 later.
  Scene s = scene(Geometry::channel, 2);
  const double d = s.diameter(), top = 1 - d / 2;
  s.wall_tangential_restitution = {1, 0.5};
  s.normal_restitution = 0.6;
  const double e = s.wall_normal_restitution = 0.7;
  const State start{{{1, top - 0.2 - d - 0.1}, {1, top - 0.2}}, {{0.4, 1}, {0.4, 0}}};
  for (const double tc : {0.24, 0.26}) {
    s.tc_time = tc;
    AllPairs<Real> oracle(s, start);
    check_near(oracle.step().time, 0.1);
    check_near(oracle.sums().pair_loss, (1 - 0.36) / 4);
    BOOST_TEST(oracle.step().b == AllPairsEvent::upper_wall);
    const double used = tc > 0.25 ? 1 : e;
    check_vector(oracle.state().velocity[1], {0.2, -0.8 * used}, 1e-14);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(ties_are_all_executed_lowest_disk_first, Real, Reals) {
  // Two copies of one collision, half a width apart, with coordinates that shift exactly in binary.
  const Scene s = scene(Geometry::periodic, 4);
  AllPairs<Real> oracle(
      s, {{{1.25, 0.75}, {0.5, 0.25}, {0.5, 0.75}, {1.25, 0.25}}, {{-0.5, 0}, {0.25, 0}, {0.25, 0}, {-0.5, 0}}});
  const auto first = oracle.step(), second = oracle.step();
  BOOST_TEST(first.time == second.time);
  BOOST_TEST((first == AllPairsEvent{first.time, 0, 2}));
  BOOST_TEST((second == AllPairsEvent{first.time, 1, 3}));
  check_vector(oracle.state().velocity[0], {0.25, 0});
  check_vector(oracle.state().velocity[1], {-0.5, 0});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(advance_executes_what_falls_on_its_end, Real, Reals) {
  Scene s = scene(Geometry::channel, 1);
  s.width_over_diameter = 8;  // with powers of two the contact at 0.25/0.5 = 0.5 is exact
  AllPairs<Real> oracle(s, {{{1, 0.0625 + 0.25}}, {{0.25, -0.5}}});
  oracle.advance(0.4375);
  BOOST_TEST(oracle.sums().wall[lower].contacts == 0);
  check_vector(oracle.state().position[0], {1.109375, 0.09375}, 0);
  oracle.advance(0.5);
  BOOST_TEST(oracle.sums().wall[lower].contacts == 1);
  BOOST_TEST(oracle.time() == 0.5);
  check_vector(oracle.state().velocity[0], {0.25, 0.5}, 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(start_positions_are_wrapped_into_the_period, Real, Reals) {
  const Scene s = scene(Geometry::periodic, 2);
  const AllPairs<Real> oracle(s, {{{-0.5, -0.25}, {4.4, 3.5}}, {{}, {}}});
  check_vector(oracle.state().position[0], {1.6, 0.75});
  check_vector(oracle.state().position[1], {0.2, 0.5});
  BOOST_TEST(oracle.gravity_work() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
