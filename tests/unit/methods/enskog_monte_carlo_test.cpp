// Enskog's equation by Monte Carlo: its collision rate and cooling, what it conserves, its walls, its waves and its
// range.
#include "gpf/methods/enskog_monte_carlo.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/base/random.hpp"
#include "gpf/theory/contact_value.hpp"
#include "gpf/theory/enskog.hpp"

using namespace gpf;

namespace {

Scene gas(double nu, double e) {
  Scene s;
  s.geometry = Geometry::periodic;
  s.particles = 400;
  s.width_over_diameter = 20;
  s.length_over_width = std::numbers::pi * 400 / (4 * nu * 400);
  s.normal_restitution = e;
  return s;
}

Scene channel(double nu, double e, double beta) {
  Scene s = gas(nu, e);
  s.geometry = Geometry::channel;
  s.particles = 900;
  s.width_over_diameter = 31;
  s.length_over_width = std::numbers::pi * 900 / (4 * nu * 31 * 31);
  s.wall_tangential_restitution = {beta, beta};
  s.gravity = 1;
  return s;
}

double temperature(const EnskogMonteCarlo& mc) {
  double sum = 0;
  for (const Vec2 v : mc.velocities()) sum += dot(v, v) / 2;
  return sum / static_cast<double>(mc.particles());
}

/// A narrow channel, two widths long.
Scene narrow() {
  Scene s = channel(0.2, 0.95, 0.3);
  s.particles = 51;
  s.width_over_diameter = 10;
  s.length_over_width = std::numbers::pi * 51 / (4 * 0.2 * 10 * 10);
  return s;
}

/// Averages over time and the length of a channel, in equal rows across the room of the centres.
class RowAverages {
 public:
  RowAverages(const Scene& scene, int rows) : scene_(scene), rows_(static_cast<std::size_t>(rows)) {}

  void add(const EnskogMonteCarlo& mc) {
    const State state = mc.state();
    const double d = scene_.diameter(), count = static_cast<double>(rows_.size());
    const double disks = scene_.particles / static_cast<double>(mc.particles());
    for (std::size_t i = 0; i < state.position.size(); ++i) {
      const double row = std::floor((state.position[i].y - d / 2) / (1 - d) * count);
      Row& r = rows_[static_cast<std::size_t>(std::clamp(row, 0.0, count - 1))];
      ++r.count;
      r.velocity = r.velocity + state.velocity[i];
      r.squares += dot(state.velocity[i], state.velocity[i]);
    }
    nu_of_one_ = std::numbers::pi * d * d / 4 * disks * count / (scene_.length() * (1 - d) * ++samples_);
  }

  [[nodiscard]] double mean_velocity(std::size_t row) const { return mean(row).x; }
  [[nodiscard]] double temperature(std::size_t row) const {
    return (rows_[row].squares / rows_[row].count - dot(mean(row), mean(row))) / 2;
  }
  [[nodiscard]] double area_fraction(std::size_t row) const { return nu_of_one_ * rows_[row].count; }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }

 private:
  struct Row {
    double count = 0, squares = 0;
    Vec2 velocity;
  };
  [[nodiscard]] Vec2 mean(std::size_t row) const { return (1 / rows_[row].count) * rows_[row].velocity; }

  Scene scene_;
  std::vector<Row> rows_;
  double samples_ = 0, nu_of_one_ = 0;
};

constexpr double turn = 2 * std::numbers::pi;

/// Particles anywhere across a periodic gas, with density 1 + a cos(2 pi x/L) and temperature 1 + b cos(2 pi x/L).
State wave(std::size_t count, double length, double a, double b) {
  State state;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    double x = part;
    for (int k = 0; k < 50; ++k) x = part - a / turn * std::sin(turn * x);
    state.position.push_back({length * x, random_words(5, 9, i)[0] * 0x1p-32});
    state.velocity.push_back(std::sqrt(1 + b * std::cos(turn * x)) * gaussian_pair(3, i));
  }
  return state;
}

