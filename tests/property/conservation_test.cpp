// What contacts and flights must keep: energy, momentum, distance; balances over long runs, and the way back.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

/// Compensated, so that sums over disks add nothing to the errors that are looked for.
double sum(const std::vector<Vec2>& values, double (*term)(Vec2)) {
  double total = 0, lost = 0;
  for (const Vec2 v : values) {
    const double corrected = term(v) - lost, next = total + corrected;
    lost = (next - total) - corrected;
    total = next;
  }
  return total;
}
double energy(const State& s) {
  return sum(s.velocity, [](Vec2 v) { return dot(v, v) / 2; });
}
Vec2 total_momentum(const State& s) {
  return {sum(s.velocity, [](Vec2 v) { return v.x; }), sum(s.velocity, [](Vec2 v) { return v.y; })};
}

/// Keeps the books of energy and momentum of a channel from what observers are told.
struct Books {
  long double pair_loss = 0, wall_loss = 0;
  long double wall_momentum_x = 0;       ///< received from walls
  long double wall_momentum_x_time = 0;  ///< sum of the same times the time at which it was received
  long double energy_from_velocities = 0;
  void on_pair(const PairContact& c) {
    pair_loss += c.energy_loss;
    const Vec2 v1 = c.velocity_1 + c.impulse, v2 = c.velocity_2 - c.impulse;  // before
    energy_from_velocities +=
        (dot(v1, v1) + dot(v2, v2) - dot(c.velocity_1, c.velocity_1) - dot(c.velocity_2, c.velocity_2)) / 2;
  }
  void on_wall(const WallContact& c) {
    wall_loss += (dot(c.velocity_before, c.velocity_before) - dot(c.velocity_after, c.velocity_after)) / 2;
    const double received = c.velocity_after.x - c.velocity_before.x;
    wall_momentum_x += received;
    wall_momentum_x_time += received * c.time;
  }
};

