// The engine on few disks, where the answer is known: flights, walls, pairs, and the edge cases of contacts.
#include "gpf/event/engine.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "gpf/scene/start.hpp"
#include "support/contact_log.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

// Coordinates are kept to 2^-52 of a power of two above the longest side (here 2: 4.4e-16) and times to 2^-53; twenty
// such roundings of numbers of order one stay below this.
constexpr double tolerance = 2e-14;

/// d = 1/8, L = 1.3 (periodic, no gravity) unless changed.
Scene scene_of(std::int32_t particles, Geometry geometry = Geometry::periodic) {
  Scene scene;
  scene.geometry = geometry;
  scene.particles = particles;
  scene.width_over_diameter = 8;
  scene.length_over_width = 1.3;
  return scene;
}

struct Log {
  std::vector<PairContact> pairs;
  std::vector<WallContact> walls;
  void on_pair(const PairContact& c) { pairs.push_back(c); }
  void on_wall(const WallContact& c) { walls.push_back(c); }
};

double folded(double x, double period) { return x - period * std::floor(x / period); }

/// Distance of two coordinates on a circle.
double apart(double a, double b, double period) { return std::abs(std::remainder(a - b, period)); }

}  // namespace

BOOST_AUTO_TEST_SUITE(engine)

BOOST_AUTO_TEST_CASE(a_lone_disk_flies_straight_round_the_box) {
  const Scene scene = scene_of(1);
  Engine<> engine(scene, State{{{0.25, 0.75}}, {{0.7, -0.3}}});
  engine.advance(1000.25);
  const State now = engine.state();
  // 500 epochs and 840 laps, each of which rounds the position by up to 2.2e-16 and the time, below 2, by 1.1e-16.
  BOOST_TEST(apart(now.position[0].x, 0.25 + 0.7 * 1000.25, 1.3) < 3e-13);
  BOOST_TEST(apart(now.position[0].y, 0.75 - 0.3 * 1000.25, 1) < 3e-13);
  BOOST_TEST((now.velocity[0] == Vec2{0.7, -0.3}));
  BOOST_TEST(engine.counts().pair_contacts + engine.counts().wall_contacts == 0u);
  BOOST_TEST((engine.trace_hash() == TraceHash()));
  BOOST_TEST(engine.time() == 1000.25);
}

BOOST_AUTO_TEST_CASE(a_lone_disk_falls_along_the_channel_between_smooth_walls) {
  Scene scene = scene_of(1, Geometry::channel);
  scene.gravity = 1.7;
  Engine<> engine(scene, State{{{0.25, 0.5}}, {{-0.4, 0.9}}});
  const double time = 11.3;
  engine.advance(time);
  // y is a triangle wave between 1/16 and 15/16; x an accelerated motion; nothing else.
  const double phase = folded(0.9 * time + 0.5 - 0.0625, 1.75), y = 0.0625 + std::min(phase, 1.75 - phase);
  const State now = engine.state();
  BOOST_TEST(std::abs(now.position[0].y - y) < 10 * tolerance);
  BOOST_TEST(apart(now.position[0].x, 0.25 - 0.4 * time + 0.85 * time * time, 1.3) < 1e-12);  // after 108 units of fall
  BOOST_TEST(std::abs(now.velocity[0].x - (-0.4 + 1.7 * time)) < 1e-13);
  BOOST_TEST(std::abs(now.velocity[0].y) == 0.9);
  BOOST_TEST(engine.counts().wall_contacts == 12u);  // 1 + (0.9 x 11.3 - 0.4375)/0.875 = 12.1
}

