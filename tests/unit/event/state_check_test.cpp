// States that the engine must refuse, and some at the edge that it must take.
#include "gpf/event/state_check.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "gpf/base/random.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

/// Two disks at these centres, d = 1/8, L = 1.3.
struct Pair {
  Pair(Geometry geometry, Vec2 r1, Vec2 r2) {
    scene.geometry = geometry;
    scene.particles = 2;
    scene.width_over_diameter = 8;
    scene.length_over_width = 1.3;
    state.x = {r1.x, r2.x}, state.y = {r1.y, r2.y};
    state.vx = state.vy = {0, 0};
    state.last_contact = {0, 0};
  }
  [[nodiscard]] bool inside() const {
    try {
      detail::require_inside(scene, state);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }
  [[nodiscard]] bool apart() const {
    try {
      detail::require_apart(scene, state);
      return true;
    } catch (const PhysicsError&) {
      return false;
    }
  }
  Scene scene;
  EngineState state;
};

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

}  // namespace

BOOST_AUTO_TEST_SUITE(state_check)

BOOST_AUTO_TEST_CASE(inside_the_box) {
  const double wall = 1.0 / 16;
  const Vec2 somewhere{0.5, 0.5};
  for (const Vec2 r : {Vec2{0, 0.3}, Vec2{1.3, 0.3}, Vec2{1.2999, wall}, Vec2{0.2, 1 - wall}, Vec2{-1e-16, 0.3}})
    BOOST_TEST(Pair(Geometry::channel, somewhere, r).inside());
  for (const Vec2 r : {Vec2{-0.01, 0.3}, Vec2{1.31, 0.3}, Vec2{0.2, wall - 1e-9}, Vec2{0.2, 1 - wall + 1e-9},
                       Vec2{not_a_number, 0.3}, Vec2{0.3, not_a_number}, Vec2{infinity, 0.5}})
    BOOST_TEST(!Pair(Geometry::channel, somewhere, r).inside());
  BOOST_TEST(Pair(Geometry::periodic, somewhere, {0.2, 0}).inside());
  BOOST_TEST(Pair(Geometry::periodic, somewhere, {0.2, 1}).inside());
  BOOST_TEST(!Pair(Geometry::periodic, somewhere, {0.2, 1.001}).inside());
  BOOST_TEST(!Pair(Geometry::periodic, somewhere, {0.2, -0.001}).inside());
}

BOOST_AUTO_TEST_CASE(finite_velocities_and_the_right_number_of_disks) {
  Pair p(Geometry::periodic, {0.2, 0.2}, {0.7, 0.7});
  BOOST_TEST(p.inside());
  p.state.vx[1] = not_a_number;
  BOOST_TEST(!p.inside());
  p.state.vx[1] = 0, p.state.vy[0] = infinity;
  BOOST_TEST(!p.inside());
  p.state.vy[0] = 0, p.state.last_contact.pop_back();
  BOOST_TEST(!p.inside());
}

BOOST_AUTO_TEST_CASE(the_message_names_the_disk) {
  const Pair p(Geometry::channel, {0.5, 0.5}, {0.25, 0.03125});
  BOOST_CHECK_EXCEPTION(detail::require_inside(p.scene, p.state), InputError, [](const InputError& error) {
    const std::string what = error.what();
    return what.find("disk 1: x 0.25 y 0.03125") != what.npos && what.find("y in [0.0625, 0.9375]") != what.npos;
  });
}