template <class Observer>
void advance_contacts(Engine<>& engine, std::uint64_t contacts, Observer& observer) {
  while (engine.counts().pair_contacts < contacts) engine.advance(engine.epoch_end(), observer);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(conservation)

BOOST_AUTO_TEST_CASE(energy_and_momentum_over_many_elastic_contacts) {
  // Each contact rounds four velocity components of order one to 1.1e-16. As a random walk of n contacts of N = 1000
  // disks the relative drift of the energy is 1.1e-16 x 2 sqrt(n)/N = 7e-16 for n = 10^7; a bias as large as the
  // rounding itself would give 2e-12. Momentum: 1.1e-16 sqrt(4 n) = 7e-13 of about sqrt(N) = 30.
  const Scene scene = test::gas(1000, 0.3);
  Engine<> engine(scene, start_state(scene));
  const State start = engine.state();
  NoObserver nobody;
  advance_contacts(engine, GPF_LONG_RUN, nobody);
  const State end = engine.state();
  const double drift = std::abs(energy(end) / energy(start) - 1);
  const Vec2 gained = total_momentum(end) - total_momentum(start);
  BOOST_TEST_MESSAGE(engine.counts().pair_contacts << " contacts: energy drift " << drift << ", momentum drift "
                                                   << std::hypot(gained.x, gained.y) << ", deepest overlap "
                                                   << engine.deepest_overlap() / scene.diameter() << " d");
  BOOST_TEST(drift < 1e-12);
  BOOST_TEST(std::abs(gained.x) < 1e-11);
  BOOST_TEST(std::abs(gained.y) < 1e-11);
  BOOST_TEST(engine.deepest_overlap() < 1e-12 * scene.diameter());
}

BOOST_AUTO_TEST_CASE(inelastic_disks_keep_momentum_and_lose_what_the_rule_says) {
  const Scene scene = test::gas(300, 0.3, 0.8);
  Engine<> engine(scene, start_state(scene));
  const State start = engine.state();
  Books books;
  advance_contacts(engine, 30000, books);
  const State end = engine.state();
  // 3e4 contacts, a random walk of roundings of 1.1e-16 of numbers of order one; factor 10.
  BOOST_TEST(std::abs(energy(start) - energy(end) - books.pair_loss) < 10 * 2e-14 * energy(start));
  BOOST_TEST(std::abs(books.energy_from_velocities - books.pair_loss) < 10 * 2e-14 * energy(start));
  BOOST_TEST(books.pair_loss > 0.9 * energy(start));  // it has cooled
  BOOST_TEST(std::abs(total_momentum(end).x - total_momentum(start).x) < 10 * 4e-14);
  BOOST_TEST(std::abs(total_momentum(end).y - total_momentum(start).y) < 10 * 4e-14);
}

BOOST_AUTO_TEST_CASE(in_a_smooth_elastic_channel_energy_is_the_work_of_gravity) {
  // Neither pairs nor walls change the momentum along x: P = P0 + N g t, so the work is g (P0 t + N g t^2/2).
  const Scene scene = test::smooth_channel(200, 0.3, 11);
  Engine<> engine(scene, start_state(scene));
  const State start = engine.state();
  double last = -1;
  for (const double time : {1.0, 3.0, 10.0, 30.0}) {
    engine.advance(time);
    const State now = engine.state();
    const double weight = 200 * scene.gravity;
    const double work = scene.gravity * (total_momentum(start).x * time + weight * time * time / 2);
    // Walls return u_x through the falling frame, which rounds it to 1.1e-16 of the frame's velocity g t, on each of n
    // wall contacts; energies of order N (g t)^2/2 then walk by (g t)^2 1.1e-16 sqrt(n), n some 10^4 at the end.
    BOOST_TEST(std::abs(energy(now) - energy(start) - work) < 1e-13 * (energy(start) + work));
    BOOST_TEST(std::abs(total_momentum(now).x - total_momentum(start).x - weight * time) < 1e-13 * weight * (time + 1));
    last = energy(now);
  }
  BOOST_TEST(last > 100 * energy(start));  // nothing holds it
  BOOST_TEST(engine.counts().wall_contacts > 5000u);
}

BOOST_AUTO_TEST_CASE(in_a_rough_inelastic_channel_the_books_balance) {
  // Momentum along x changes at walls only, by D_k at time t_k: P(t) = P0 + N g t + sum D_k, and its time integral,
  // times g, is the work of gravity. Energy: start + work = end + losses in pairs + losses at walls.
  for (const double beta : {0.9, 0.1, -0.5}) {
    Scene scene = test::channel(200, 0.4, 11, 0.9);
    scene.wall_tangential_restitution = {beta, 0.7};
    Engine<> engine(scene, start_state(scene));
    const State start = engine.state();
    Books books;
    const long double time = 24.7, gravity = scene.gravity,
                      weight = 200 * gravity;  // sums of 10^5 would be rounded to 1e-11
    engine.advance(static_cast<double>(time), books);
    const State end = engine.state();
    const long double received_times_lapse = books.wall_momentum_x * time - books.wall_momentum_x_time;
    const long double work =
        scene.gravity * (total_momentum(start).x * time + weight * time * time / 2 + received_times_lapse);
    const long double losses = books.pair_loss + books.wall_loss;
    // The frame's velocity, up to 8, is rounded to 9e-16 at each of some 50 epochs, for all disks alike: a walk of the
    // momentum by 200 x 9e-16 x 7 = 1e-12 and of the energy by 8 times that. A factor of 10.
    BOOST_TEST(engine.counts().pair_contacts > 30000u);
    BOOST_TEST(std::abs(energy(start) + work - energy(end) - losses) < 10 * 1e-11);
    BOOST_TEST(std::abs(total_momentum(start).x + weight * time + books.wall_momentum_x - total_momentum(end).x) <
               10 * 1e-12);
    BOOST_TEST(losses > 0.5 * work);
  }
}

BOOST_AUTO_TEST_CASE(disks_never_overlap_by_more_than_a_millionth_of_a_millionth) {
  // The channel of the thesis from dilute to dense, elastic to strongly inelastic; seen from inside at each contact and
  // from outside at the end.
  for (const double area_fraction : {0.015, 0.3, 0.56, 0.85})
    for (const double e : {0.99, 0.8}) {
      Scene scene = test::channel(900, area_fraction, 31, e);
      scene.gravity = 1;
      scene.wall_normal_restitution = 1;
      scene.tc_time = 1e-4 / scene.reference_collision_rate();
      Engine<> engine(scene, start_state(scene));
      NoObserver nobody;
      advance_contacts(engine, 100000, nobody);
      BOOST_TEST(engine.deepest_overlap() < 1e-12 * scene.diameter());
      const State now = engine.state();
      double closest = 1, lowest = 1, highest = 0;
      for (std::size_t i = 0; i < now.position.size(); ++i) {
        lowest = std::min(lowest, now.position[i].y);
        highest = std::max(highest, now.position[i].y);
        for (std::size_t j = 0; j < i; ++j) {
          const Vec2 r = now.position[i] - now.position[j];
          if (std::abs(r.y) > scene.diameter()) continue;
          closest = std::min(closest, std::hypot(std::remainder(r.x, scene.length()), r.y));
        }
      }
      const double d = scene.diameter();
      BOOST_TEST(closest > d * (1 - 1e-12));
      BOOST_TEST(lowest > d / 2 - 1e-12 * d);
      BOOST_TEST(highest < 1 - d / 2 + 1e-12 * d);
    }
}

BOOST_AUTO_TEST_CASE(elastic_motion_runs_back_to_its_start) {
  // Roundings of 1e-15 grow on the way there and on the way back: over half as many contacts again as the mean for the
  // disks with the most; a factor of 100 for oblique contacts.
  for (const double area_fraction : {0.05, 0.3, 0.65})
    for (const double contacts : {50.0, 100.0, 200.0}) {
      const Scene scene = test::gas(100, area_fraction);
      const State start = start_state(scene);
      Engine<> there(scene, start);
      double time = 0;
      while (static_cast<double>(there.counts().pair_contacts) < contacts)
        there.advance(time += 0.01 / scene.reference_collision_rate());
      State turned = there.state();
      for (Vec2& v : turned.velocity) v = -v;
      Engine<> back(scene, turned);
      back.advance(time);
      BOOST_TEST(back.counts().pair_contacts == there.counts().pair_contacts);
      const State end = back.state();
      double deviation = 0;
      for (std::size_t i = 0; i < 100; ++i) {
        const Vec2 r = end.position[i] - start.position[i], v = end.velocity[i] + start.velocity[i];
        deviation = std::max({deviation, std::abs(std::remainder(r.x, scene.length())),
                              std::abs(std::remainder(r.y, 1)), std::abs(v.x), std::abs(v.y)});
      }
      BOOST_TEST_MESSAGE("area fraction " << area_fraction << ", " << contacts << " contacts: deviation " << deviation);
      BOOST_TEST(deviation < 1e-13 * test::growth(scene, 1.5 * 2 * contacts));
      BOOST_TEST(deviation > 0);
    }
}

BOOST_AUTO_TEST_SUITE_END()