BOOST_AUTO_TEST_CASE(walls_slow_a_falling_disk_each_by_its_own_rule) {
  for (const double beta : {-0.5, 0.0, 1.0}) {
    Scene scene = scene_of(1, Geometry::channel);
    scene.gravity = 1.7;
    scene.wall_normal_restitution = 0.5;
    scene.wall_tangential_restitution = {beta, 0.25};
    Engine<> engine(scene, State{{{0.25, 0.5625}}, {{-0.4, -1}}});
    Log log;
    engine.advance(2.5, log);
    BOOST_REQUIRE(log.walls.size() == 2u);
    const WallContact &first = log.walls[0], &second = log.walls[1];
    // Half a width to the lower wall at speed 1; then 7/8 to the upper one at speed 1/2.
    BOOST_TEST((first.wall == lower && second.wall == upper));
    BOOST_TEST(first.time == 0.5);
    BOOST_TEST(std::abs(second.time - 2.25) < tolerance);
    BOOST_TEST(first.position.y == 1.0 / 16);
    BOOST_TEST(second.position.y == 15.0 / 16);
    const double arrives = -0.4 + 1.7 * 0.5, leaves = beta * arrives, arrives_again = leaves + 1.7 * 1.75;
    BOOST_TEST(std::abs(first.velocity_before.x - arrives) < tolerance);
    BOOST_TEST(first.velocity_after.x == beta * first.velocity_before.x);
    BOOST_TEST(first.velocity_after.y == 0.5);
    BOOST_TEST(std::abs(second.velocity_before.x - arrives_again) < tolerance);
    BOOST_TEST(second.velocity_after.x == 0.25 * second.velocity_before.x);
    BOOST_TEST(second.velocity_after.y == -0.25);
    const double x = 0.25 - 0.4 * 0.5 + 0.85 * 0.25 + leaves * 1.75 + 0.85 * 1.75 * 1.75;
    BOOST_TEST(apart(second.position.x, x, 1.3) < tolerance);
  }
}

BOOST_AUTO_TEST_CASE(a_wall_without_rebound_keeps_a_disk_sliding) {
  Scene scene = scene_of(1, Geometry::channel);
  scene.gravity = 1.7;
  scene.wall_normal_restitution = 0;
  Engine<> engine(scene, State{{{0.25, 0.5625}}, {{0, -1}}});
  engine.advance(5);
  BOOST_TEST(engine.counts().wall_contacts == 1u);
  BOOST_TEST(engine.state().position[0].y == 1.0 / 16);
  BOOST_TEST(std::abs(engine.state().velocity[0].x - 8.5) < tolerance);
}

BOOST_AUTO_TEST_CASE(a_head_on_pair_by_hand) {
  // 5/8 apart, contact at 1/8, closing at 2: t = 1/4. With e = 3/4 velocities 1.5, -.5 become -.25, 1.25.
  Scene scene = scene_of(2);
  scene.normal_restitution = 0.75;
  Engine<> engine(scene, State{{{0.25, 0.5}, {0.875, 0.5}}, {{1.5, 0}, {-0.5, 0}}});
  Log log;
  engine.advance(0.25, log);  // contacts at the very end of the interval are in it
  BOOST_REQUIRE(log.pairs.size() == 1u);
  const PairContact c = log.pairs[0];
  BOOST_TEST(c.time == 0.25);
  BOOST_TEST((c.first == 0 && c.second == 1));
  BOOST_TEST((c.r_12 == Vec2{0.125, 0}));
  BOOST_TEST((c.position == Vec2{0.625, 0.5}));
  BOOST_TEST((c.impulse == Vec2{1.75, 0}));
  BOOST_TEST((c.velocity_1 == Vec2{-0.25, 0}));
  BOOST_TEST((c.velocity_2 == Vec2{1.25, 0}));
  BOOST_TEST(c.energy_loss == (1 - 0.5625) / 4 * 4);
  BOOST_TEST((engine.state().velocity == std::vector<Vec2>{{-0.25, 0}, {1.25, 0}}));
}

BOOST_AUTO_TEST_CASE(pairs_meet_across_the_period_and_the_corner) {
  for (const Vec2 n : {Vec2{1, 0}, Vec2{0, 1}, Vec2{0.6, 0.8}, Vec2{-0.6, 0.8}}) {
    // Apart by 1/4 along n around the corner of the box, each closing at 1/2: contact after 1/8.
    const auto place = [&](double s) { return Vec2{folded(s * n.x, 1.3), folded(s * n.y, 1)}; };
    Engine<> engine(scene_of(2), State{{place(-0.125), place(0.125)}, {0.5 * n, -0.5 * n}});
    Log log;
    engine.advance(1, log);
    BOOST_REQUIRE(log.pairs.size() >= 1u);
    BOOST_TEST(std::abs(log.pairs[0].time - 0.125) < tolerance);
    BOOST_TEST(std::abs(log.pairs[0].r_12.x - 0.125 * n.x) < tolerance);
    BOOST_TEST(std::abs(log.pairs[0].r_12.y - 0.125 * n.y) < tolerance);
  }
}

