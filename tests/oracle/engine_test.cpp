// The engine against the all-pairs oracle, with which it shares no event code: the same contacts from the same start.
//
// How many can be compared? Every contact makes a small deviation of its two disks grow (test::growth), so that
// roundings of 1e-16 reach 1e-9 after one to five contacts per disk, the earlier the more dilute; later both codes are
// right and differ. The oracle in long double says where that is: it starts with roundings of 5e-20, and the engine
// must follow it about as far as the oracle in double does.
#include "gpf/event/engine.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "gpf/methods/all_pairs.hpp"
#include "gpf/scene/start.hpp"
#include "support/contact_log.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

struct Case {
  std::string name;
  Scene scene;
  std::size_t comparable;  ///< contacts that must agree, in pairs and in times to 1e-9
};

std::vector<Case> cases() {
  std::vector<Case> all{{"dilute gas", test::gas(200, 0.05), 300},
                        {"gas", test::gas(200, 0.3), 900},
                        {"gas of 50", test::gas(50, 0.3), 280},
                        {"dense gas", test::gas(200, 0.65), 2000},
                        {"inelastic gas", test::gas(200, 0.3, 0.8), 900},
                        {"dilute smooth channel", test::smooth_channel(200, 0.05, 11), 350},
                        {"smooth channel", test::smooth_channel(200, 0.4, 11), 1300},
                        {"dense smooth channel", test::smooth_channel(200, 0.75, 11), 2000},
                        {"narrow channel", test::channel(20, 0.3, 1.5), 250},
                        {"short channel", test::channel(9, 0.55, 3.2), 140},
                        {"odd walls", test::channel(100, 0.4, 11, 0.8), 700}};
  all[9].scene.length_over_width = 4 * all[9].scene.diameter();
  all[10].scene.wall_tangential_restitution = {-0.5, 0};
  all[10].scene.wall_normal_restitution = 0.6;
  for (const double e : {0.99, 0.8})
    for (const auto& [area_fraction, comparable] : {std::pair{0.05, 400}, std::pair{0.4, 1400}, std::pair{0.75, 2000}})
      for (const double tc : {1e-4, 0.1, 0.0}) {  // in mean free times: the default, one that acts often, none
        Scene scene = test::channel(200, area_fraction, 11, e);
        scene.tc_time = tc / scene.reference_collision_rate();
        all.push_back({"rough channel, e " + std::to_string(e) + ", nu " + std::to_string(area_fraction) + ", tc " +
                           std::to_string(tc),
                       scene, static_cast<std::size_t>(comparable)});
      }
  return all;
}

/// On the grid of the engine, so that all begin with the same bits.
State start_on_grid(const Scene& scene) {
  State start = start_state(scene);
  const PositionGrid grid(scene.length(), 1);
  for (Vec2& r : start.position) r = {grid.round(r.x), grid.round(r.y)};
  return start;
}

