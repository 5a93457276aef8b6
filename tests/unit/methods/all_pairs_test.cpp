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

using namespace gpf;

namespace {

using Reals = boost::mpl::list<double, long double>;

// A handful of roundings of numbers of order one, each 1.1e-16; contact times divide by relative speeds near 1.
constexpr double close = 4e-15;

Scene scene(Geometry geometry, std::int32_t particles) {
  Scene s;
  s.geometry = geometry;
  s.particles = particles;
  s.width_over_diameter = 7.4;
  s.length_over_width = 2.1;
  return s;
}

void check_vector(Vec2 found, Vec2 expected, double tolerance = close) {
  BOOST_TEST(std::abs(found.x - expected.x) <= tolerance, "x is " << found.x << ", expected " << expected.x);
  BOOST_TEST(std::abs(found.y - expected.y) <= tolerance, "y is " << found.y << ", expected " << expected.y);
}

void check_near(double found, double expected, double tolerance = close) {
  BOOST_TEST(std::abs(found - expected) <= tolerance, found << " differs from " << expected);
}

bool mentions(const std::exception& error, std::initializer_list<const char*> words) {
  const std::string text = error.what();
  return std::all_of(words.begin(), words.end(), [&](auto* word) { return text.find(word) != std::string::npos; });
}

}  // namespace

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
