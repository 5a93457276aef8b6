// The all-pairs oracle with many disks: balances, symmetries and round-off.
#include <algorithm>
#include <array>
#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "gpf/base/random.hpp"
#include "gpf/methods/all_pairs.hpp"

using namespace gpf;

namespace {

using Reals = boost::mpl::list<double, long double>;

// Loose square lattice with Gaussian velocities of variance `speed`^2; columns x rows disks fill the scene.
State lattice(const Scene& scene, int columns, int rows, double speed) {
  State state;
  const bool channel = scene.geometry == Geometry::channel;
  const double bottom = channel ? scene.diameter() / 2 : 0, height = channel ? 1 - scene.diameter() : 1;
  for (int k = 0; k < columns * rows; ++k) {
    const int column = k % columns, row = k / columns;
    state.position.push_back({scene.length() * (column + 0.5) / columns, bottom + height * (row + 0.5) / rows});
    state.velocity.push_back(speed * gaussian_pair(scene.seed, static_cast<std::uint64_t>(k)));
  }
  return state;
}

Scene channel(std::int32_t particles) {
  Scene s;
  s.geometry = Geometry::channel;
  s.particles = particles;
  s.width_over_diameter = 7.4;
  s.length_over_width = 1.3;
  s.gravity = 0.7;
  s.seed = 41;
  return s;
}

double distance(const State& p, const State& q) {
  double largest = 0;
  for (std::size_t i = 0; i < p.position.size(); ++i) {
    const Vec2 r = p.position[i] - q.position[i], u = p.velocity[i] - q.velocity[i];
    for (const double s : {r.x, r.y, u.x, u.y}) largest = std::max(largest, std::abs(s));
  }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(all_pairs_many)

BOOST_AUTO_TEST_CASE_TEMPLATE(energy_and_momentum_balance_in_a_dissipative_channel, Real, Reals) {
  Scene s = channel(20);
  s.normal_restitution = 0.9;
  s.wall_normal_restitution = 0.8;
  s.wall_tangential_restitution = {0.3, -0.4};
  const State start = lattice(s, 5, 4, 0.9);
  AllPairs<Real> oracle(s, start);
  const double energy = oracle.energy();
  for (int k = 0; k < 10000; ++k) oracle.step();

  const auto& sums = oracle.sums();
  BOOST_TEST(sums.pair_contacts + sums.wall[lower].contacts + sums.wall[upper].contacts == 10000);
  BOOST_TEST(sums.pair_contacts > 1000);
  BOOST_TEST(sums.wall[lower].contacts > 500);
  BOOST_TEST(sums.wall[upper].contacts > 500);
  // 10^4 sums of terms that are rounded to 1.1e-16 of totals of order `work`: 1e-14 of it as a random walk, 1e-12 at
  // worst.
  const double work = oracle.gravity_work(), loss = sums.pair_loss + sums.wall[lower].loss + sums.wall[upper].loss;
  BOOST_TEST(std::abs(oracle.energy() - energy - work + loss) <= 1e-12 * work);
  const Vec2 gained = momentum(oracle.state()) - momentum(start);
  const double weight = 0.7 * 20 * oracle.time();
  const double drag = sums.wall[lower].tangential_impulse + sums.wall[upper].tangential_impulse;
  BOOST_TEST(std::abs(gained.x - weight + drag) <= 1e-12 * weight);
  const double push = sums.wall[lower].normal_impulse - sums.wall[upper].normal_impulse;
  BOOST_TEST(std::abs(gained.y - push) <= 1e-12 * (sums.wall[lower].normal_impulse + sums.wall[upper].normal_impulse));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(elastic_periodic_disks_conserve_energy_and_momentum, Real, Reals) {
  Scene s = channel(30);
  s.geometry = Geometry::periodic;
  s.gravity = 0;
  const State start = lattice(s, 6, 5, 0.9);
  AllPairs<Real> oracle(s, start);
  const double energy = oracle.energy();
  for (int k = 0; k < 10000; ++k) oracle.step();
  // Four velocity components of order one are rounded per contact: 2e-14 as a random walk, 4e-12 at worst.
  BOOST_TEST(std::abs(oracle.energy() / energy - 1) <= 1e-12);
  const Vec2 drift = momentum(oracle.state()) - momentum(start);
  BOOST_TEST(std::abs(drift.x) <= 1e-12);
  BOOST_TEST(std::abs(drift.y) <= 1e-12);
  BOOST_TEST(oracle.sums().pair_loss == 0);
}

BOOST_AUTO_TEST_CASE(no_disk_ever_overlaps_another_or_a_wall) {
  // Seen from outside: after each of 3000 contacts, all distances and their images.
  Scene s = channel(30);
  s.normal_restitution = 0.8;
  s.wall_tangential_restitution = {0.5, 0.5};
  AllPairs<double> oracle(s, lattice(s, 6, 5, 0.9));
  const double d = s.diameter();
  double closest = 1, lowest = 1, highest = 0;
  for (int k = 0; k < 3000; ++k) {
    oracle.step();
    const State now = oracle.state();
    for (std::size_t i = 0; i < now.position.size(); ++i) {
      lowest = std::min(lowest, now.position[i].y);
      highest = std::max(highest, now.position[i].y);
      for (std::size_t j = 0; j < i; ++j) {
        const Vec2 r = now.position[i] - now.position[j];
        for (const double shift : {-s.length(), 0.0, s.length()})
          closest = std::min(closest, std::hypot(r.x + shift, r.y));
      }
    }
  }
  // Positions gather some ulp between prediction and contact (about sqrt(30)); 1e-13 d leaves a factor of 10.
  BOOST_TEST(std::abs(closest / d - 1) <= 1e-13);
  BOOST_TEST(std::abs(lowest - d / 2) <= 1e-13 * d);
  BOOST_TEST(std::abs(highest - 1 + d / 2) <= 1e-13 * d);
}

BOOST_AUTO_TEST_CASE(elastic_motion_runs_back_to_its_start) {
  // Gravity is reversible, smooth walls too, and so is beta = -1, which turns the disk round.
  for (const double beta : {1.0, -1.0}) {
    Scene s = channel(20);
    s.wall_tangential_restitution = {beta, 1};
    const State start = lattice(s, 5, 4, 0.9);
    AllPairs<long double> oracle(s, start);
    std::vector<AllPairsEvent> there, back;
    for (int k = 0; k < 120; ++k) there.push_back(oracle.step());
    const double turn = oracle.time() + 1e-4;  // clear of the last contact
    oracle.advance(turn);
    BOOST_REQUIRE(oracle.sums().pair_contacts + oracle.sums().wall[0].contacts + oracle.sums().wall[1].contacts == 120);
    oracle.reverse();
    for (int k = 0; k < 120; ++k) back.push_back(oracle.step());
    std::reverse(back.begin(), back.end());
    oracle.advance(2 * turn);
    oracle.reverse();

    // Long double rounds to 5.4e-20, and a deviation grows about tenfold in 20 contacts of 20 disks (measured; double
    // shows the same): 10^6 over 120 contacts, times some 100 for the roundings and the unevenness of the growth.
    BOOST_TEST(distance(oracle.state(), start) < 1e-10);
    for (std::size_t k = 0; k < there.size(); ++k) {
      BOOST_TEST(back[k].a == there[k].a);
      BOOST_TEST(back[k].b == there[k].b);
      BOOST_TEST(std::abs(2 * turn - back[k].time - there[k].time) < 1e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(double_follows_long_double_until_round_off_has_grown) {
  Scene s = channel(20);
  s.normal_restitution = 0.9;
  s.wall_tangential_restitution = {0.5, 0.2};
  s.tc_time = 1e-3;
  const State start = lattice(s, 5, 4, 0.9);
  AllPairs<double> coarse(s, start);
  AllPairs<long double> fine(s, start);
  // 1.1e-16 grown tenfold in 20 contacts is 3e-9 after 150; times 100 for the unevenness of the growth.
  for (int k = 0; k < 150; ++k) {
    const auto p = coarse.step(), q = fine.step();
    BOOST_REQUIRE(p.a == q.a);
    BOOST_REQUIRE(p.b == q.b);
    BOOST_REQUIRE(std::abs(p.time - q.time) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(four_times_the_gravity_doubles_velocities_bit_for_bit, Real, Reals) {
  Scene slow = channel(20);
  slow.normal_restitution = 0.85;
  slow.wall_normal_restitution = 0.95;
  slow.wall_tangential_restitution = {0.5, 0.2};
  slow.tc_time = 1e-3;
  Scene fast = slow;
  fast.gravity = 4 * slow.gravity;
  fast.tc_time = slow.tc_time / 2;
  State start = lattice(slow, 5, 4, 0.9);
  AllPairs<Real> a(slow, start);
  for (Vec2& u : start.velocity) u = 2 * u;
  AllPairs<Real> b(fast, start);
  for (int k = 0; k < 1000; ++k) {
    const auto p = a.step(), q = b.step();
    BOOST_REQUIRE((q == AllPairsEvent{p.time / 2, p.a, p.b}));
  }
  BOOST_TEST((a.state().position == b.state().position));
  BOOST_TEST(4 * a.sums().pair_loss == b.sums().pair_loss);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_order_of_the_disks_does_not_matter, Real, Reals) {
  Scene s = channel(20);
  s.normal_restitution = 0.85;
  s.wall_tangential_restitution = {0.5, 0.2};
  s.tc_time = 1e-3;
  State start = lattice(s, 5, 4, 0.9);
  AllPairs<Real> a(s, start);
  std::reverse(start.position.begin(), start.position.end());
  std::reverse(start.velocity.begin(), start.velocity.end());
  AllPairs<Real> b(s, start);
  for (int k = 0; k < 1000; ++k) {
    const auto p = a.step(), q = b.step();
    BOOST_REQUIRE(p.time == q.time);
    const bool same = p.b < 0 ? (q.a == 19 - p.a && q.b == p.b) : (q.a == 19 - p.b && q.b == 19 - p.a);
    BOOST_REQUIRE(same);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(where_advance_stops_does_not_matter_but_for_round_off, Real, Reals) {
  Scene s = channel(20);
  s.normal_restitution = 0.9;
  const State start = lattice(s, 5, 4, 0.9);
  AllPairs<Real> whole(s, start), parts(s, start);
  whole.advance(0.8);
  for (int k = 1; k <= 64; ++k) parts.advance(0.8 * k / 64);
  BOOST_TEST(whole.sums().pair_contacts == parts.sums().pair_contacts);
  BOOST_TEST(whole.sums().pair_contacts > 20);
  // Some 80 contacts: 1e-16 x 10^4, and 100 for the roundings of the extra stops and the unevenness of the growth.
  BOOST_TEST(distance(whole.state(), parts.state()) < 1e-10);
}

BOOST_AUTO_TEST_SUITE_END()
