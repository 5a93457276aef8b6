// Symmetries of the physics that the arithmetic keeps to the last bit: mirrors, scales of gravity, names of disks; and
// a Galilean boost, which it keeps to round-off.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <vector>

#include "gpf/base/random.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "support/contact_log.hpp"
#include "support/scenes.hpp"

using namespace gpf;
using test::Contact;

namespace {

struct Outcome {
  std::vector<Contact> contacts;
  EngineState state;  ///< in the falling frame, where positions are exact
};

Outcome run(const Scene& scene, const State& start, int epochs) {
  Engine<> engine(scene, start);
  test::ContactLog log;
  engine.advance(epochs * engine.epoch_length(), log);
  return {log.contacts, engine.checkpoint()};
}

/// On the grid of the engine: what is mirrored before or after rounding is then the same.
State on_grid(const Scene& scene, State state) {
  const PositionGrid grid(scene.length(), 1);
  for (Vec2& r : state.position) r = {grid.round(r.x), grid.round(r.y)};
  return state;
}

/// Dilute, dense, inelastic, with and without walls and TC; ten thousand contacts or so each.
struct Case {
  Scene scene;
  int epochs;
};
std::vector<Case> cases() {
  return {{test::gas(120, 0.05), 40},
          {test::gas(120, 0.65), 16},
          {test::gas(120, 0.3, 0.9), 30},
          {test::channel(120, 0.3, 9.3), 60},
          {test::channel(150, 0.7, 11, 0.8), 80},
          {test::smooth_channel(60, 0.1, 7), 60}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(symmetry)

BOOST_AUTO_TEST_CASE(mirrored_across_the_channel_everything_happens_mirrored_to_the_bit) {
  for (const auto& [scene, epochs] : cases()) {
    const bool walls = scene.geometry == Geometry::channel;
    const State start = on_grid(scene, start_state(scene));
    State mirrored = start;
    for (Vec2& r : mirrored.position) r.y = 1 - r.y;
    for (Vec2& v : mirrored.velocity) v.y = -v.y;
    Scene swapped = scene;
    std::swap(swapped.wall_tangential_restitution[0], swapped.wall_tangential_restitution[1]);
    Outcome a = run(scene, start, epochs);
    const Outcome b = run(swapped, mirrored, epochs);
    BOOST_TEST(a.contacts.size() > 3000u);
    for (Contact& c : a.contacts)
      if (c.b < 0) c.b = -3 - c.b;  // the other wall
    BOOST_TEST((a.contacts == b.contacts));
    for (std::size_t i = 0; i < a.state.x.size(); ++i) {
      BOOST_REQUIRE(a.state.x[i] == b.state.x[i]);
      BOOST_REQUIRE((walls ? 1 - a.state.y[i] == b.state.y[i] : std::fmod(a.state.y[i] + b.state.y[i], 1) == 0));
      BOOST_REQUIRE(a.state.vx[i] == b.state.vx[i]);
      BOOST_REQUIRE(a.state.vy[i] == -b.state.vy[i]);
    }
  }
}

BOOST_AUTO_TEST_CASE(mirrored_along_the_channel_without_gravity_too) {
  for (auto [scene, epochs] : cases()) {
    scene.gravity = 0;
    const State start = on_grid(scene, start_state(scene));
    const double period = PositionGrid(scene.length(), 1).round(scene.length());
    State mirrored = start;
    for (Vec2& r : mirrored.position) r.x = period - r.x;
    for (Vec2& v : mirrored.velocity) v.x = -v.x;
    const Outcome a = run(scene, start, epochs), b = run(scene, mirrored, epochs);
    BOOST_TEST(a.contacts.size() > 1000u);
    BOOST_TEST((a.contacts == b.contacts));
    for (std::size_t i = 0; i < a.state.x.size(); ++i) {
      BOOST_REQUIRE(std::fmod(a.state.x[i] + b.state.x[i], period) == 0);
      BOOST_REQUIRE(a.state.y[i] == b.state.y[i]);
      BOOST_REQUIRE(a.state.vx[i] == -b.state.vx[i]);
      BOOST_REQUIRE(a.state.vy[i] == b.state.vy[i]);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_galilean_boost_changes_no_contact) {
  // Velocities of order one are rounded anew by the boost, to 1.1e-16, and the deviation grows: over half as many
  // contacts again as the mean for the disks with the most; a factor of 100 for oblique contacts and other roundings.
  for (const double area_fraction : {0.05, 0.3, 0.65}) {
    const Scene scene = test::gas(120, area_fraction);
    const State start = start_state(scene);
    State boosted = start;
    for (Vec2& v : boosted.velocity) v = v + Vec2{0.37, -0.71};
    const auto still = run(scene, start, 6).contacts, moving = run(scene, boosted, 6).contacts;
    BOOST_REQUIRE(std::min(still.size(), moving.size()) >= 300u);
    for (std::size_t k = 0; k < 300; ++k) {
      BOOST_REQUIRE((still[k].a == moving[k].a && still[k].b == moving[k].b));
      const double bound = 1.1e-14 * test::growth(scene, 1.5 * static_cast<double>(k + 1));
      BOOST_REQUIRE(std::abs(still[k].time - moving[k].time) < bound);
    }
  }
}

BOOST_AUTO_TEST_CASE(gravity_and_time_scale_together_to_the_bit) {
  // g -> s^2 g, velocities s, times 1/s, for powers of two: nothing is rounded differently.
  const Scene scene = test::channel(150, 0.5, 11, 0.85);
  const State start = start_state(scene);
  const Outcome a = run(scene, start, 60);
  BOOST_TEST(a.contacts.size() > 10000u);
  for (const double s : {0.125, 0.5, 2.0, 16.0}) {
    Scene scaled = scene;
    scaled.gravity *= s * s;
    scaled.tc_time /= s;
    const State fast = start_state(scaled);
    for (std::size_t i = 0; i < fast.velocity.size(); ++i) BOOST_REQUIRE((fast.velocity[i] == s * start.velocity[i]));
    const Outcome b = run(scaled, fast, 60);
    BOOST_REQUIRE(a.contacts.size() == b.contacts.size());
    for (std::size_t k = 0; k < a.contacts.size(); ++k)
      BOOST_REQUIRE((b.contacts[k] == Contact{a.contacts[k].time / s, a.contacts[k].a, a.contacts[k].b}));
    BOOST_TEST((a.state.x == b.state.x));
    BOOST_TEST((a.state.y == b.state.y));
    for (std::size_t i = 0; i < a.state.x.size(); ++i) {
      BOOST_REQUIRE(b.state.vx[i] == s * a.state.vx[i]);
      BOOST_REQUIRE(b.state.vy[i] == s * a.state.vy[i]);
    }
    BOOST_TEST(b.state.frame_velocity == s * a.state.frame_velocity);
  }
}

BOOST_AUTO_TEST_CASE(the_names_of_disks_do_not_matter_to_the_bit) {
  for (const auto& [scene, epochs] : cases()) {
    const State start = start_state(scene);
    const std::size_t count = start.position.size();
    std::vector<std::size_t> name(count);  // the new number of each disk
    std::iota(name.begin(), name.end(), 0u);
    for (std::size_t k = count - 1; k > 0; --k) std::swap(name[k], name[random_words(5, 5, k)[0] % (k + 1)]);
    State renamed = start;
    for (std::size_t i = 0; i < count; ++i)
      renamed.position[name[i]] = start.position[i], renamed.velocity[name[i]] = start.velocity[i];
    Outcome a = run(scene, start, epochs);
    const Outcome b = run(scene, renamed, epochs);
    for (Contact& c : a.contacts) {
      c.a = static_cast<std::int32_t>(name[static_cast<std::size_t>(c.a)]);
      if (c.b >= 0) c.b = static_cast<std::int32_t>(name[static_cast<std::size_t>(c.b)]);
      if (c.b >= 0 && c.a > c.b) std::swap(c.a, c.b);
    }
    BOOST_TEST((a.contacts == b.contacts));
    for (std::size_t i = 0; i < count; ++i) {
      BOOST_REQUIRE(a.state.x[i] == b.state.x[name[i]]);
      BOOST_REQUIRE(a.state.y[i] == b.state.y[name[i]]);
      BOOST_REQUIRE(a.state.vx[i] == b.state.vx[name[i]]);
      BOOST_REQUIRE(a.state.vy[i] == b.state.vy[name[i]]);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