template <class Event, class Other>
std::size_t agreement(const std::vector<Event>& p, const std::vector<Other>& q, double tolerance) {
  std::size_t k = 0;
  while (k < p.size() && k < q.size() && p[k].a == q[k].a && p[k].b == q[k].b &&
         std::abs(p[k].time - q[k].time) <= tolerance)
    ++k;
  return k;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(engine_and_oracle)

BOOST_AUTO_TEST_CASE(the_same_contacts_as_far_as_double_precision_can_see) {
  constexpr std::size_t contacts = 2500;
  for (const Case& c : cases()) {
    const State start = start_on_grid(c.scene);
    AllPairs<double> coarse(c.scene, start);
    AllPairs<long double> fine(c.scene, start);
    std::vector<AllPairsEvent> in_double, in_long_double;
    while (in_double.size() < contacts) {
      in_double.push_back(coarse.step());
      in_long_double.push_back(fine.step());
    }
    Engine<> engine(c.scene, start);
    test::ContactLog log;
    while (log.contacts.size() < contacts) engine.advance(engine.epoch_end(), log);
    log.contacts.resize(contacts);

    const std::size_t reached = agreement(log.contacts, in_long_double, 1e-9);
    const std::size_t oracle_reached = agreement(in_double, in_long_double, 1e-9);
    BOOST_TEST_MESSAGE(c.name << ": engine " << reached << ", oracle in double " << oracle_reached);
    BOOST_TEST(reached >= c.comparable, c.name << ": " << reached << " of " << c.comparable << " contacts agree");
    // Which of the two is the luckier depends on roundings; a factor of 10 in the deviation is an eighth of the way.
    BOOST_TEST(static_cast<double>(reached) >= 0.75 * static_cast<double>(oracle_reached), c.name);
  }
}

BOOST_AUTO_TEST_CASE(the_same_states_losses_and_impulses) {
  struct Books {
    AllPairsSums sums;
    void on_pair(const PairContact& c) {
      ++sums.pair_contacts;
      sums.pair_loss += c.energy_loss;
      sums.virial += dot(c.r_12, c.impulse);
    }
    void on_wall(const WallContact& c) {
      AllPairsWall& wall = sums.wall[static_cast<std::size_t>(c.wall)];
      ++wall.contacts;
      wall.loss += (dot(c.velocity_before, c.velocity_before) - dot(c.velocity_after, c.velocity_after)) / 2;
      wall.normal_impulse += std::abs(c.velocity_after.y - c.velocity_before.y);
      wall.tangential_impulse += c.velocity_before.x - c.velocity_after.x;
    }
  };
  for (const Case& c : cases()) {
    const State start = start_on_grid(c.scene);
    AllPairs<double> oracle(c.scene, start);
    for (std::size_t k = 0; k < c.comparable; ++k) oracle.step();
    const double time = oracle.time() * (1 + 1e-6);  // clear of the last contact
    oracle.advance(time);
    Engine<> engine(c.scene, start);
    Books books;
    engine.advance(time, books);

    // Times agree to 1e-9 there, and so do states and what is summed, to that times velocities and rates of change.
    const State p = engine.state(), q = oracle.state();
    double deviation = 0;
    for (std::size_t i = 0; i < p.position.size(); ++i) {
      const Vec2 r = p.position[i] - q.position[i], v = p.velocity[i] - q.velocity[i];
      const double y = c.scene.geometry == Geometry::channel ? r.y : std::remainder(r.y, 1);
      deviation = std::max(
          {deviation, std::abs(std::remainder(r.x, c.scene.length())), std::abs(y), std::abs(v.x), std::abs(v.y)});
    }
    BOOST_TEST(deviation < 1e-6, c.name << ": states differ by " << deviation);
    const AllPairsSums &a = books.sums, &b = oracle.sums();
    const auto agree = [&](double x, double y) { BOOST_TEST(std::abs(x - y) <= 1e-6 * (std::abs(y) + 1), c.name); };
    BOOST_TEST(a.pair_contacts == b.pair_contacts, c.name);
    agree(a.pair_loss, b.pair_loss);
    agree(a.virial, b.virial);
    for (std::size_t wall = 0; wall < 2; ++wall) {
      BOOST_TEST(a.wall[wall].contacts == b.wall[wall].contacts, c.name);
      agree(a.wall[wall].loss, b.wall[wall].loss);
      agree(a.wall[wall].normal_impulse, b.wall[wall].normal_impulse);
      agree(a.wall[wall].tangential_impulse, b.wall[wall].tangential_impulse);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_answer_to_a_row_of_touching_disks) {
  // Contacts at one instant dissipate in both when the TC model is off.
  Scene scene = test::gas(3, 0.02, 0.5);
  scene.width_over_diameter = 8;
  const State start{{{0.25, 0.5}, {0.625, 0.5}, {0.75, 0.5}}, {{1, 0}, {0, 0}, {0, 0}}};
  Engine<> engine(scene, start);
  AllPairs<double> oracle(scene, start);
  engine.advance(0.3);
  oracle.advance(0.3);
  for (std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(std::abs(engine.state().velocity[i].x - oracle.state().velocity[i].x) < 1e-15);
    BOOST_TEST(engine.state().velocity[i].y == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