BOOST_AUTO_TEST_CASE(overlap_is_seen_across_periods_but_not_through_walls) {
  const double d = 1.0 / 8;
  // Beside, above, across x, across y, across the corner; 1 % inside and 1 % apart.
  for (const double gap : {-0.01 * d, 0.01 * d}) {
    const double s = d + gap;
    const auto expect = [&](Geometry geometry, Vec2 r1, Vec2 r2, bool apart) {
      BOOST_TEST(Pair(geometry, r1, r2).apart() == apart);
      BOOST_TEST(Pair(geometry, r2, r1).apart() == apart);
    };
    for (const Geometry geometry : {Geometry::channel, Geometry::periodic}) {
      expect(geometry, {0.5, 0.5}, {0.5 + s, 0.5}, gap > 0);
      expect(geometry, {0.5, 0.5}, {0.5, 0.5 - s}, gap > 0);
      expect(geometry, {0.5, 0.5}, {0.5 + 0.6 * s, 0.5 + 0.8 * s}, gap > 0);
      expect(geometry, {0.05, 0.5}, {0.05 - s + 1.3, 0.5}, gap > 0);
      expect(geometry, {0.05, 0.5}, {0.05 - 0.6 * s + 1.3, 0.5 + 0.8 * s}, gap > 0);
    }
    expect(Geometry::periodic, {0.5, 0.05}, {0.5, 0.05 - s + 1}, gap > 0);
    expect(Geometry::periodic, {0.05, 0.05}, {0.05 - 0.6 * s + 1.3, 0.05 - 0.8 * s + 1}, gap > 0);
    expect(Geometry::channel, {0.5, 0.0625}, {0.5, 0.9375}, true);
  }
}

BOOST_AUTO_TEST_CASE(round_off_is_forgiven) {
  const double d = 1.0 / 8, forgiven = 1.3 * 0x1p-46;
  BOOST_TEST(Pair(Geometry::channel, {0.5, 0.5}, {0.5 + d, 0.5}).apart());
  BOOST_TEST(Pair(Geometry::channel, {0.5, 0.5}, {0.5 + d - 0.9 * forgiven, 0.5}).apart());
  BOOST_TEST(!Pair(Geometry::channel, {0.5, 0.5}, {0.5 + d - 1.1 * forgiven, 0.5}).apart());
}

BOOST_AUTO_TEST_CASE(agrees_with_a_look_at_all_pairs) {
  // Disks thrown into the box at random, so few that about half of the boxes are free of overlaps.
  int free = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Scene scene = test::gas(12, 0.05);
    if (seed % 2 == 0) scene.length_over_width *= 2.1;
    EngineState state;
    const std::vector<double> zeros(12, 0);
    state.vx = state.vy = state.last_contact = zeros;
    for (std::uint64_t i = 0; i < 12; ++i) {
      const auto words = random_words(seed, 0, i);
      state.x.push_back(scene.length() * words[0] * 0x1p-32);
      state.y.push_back(words[1] * 0x1p-32);
    }
    bool overlap = false;
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (const double sx : {-scene.length(), 0.0, scene.length()})
          for (const double sy : {-1.0, 0.0, 1.0})
            overlap |= std::hypot(state.x[j] - state.x[i] + sx, state.y[j] - state.y[i] + sy) < scene.diameter();
    if (overlap)
      BOOST_CHECK_THROW(detail::require_apart(scene, state), PhysicsError);
    else
      BOOST_CHECK_NO_THROW(detail::require_apart(scene, state));
    free += overlap ? 0 : 1;
  }
  BOOST_TEST(free > 50);
  BOOST_TEST(free < 250);
}

BOOST_AUTO_TEST_CASE(periods_of_three_diameters_are_too_short) {
  Scene scene = test::gas(2, 0.1);
  scene.width_over_diameter = 4;
  for (const auto& [length, fits] : {std::pair{0.7, false}, std::pair{0.75, false}, std::pair{0.76, true}}) {
    scene.length_over_width = length;
    if (fits)
      BOOST_CHECK_NO_THROW(detail::require_room(scene));
    else
      BOOST_CHECK_THROW(detail::require_room(scene), InputError);
  }
  scene.length_over_width = 5;
  scene.width_over_diameter = 2.9;
  BOOST_CHECK_THROW(detail::require_room(scene), InputError);
  scene.geometry = Geometry::channel;
  BOOST_CHECK_NO_THROW(detail::require_room(scene));
}

BOOST_AUTO_TEST_SUITE_END()
