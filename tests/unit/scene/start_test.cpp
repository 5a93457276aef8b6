#include "gpf/scene/start.hpp"

#include <bit>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/hash.hpp"
#include "gpf/scene/lattice.hpp"

using namespace gpf;

namespace {

Scene scene_of(std::int32_t particles, double gravity = 1) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = particles;
  scene.width_over_diameter = 31;
  scene.length_over_width = particles > 100 ? particles / 400.0 : 2;
  scene.gravity = gravity;
  return scene;
}

struct Moments {
  long double x = 0, y = 0, xx = 0, yy = 0, xy = 0, xxxx = 0;
};

Moments moments_of(const State& state) {
  Moments m;
  for (const Vec2 v : state.velocity) {
    const long double x = v.x, y = v.y;
    m.x += x, m.y += y, m.xx += x * x, m.yy += y * y, m.xy += x * y, m.xxxx += x * x * x * x;
  }
  const auto n = static_cast<long double>(state.velocity.size());
  return {m.x / n, m.y / n, m.xx / n, m.yy / n, m.xy / n, m.xxxx / n};
}

std::uint64_t bits_of(const State& state) {
  std::uint64_t hash = 0;
  const auto add = [&hash](double value) { hash = mix(hash + std::bit_cast<std::uint64_t>(value)); };
  for (const Vec2 r : state.position) add(r.x), add(r.y);
  for (const Vec2 v : state.velocity) add(v.x), add(v.y);
  return hash;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(start_test)

BOOST_AUTO_TEST_CASE(positions_are_the_lattice) {
  const Scene scene = scene_of(900);
  const State state = start_state(scene);
  BOOST_TEST((state.position == place_on_lattice(scene)));
  BOOST_TEST(state.velocity.size() == state.position.size());
}

BOOST_AUTO_TEST_CASE(mean_and_variance_are_exact) {
  for (const std::int32_t n : {2, 3, 900, 100000})
    for (const double g : {0.0, 1.0, 0.3}) {
      const Scene scene = scene_of(n, g);
      const Moments m = moments_of(start_state(scene));
      const double scale = scene.velocity_scale();
      // Each velocity is rounded to 2^-53 of a few scales; the mean of their errors is below that.
      BOOST_TEST(std::abs(static_cast<double>(m.x)) < 1e-15 * scale);
      BOOST_TEST(std::abs(static_cast<double>(m.y)) < 1e-15 * scale);
      BOOST_TEST(std::abs(static_cast<double>((m.xx + m.yy) / 2) / (scale * scale) - 1) < 1e-15);
    }
}

BOOST_AUTO_TEST_CASE(velocities_are_gaussian) {
  constexpr double n = 100000;
  const Moments m = moments_of(start_state(scene_of(100000)));
  // Five sigma: <v_x^2> - 1 has sigma 1/sqrt(N) at fixed sum of both, <v_x v_y> 1/sqrt(N), <v_x^4> sqrt(96/N) at most.
  BOOST_TEST(std::abs(static_cast<double>(m.xx) - 1) < 5 / std::sqrt(n));
  BOOST_TEST(std::abs(static_cast<double>(m.xy)) < 5 / std::sqrt(n));
  BOOST_TEST(std::abs(static_cast<double>(m.xxxx) - 3) < 5 * std::sqrt(96 / n));
  // Beyond one and two sigma lie 31.731 % and 4.5500 %; binomial errors, five sigma.
  double beyond_1 = 0, beyond_2 = 0;
  for (const Vec2 v : start_state(scene_of(100000)).velocity)
    beyond_1 += std::abs(v.x) > 1, beyond_2 += std::abs(v.x) > 2;
  BOOST_TEST(std::abs(beyond_1 / n - 0.31731) < 5 * std::sqrt(0.31731 * 0.68269 / n));
  BOOST_TEST(std::abs(beyond_2 / n - 0.04550) < 5 * std::sqrt(0.0455 * 0.9545 / n));
}

BOOST_AUTO_TEST_CASE(one_disk_keeps_its_temperature_and_moves) {
  const State state = start_state(scene_of(1));
  BOOST_REQUIRE_EQUAL(state.velocity.size(), 1u);
  BOOST_TEST(std::abs(dot(state.velocity[0], state.velocity[0]) / 2 - 1) < 1e-15);
}

BOOST_AUTO_TEST_CASE(two_disks_move_oppositely) {
  const State state = start_state(scene_of(2));
  BOOST_TEST(std::abs(state.velocity[0].x + state.velocity[1].x) < 1e-15);
  BOOST_TEST(std::abs(state.velocity[0].y + state.velocity[1].y) < 1e-15);
}

BOOST_AUTO_TEST_CASE(the_seed_decides) {
  Scene scene = scene_of(900);
  const State first = start_state(scene);
  BOOST_TEST((start_state(scene).velocity == first.velocity));
  scene.seed = 2;
  const State second = start_state(scene);
  BOOST_TEST((second.position == first.position));
  double correlation = 0;
  for (std::size_t i = 0; i < 900; ++i) correlation += dot(first.velocity[i], second.velocity[i]) / 2;
  BOOST_TEST(std::abs(correlation / 900) < 5 / std::sqrt(2 * 900.0));  // independent: sigma 1/sqrt(2N)
}

BOOST_AUTO_TEST_CASE(gravity_four_times_larger_doubles_velocities_bit_for_bit) {
  const State one = start_state(scene_of(900, 1)), four = start_state(scene_of(900, 4));
  for (std::size_t i = 0; i < 900; ++i) {
    BOOST_TEST(four.velocity[i].x == 2 * one.velocity[i].x);
    BOOST_TEST(four.velocity[i].y == 2 * one.velocity[i].y);
  }
}

// From gcc 12 -O2 on x86-64; any compiler and level must give the same.
BOOST_AUTO_TEST_CASE(the_bits_are_known) {
  Scene scene = scene_of(900);
  scene.seed = 20240229;
  BOOST_TEST(hexadecimal(bits_of(start_state(scene))) == "6981422c33433128");
  scene.lattice = Lattice::triangular;
  BOOST_TEST(hexadecimal(bits_of(start_state(scene))) == "c98090da159d04e6");
  scene.geometry = Geometry::periodic;
  BOOST_TEST(hexadecimal(bits_of(start_state(scene))) == "86264336df2a1bfd");
}

BOOST_AUTO_TEST_SUITE_END()