/// Mean of exp(2 pi i x/L).
Vec2 first_mode(const State& state, double length) {
  Vec2 sum;
  for (const Vec2 r : state.position) sum = sum + Vec2{std::cos(turn * r.x / length), std::sin(turn * r.x / length)};
  return (1 / static_cast<double>(state.position.size())) * sum;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(enskog_monte_carlo)

// 8000 particles over 40 mean free times: some 160,000 collisions, so the rate is known to a quarter of a percent.
BOOST_AUTO_TEST_CASE(an_elastic_gas_collides_at_enskogs_rate_and_keeps_energy_and_momentum) {
  for (const double nu : {0.05, 0.3, 0.5}) {
    const Scene s = gas(nu, 1);
    EnskogMonteCarlo mc(s, {.cells = 20, .particles_per_cell = 400, .step = 0.1});
    const double before = mc.kinetic_energy(), t = temperature(mc);
    const double rate = collision_rate({nu, t, s.diameter(), henderson_contact_value(nu)});
    mc.advance(40 / rate);
    const double per_particle = 2 * static_cast<double>(mc.sums().collisions) / static_cast<double>(mc.particles());
    BOOST_TEST(std::abs(per_particle / (rate * mc.time()) - 1) < 0.01, nu << ": " << per_particle / (rate * mc.time()));
    BOOST_TEST(std::abs(mc.kinetic_energy() / before - 1) < 1e-12);
    Vec2 momentum;
    for (const Vec2 v : mc.velocities()) momentum = momentum + v;
    BOOST_TEST(std::abs(momentum.x) + std::abs(momentum.y) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(an_inelastic_gas_cools_by_haffs_law) {
  const double nu = 0.2, e = 0.95;
  const Scene s = gas(nu, e);
  EnskogMonteCarlo mc(s, {.cells = 20, .particles_per_cell = 400, .step = 0.1});
  const double t = temperature(mc), before = mc.kinetic_energy();
  const Gas start{nu, t, s.diameter(), henderson_contact_value(nu)};
  mc.advance(20 / collision_rate(start));
  // Velocities are a little off Gaussian: 3 a2/16 of the rate, a2 = -.01 here.
  BOOST_TEST(std::abs(temperature(mc) / haff_temperature(start, e, mc.time()) - 1) < 0.02);
  BOOST_TEST(std::abs((before - mc.kinetic_energy()) / mc.sums().pair_loss - 1) < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_channel_balances_and_its_walls_carry_the_weight) {
  const Scene s = channel(0.1, 0.95, 0.5);
  EnskogMonteCarlo mc(s, {.cells = 20, .particles_per_cell = 50, .step = 0.2});
  const double before = mc.kinetic_energy();
  mc.advance(30);
  const MonteCarloSums first = mc.sums();
  BOOST_TEST(std::abs((mc.kinetic_energy() - before - first.gravity_work + first.pair_loss + first.wall_loss[0] +
                       first.wall_loss[1]) /
                      first.gravity_work) < 1e-10);
  const double from = mc.time();
  mc.advance(60);
  const double duration = mc.time() - from, weight = s.particles / s.length();
  const auto gained = [&](const std::array<double, 2>& now, const std::array<double, 2>& then, std::size_t wall) {
    return (now[wall] - then[wall]) / duration;
  };
  const double friction = gained(mc.sums().wall_tangential, first.wall_tangential, 0) +
                          gained(mc.sums().wall_tangential, first.wall_tangential, 1);
  BOOST_TEST(std::abs(friction / weight - 1) < 0.02);
}

// An engine run (W/d 31, N 900, t from 60 to 260, seed 1) of nu .3, e_n .99, beta_w .9: mean flow 6.479(6), T 1.31 and
// nu .322 in the middle. Cells of half a diameter: of a whole one T is 7 % low.
BOOST_AUTO_TEST_CASE(profiles_are_close_to_those_of_disks) {
  const Scene s = channel(0.3, 0.99, 0.9);
  EnskogMonteCarlo mc(s, {.cells = 62, .particles_per_cell = 12, .step = 0.4});
  RowAverages p(s, 62);
  for (double t = 32; t < 42; t += 0.125) {
    mc.advance(t);
    p.add(mc);
  }
  double flow = 0, fraction = 0;
  for (std::size_t c = 0; c < p.size(); ++c)
    flow += p.mean_velocity(c) * p.area_fraction(c), fraction += p.area_fraction(c);
  BOOST_TEST(std::abs(flow / fraction / 6.479 - 1) < 0.03);
  double middle_temperature = 0, middle_fraction = 0;
  for (std::size_t c = 28; c < 34; ++c) {
    middle_temperature += p.temperature(c) / 6;
    middle_fraction += p.area_fraction(c) / 6;
  }
  BOOST_TEST(std::abs(middle_temperature / 1.31 - 1) < 0.08);
  BOOST_TEST(std::abs(middle_fraction / 0.322 - 1) < 0.03);
}

BOOST_AUTO_TEST_CASE(equal_seeds_give_equal_runs) {
  Scene s = channel(0.1, 0.95, 0.5);
  const auto energy = [&] {
    EnskogMonteCarlo mc(s, {.cells = 8, .particles_per_cell = 20, .step = 0.2});
    mc.advance(1);
    return mc.kinetic_energy();
  };
  const double once = energy();
  BOOST_TEST(energy() == once);
  ++s.seed;
  BOOST_TEST(energy() != once);
}

// What the program gave before it had cells along the channel.
BOOST_AUTO_TEST_CASE(one_cell_along_gives_what_it_always_gave) {
  EnskogMonteCarlo mc(channel(0.1, 0.95, 0.5), {.cells = 8, .particles_per_cell = 20, .step = 0.2});
  for (int k = 1; k <= 10; ++k) mc.advance(k / 10.0);
  BOOST_TEST(mc.sums().collisions == 1107U);
  BOOST_TEST(std::abs(mc.kinetic_energy() / 99.800900191950461 - 1) < 1e-12);
  BOOST_TEST(std::abs(mc.sums().pair_loss / 59.08577473439869 - 1) < 1e-12);
  for (const Vec2 r : mc.state().position) BOOST_REQUIRE(r.x == 0);
}

// As above: some 100,000 collisions, in cells of two diameters or of half of one. With so few particles the rate is
// half a percent large.
BOOST_AUTO_TEST_CASE(cells_along_keep_the_rate_energy_and_momentum) {
  const Scene s = gas(0.3, 1);
  for (const MonteCarloSetting& setting : {MonteCarloSetting{20, 20, 0.2, 26}, MonteCarloSetting{10, 10, 0.2, 104}}) {
    EnskogMonteCarlo mc(s, setting);
    const double before = mc.kinetic_energy(), t = temperature(mc);
    const double rate = collision_rate({0.3, t, s.diameter(), henderson_contact_value(0.3)});
    mc.advance(20 / rate);
    const double per_particle = 2 * static_cast<double>(mc.sums().collisions) / static_cast<double>(mc.particles());
    BOOST_TEST(std::abs(per_particle / (rate * mc.time()) - 1) < 0.015, per_particle / (rate * mc.time()));
    BOOST_TEST(std::abs(mc.kinetic_energy() / before - 1) < 1e-12);
    Vec2 momentum;
    for (const Vec2 v : mc.velocities()) momentum = momentum + v;
    BOOST_TEST(std::abs(momentum.x) + std::abs(momentum.y) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(a_uniform_flow_is_the_same_with_cells_along) {
  const Scene s = narrow();
  struct Result {
    RowAverages rows;
    double collisions;  // of a particle
  };
  const auto result = [&](const MonteCarloSetting& setting) {
    EnskogMonteCarlo mc(s, setting);
    RowAverages rows(s, setting.cells);
    const double before = mc.kinetic_energy();
    for (double t = 15; t < 40; t += 0.25) {
      mc.advance(t);
      rows.add(mc);
    }
    const MonteCarloSums& sums = mc.sums();
    BOOST_TEST(std::abs((mc.kinetic_energy() - before - sums.gravity_work + sums.pair_loss + sums.wall_loss[0] +
                         sums.wall_loss[1]) /
                        sums.gravity_work) < 1e-10);
    return Result{rows, 2 * static_cast<double>(sums.collisions) / static_cast<double>(mc.particles())};
  };
  const Result one = result({.cells = 10, .particles_per_cell = 160, .step = 0.2}),
               many = result({.cells = 10, .particles_per_cell = 32, .step = 0.2, .cells_along = 5});
  // 160 particles a row, seen 100 times of which a tenth are independent: T to 3 %, U/sqrt(T) and nu to 3 %; U of all
  // swings slowly, by 2 %.
  BOOST_TEST(std::abs(many.collisions / one.collisions - 1) < 0.03, many.collisions / one.collisions);
  for (std::size_t c = 0; c < 10; ++c) {
    BOOST_TEST(std::abs(many.rows.mean_velocity(c) / one.rows.mean_velocity(c) - 1) < 0.06);
    BOOST_TEST(std::abs(many.rows.temperature(c) / one.rows.temperature(c) - 1) < 0.1);
    BOOST_TEST(std::abs(many.rows.area_fraction(c) / one.rows.area_fraction(c) - 1) < 0.08);
  }
}

// Walls that change no velocity along x, and disks so small that none meet: each x is x_0 + c t + g t^2/2, and a wave
// decays as exp(-k^2 t^2/2) at T = 1 while it falls with the gas.
BOOST_AUTO_TEST_CASE(without_collisions_waves_spread_and_fall_freely) {
  Scene s = channel(0.1, 1, 1);
  s.particles = 10;
  s.width_over_diameter = 1e6;
  s.length_over_width = 3;
  const State start = [&] {
    State state = wave(20000, s.length(), 0.4, 0);
    for (Vec2& r : state.position) r.y = 0.001 + 0.998 * r.y;
    return state;
  }();
  EnskogMonteCarlo mc(s, {.cells = 4, .particles_per_cell = 500, .step = 0.1, .cells_along = 10}, start);
  mc.advance(0.3);
  mc.advance(0.7);
  BOOST_REQUIRE(mc.sums().collisions == 0U);
  const State end = mc.state();
  const double t = 0.7;
  double worst = 0;
  for (std::size_t i = 0; i < end.position.size(); ++i) {
    const double off = end.position[i].x - (start.position[i].x + start.velocity[i].x * t + t * t / 2);
    worst = std::max(worst, std::abs(off - s.length() * std::round(off / s.length())));
    BOOST_REQUIRE((end.position[i].x >= 0 && end.position[i].x < s.length()));
  }
  BOOST_TEST(worst < 1e-12);
  const Vec2 before = first_mode(start, s.length()), now = first_mode(end, s.length());
  BOOST_TEST(std::abs(before.x - 0.2) < 1e-6);
  const double k = turn / s.length(), left = 0.2 * std::exp(-k * k * t * t / 2);
  // Noise of a component: 1/sqrt(2 N) = .005; 4 of it.
  BOOST_TEST(std::abs(now.x - left * std::cos(k * t * t / 2)) < 0.02);
  BOOST_TEST(std::abs(now.y - left * std::sin(k * t * t / 2)) < 0.02);
}

// Enskog's pressure needs partners a diameter away along x as well. Density a cos kx with temperature Z a cos kx is a
// standing wave of sound: cos(ckt) and a damping, c^2 = T (d(nu Z)/d nu + Z^2), Z = 1 + 2 nu chi. Without the
// collisions' share the wave would take three times as long.
BOOST_AUTO_TEST_CASE(sound_has_enskogs_speed) {
  const double nu = 0.3, h = 1e-5;
  const auto pressure = [](double n) { return n * (1 + 2 * n * henderson_contact_value(n)); };
  const double z = pressure(nu) / nu;
  const double speed = std::sqrt((pressure(nu + h) - pressure(nu - h)) / (2 * h) + z * z);
  Scene s = gas(nu, 1);
  s.particles = 600;
  s.length_over_width = std::numbers::pi * 600 / (4 * nu * 400);
  const MonteCarloSetting setting{.cells = 4, .particles_per_cell = 100, .step = 0.25, .cells_along = 60};
  const double period = s.length() / speed;
  EnskogMonteCarlo mc(s, setting, wave(24000, s.length(), 0.2, 0.2 * z));
  const double start = first_mode(mc.state(), s.length()).x;
  // Noise 1/sqrt(2 N S) with S = .26 is below .005, or .05 of the start.
  mc.advance(period / 4);
  const double quarter = first_mode(mc.state(), s.length()).x / start;
  BOOST_TEST(std::abs(quarter) < 0.2, quarter);
  mc.advance(period / 2);
  const double half = first_mode(mc.state(), s.length()).x / start;
  BOOST_TEST((half < -0.5 && half > -0.95), half);
}

BOOST_AUTO_TEST_CASE(what_it_cannot_do_is_refused) {
  const Scene s = channel(0.3, 0.9, 0.9);
  BOOST_CHECK_THROW(EnskogMonteCarlo(s, {.cells = 3}), InputError);
  BOOST_CHECK_THROW(EnskogMonteCarlo(s, {.particles_per_cell = 9}), InputError);
  BOOST_CHECK_THROW(EnskogMonteCarlo(s, {.step = 0.6}), InputError);
  BOOST_CHECK_THROW(EnskogMonteCarlo(channel(0.75, 0.9, 0.9), {}), PhysicsError);
  BOOST_CHECK_THROW(EnskogMonteCarlo(s, {.cells_along = 0}), InputError);
  BOOST_CHECK_THROW(EnskogMonteCarlo(s, {.cells = 100000, .particles_per_cell = 10000, .cells_along = 3}), InputError);
  EnskogMonteCarlo dense(channel(0.75, 0.9, 0.9), {.cells = 20, .particles_per_cell = 20, .cells_along = 10});
  BOOST_CHECK_THROW(dense.advance(1), PhysicsError);
}

BOOST_AUTO_TEST_CASE(a_start_that_does_not_fit_is_refused) {
  const Scene s = gas(0.1, 1);
  const MonteCarloSetting setting{.cells = 4, .particles_per_cell = 10, .cells_along = 2};
  State start = wave(80, s.length(), 0, 0);
  BOOST_CHECK_NO_THROW(EnskogMonteCarlo(s, setting, start));
  BOOST_CHECK_THROW(EnskogMonteCarlo(s, {.cells = 4, .particles_per_cell = 10}, start), InputError);
  start.position[7].y = 1.1;
  BOOST_CHECK_THROW(EnskogMonteCarlo(s, setting, start), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