BOOST_AUTO_TEST_CASE(a_grazing_pass_is_no_contact_and_a_hair_closer_is_one) {
  const double d = 0.125;
  const auto contacts = [&](double offset) {
    Engine<> engine(scene_of(2), State{{{0.25, 0.5}, {1, 0.5 + offset}}, {{1, 0}, {-1, 0}}});
    engine.advance(0.6);  // once past each other
    return engine.counts().pair_contacts;
  };
  BOOST_TEST(contacts(d) == 0u);
  BOOST_TEST(contacts(-d) == 0u);
  BOOST_TEST(contacts(d - 0x1p-46) == 1u);
  BOOST_TEST(contacts(0x1p-46 - d) == 1u);
  BOOST_TEST(contacts(d + 0x1p-46) == 0u);
}

BOOST_AUTO_TEST_CASE(a_near_grazing_pair_keeps_its_energy) {
  // The normal is then almost at right angles to the velocity, and round-off decides about the rest: no energy from it.
  for (int k = 30; k <= 50; ++k) {
    Engine<> engine(scene_of(2), State{{{0.25, 0.5}, {1, 0.5 + 0.125 - std::ldexp(1.0, -k)}}, {{1, 0}, {-1, 0}}});
    engine.advance(0.6);
    double energy = 0;
    for (const Vec2 v : engine.state().velocity) energy += dot(v, v) / 2;
    BOOST_TEST(std::abs(energy - 1) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(disks_that_touch_at_the_start) {
  const auto run = [](Vec2 v) {
    Engine<> engine(scene_of(2), State{{{0.5, 0.5}, {0.625, 0.5}}, {{0, 0}, v}});
    Log log;
    engine.advance(0.1, log);
    return log.pairs;
  };
  const auto approaching = run({-1, 0});
  BOOST_REQUIRE(approaching.size() == 1u);
  BOOST_TEST(approaching[0].time == 0);
  BOOST_TEST(run({1, 0}).empty());  // parting
  BOOST_TEST(run({0, 0}).empty());  // at rest
  BOOST_TEST(run({0, 1}).empty());  // rolling past
  BOOST_TEST(run({-0.01, 1}).size() == 1u);
}

BOOST_AUTO_TEST_CASE(disks_at_rest_stay_and_disks_that_fall_together_never_meet) {
  const Scene still = test::gas(50, 0.5);
  State start = start_state(still);
  std::fill(start.velocity.begin(), start.velocity.end(), Vec2{});
  Engine<> rest(still, start);
  rest.advance(10);
  BOOST_TEST((rest.counts().examined() == 0u));
  for (std::size_t i = 0; i < 50; ++i) {
    const Vec2 moved = rest.state().position[i] - start.position[i];
    BOOST_TEST(std::abs(moved.x) < 4.5e-16);  // a quantum, 2^-51
    BOOST_TEST(std::abs(moved.y) < 4.5e-16);
  }
  const Scene falling = test::channel(50, 0.5, 7);
  start = start_state(falling);
  std::fill(start.velocity.begin(), start.velocity.end(), Vec2{});
  Engine<> fall(falling, start);
  fall.advance(3);
  BOOST_TEST(fall.counts().pair_contacts + fall.counts().wall_contacts == 0u);
  for (const Vec2 v : fall.state().velocity) BOOST_TEST(std::abs(v.x - 5.1) < tolerance);
}

BOOST_AUTO_TEST_CASE(a_cradle_hands_the_motion_on) {
  // Five disks in a row that touch; the first comes from the left and the last leaves with its velocity. With e < 1 the
  // k-th disk leaves the k-th contact with ((1 + e)/2)^k of it: those contacts share one instant and all dissipate.
  for (const double e : {1.0, 0.5}) {
    Scene scene = scene_of(5);
    scene.normal_restitution = e;
    State start;
    for (int i = 0; i < 5; ++i) start.position.push_back({0.5 + 0.125 * i, 0.5}), start.velocity.push_back({0, 0});
    start.position[0] = {0.25, 0.5}, start.velocity[0] = {1, 0};
    Engine<> engine(scene, start);
    Log log;
    engine.advance(0.3, log);
    const auto at_contact = std::count_if(log.pairs.begin(), log.pairs.end(), [](auto& c) { return c.time == 0.25; });
    BOOST_TEST(at_contact == (e == 1 ? 4 : log.pairs.size()));
    BOOST_TEST(at_contact >= 4);
    const double factor = (1 + e) / 2;
    BOOST_TEST(std::abs(engine.state().velocity[4].x - std::pow(factor, 4)) < tolerance);
    BOOST_TEST(engine.counts().pair_contacts == log.pairs.size());
    if (e == 1)
      for (int i = 0; i < 4; ++i) BOOST_TEST(engine.state().velocity[static_cast<std::size_t>(i)].x == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_tc_model_counts_from_the_last_contact_of_either_partner) {
  // One disk hits the middle one, which hits the third a time `wait` later: elastic if that is up to tc_time. Numbered
  // from the left and from the right, so that the partner with the contact behind it has the lower and the higher
  // number.
  for (const auto& [wait, elastic] : {std::pair{0.0078125, true}, std::pair{0.03125, false}})
    for (const bool reversed : {false, true}) {
      Scene scene = scene_of(3);
      scene.normal_restitution = 0.5;
      scene.tc_time = 0.015625;
      const double gap = 0.75 * wait;  // the middle disk leaves with (1 + e)/2 = 3/4
      State start{{{0.25, 0.5}, {0.5, 0.5}, {0.625 + gap, 0.5}}, {{1, 0}, {0, 0}, {0, 0}}};
      if (reversed) {
        std::reverse(start.position.begin(), start.position.end());
        std::reverse(start.velocity.begin(), start.velocity.end());
      }
      Engine<> engine(scene, start);
      Log log;
      engine.advance(0.125 + 1.01 * wait, log);
      BOOST_REQUIRE(log.pairs.size() == 2u);
      BOOST_TEST(std::abs(log.pairs[1].time - log.pairs[0].time - wait) < tolerance);
      BOOST_TEST(log.pairs[0].energy_loss > 0);
      BOOST_TEST((log.pairs[1].energy_loss == 0) == elastic);
    }
}

BOOST_AUTO_TEST_CASE(disks_cannot_pass_each_other_in_a_channel_narrower_than_two) {
  // W/d = 1.5: centres differ by d/2 at most across. The order along x is kept, round the period, for ever.
  Scene scene = test::channel(12, 0.35, 1.5);
  Engine<> engine(scene, start_state(scene));
  const auto order = [&] {
    const State now = engine.state();
    std::vector<std::size_t> ids(12);
    for (std::size_t i = 0; i < 12; ++i) ids[i] = i;
    std::sort(ids.begin(), ids.end(), [&](auto a, auto b) { return now.position[a].x < now.position[b].x; });
    std::rotate(ids.begin(), std::find(ids.begin(), ids.end(), 0u), ids.end());
    return ids;
  };
  const auto before = order();
  engine.advance(40);
  BOOST_TEST(engine.counts().pair_contacts > 500u);
  BOOST_TEST((order() == before));
  BOOST_TEST(engine.deepest_overlap() < 1e-12 * scene.diameter());
}

BOOST_AUTO_TEST_CASE(a_period_of_four_diameters_is_long_enough) {
  // Three disks abreast fill 3/4 of the period: each has both others as neighbours on both sides.
  Scene scene = test::channel(9, 0.55, 3.2);
  scene.length_over_width = 4 * scene.diameter();
  Engine<> engine(scene, start_state(scene));
  engine.advance(40);
  BOOST_TEST(engine.counts().pair_contacts > 2000u);
  const State now = engine.state();
  double closest = 1;
  for (std::size_t i = 0; i < now.position.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 r = now.position[i] - now.position[j];
      closest = std::min(closest, std::hypot(std::remainder(r.x, scene.length()), r.y));
    }
  BOOST_TEST(closest > scene.diameter() * (1 - 1e-12));
}

BOOST_AUTO_TEST_CASE(a_fast_disk_laps_the_box_many_times_before_its_contact) {
  // Disk 0 goes round at 300 per unit of time and climbs slowly until it meets disk 1, at rest. In long double: the lap
  // in which it first comes within d, and the time of contact in it.
  const long double vx = 300.7, vy = 0.9, d = 0.125, dx = 0.35, dy = 0.4;
  long double expected = -1;
  for (int lap = 0; expected < 0 && lap < 1000; ++lap) {
    const long double rx = dx + lap * static_cast<long double>(1.3), u2 = vx * vx + vy * vy;
    const long double b = rx * vx + dy * vy, c = rx * rx + dy * dy - d * d, disc = b * b - u2 * c;
    if (disc > 0) expected = (b - std::sqrt(disc)) / u2;
  }
  BOOST_REQUIRE(expected > 0.2L);  // some fifty laps
  std::vector<double> times;
  for (const double disks_per_cell : {0.0, 0.02, 0.1, 5.0}) {
    Engine<> engine(scene_of(2), State{{{0.25, 0.25}, {0.6, 0.65}}, {{300.7, 0.9}, {0, 0}}}, disks_per_cell);
    test::ContactLog log;
    engine.advance(0.5, log);
    BOOST_REQUIRE(log.contacts.size() >= 1u);
    times.push_back(log.contacts[0].time);
  }
  // Each lap rounds the position to 4.4e-16 and its time, below 1/2, to 5.6e-17 x 300: 50 x 2e-14. The contact is
  // oblique: its time carries a factor of some ten of that, over the speed.
  BOOST_TEST(std::abs(times[0] - static_cast<double>(expected)) < 50 * 2e-14 * 10 / 300);
  for (const double time : times) BOOST_TEST(time == times[0]);
}

BOOST_AUTO_TEST_CASE(positions_are_given_inside_the_box) {
  // A hair below zero would fold to L itself.
  Engine<> engine(scene_of(1), State{{{0, 0}}, {{-1e-18, -1e-19}}});
  engine.advance(1);
  const Vec2 r = engine.state().position[0];
  BOOST_TEST((r.x >= 0 && r.x < 1.3));
  BOOST_TEST((r.y >= 0 && r.y < 1));
}

BOOST_AUTO_TEST_CASE(the_deepest_overlap_is_a_length) {
  const double depth = 1e-14;  // of the 1.8e-14 that count as round-off here
  Engine<> engine(scene_of(2), State{{{0.5, 0.5}, {0.625 - depth, 0.5}}, {{0, 0}, {-1, 0}}});
  engine.advance(0.1);
  BOOST_TEST(engine.counts().pair_contacts == 1u);
  BOOST_TEST(std::abs(engine.deepest_overlap() - depth) < 4.5e-16);
}

BOOST_AUTO_TEST_CASE(advancing_to_the_past_does_nothing) {
  Engine<> engine(scene_of(2), State{{{0.25, 0.5}, {0.875, 0.5}}, {{1.5, 0}, {-0.5, 0}}});
  engine.advance(0.7);
  const State now = engine.state();
  engine.advance(0.2);
  BOOST_TEST(engine.time() == 0.7);
  BOOST_TEST((engine.state().position == now.position));
}

BOOST_AUTO_TEST_CASE(counts_are_those_of_the_observer_and_times_never_decrease) {
  const Scene scene = test::channel(100, 0.4, 9.3);
  Engine<> engine(scene, start_state(scene));
  test::ContactLog log;
  engine.advance(3, log);
  const auto walls = std::count_if(log.contacts.begin(), log.contacts.end(), [](auto& c) { return c.b < 0; });
  BOOST_TEST(engine.counts().wall_contacts == static_cast<std::uint64_t>(walls));
  BOOST_TEST(engine.counts().pair_contacts + engine.counts().wall_contacts == log.contacts.size());
  BOOST_TEST(log.contacts.size() > 2000u);
  BOOST_TEST(
      std::is_sorted(log.contacts.begin(), log.contacts.end(), [](auto& a, auto& b) { return a.time < b.time; }));
}

BOOST_AUTO_TEST_SUITE_END()
