// Contacts at one instant: their order is the engine's own, whatever the queue and the cells.
#include <boost/test/unit_test.hpp>
#include <vector>

#include "gpf/event/engine.hpp"
#include "gpf/event/heap_queue.hpp"
#include "support/contact_log.hpp"

using namespace gpf;
using test::Contact;

namespace {

/// d = 1/16 in a box of side 1, so that positions and times of the scenes below are exact.
Scene scene_of(std::size_t particles, double normal_restitution = 1) {
  Scene scene;
  scene.geometry = Geometry::periodic;
  scene.particles = static_cast<std::int32_t>(particles);
  scene.width_over_diameter = 16;
  scene.length_over_width = 1;
  scene.normal_restitution = normal_restitution;
  return scene;
}

template <class Queue>
std::vector<Contact> contacts(const Scene& scene, const State& start, double time, double disks_per_cell) {
  Engine<Queue> engine(scene, start, disks_per_cell);
  test::ContactLog log;
  engine.advance(time, log);
  return log.contacts;
}

/// The same contacts in the same order from both queues and all cells; returns them.
std::vector<Contact> contacts_in_any_way(const Scene& scene, const State& start, double time) {
  const auto reference = contacts<HeapQueue>(scene, start, time, 0);
  BOOST_TEST(!reference.empty());
  for (const double disks_per_cell : {0.0, 0.1, 0.3, 1.0, 3.0, 10.0}) {
    BOOST_TEST((contacts<HeapQueue>(scene, start, time, disks_per_cell) == reference));
    BOOST_TEST((contacts<CalendarQueue>(scene, start, time, disks_per_cell) == reference));
  }
  return reference;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ties)

BOOST_AUTO_TEST_CASE(a_disk_hit_from_both_sides_answers_the_lower_number_first) {
  const State start{{{0.25, 0.5}, {0.5, 0.5}, {0.75, 0.5}}, {{1, 0}, {0, 0}, {-1, 0}}};
  for (const double e : {1.0, 0.5}) {
    const auto found = contacts_in_any_way(scene_of(3, e), start, 5);
    const double t = 0.25 - 1.0 / 16;
    const std::vector<Contact> first{{t, 0, 1}, {t, 1, 2}, {t, 0, 1}};
    BOOST_TEST((std::vector<Contact>(found.begin(), found.begin() + 3) == first));
  }
}

BOOST_AUTO_TEST_CASE(four_disks_meet_at_once_alone_and_around_a_fifth) {
  const State four{{{0.25, 0.5}, {0.75, 0.5}, {0.5, 0.25}, {0.5, 0.75}}, {{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto found = contacts_in_any_way(scene_of(4), four, 5);
  BOOST_TEST((found[0].a == 0 && found[0].b == 2));  // (0, 1) and (2, 3) are still apart: the ring closes first
  BOOST_TEST(found[3].time == found[0].time);
  State five = four;
  five.position.push_back({0.5, 0.5});
  five.velocity.push_back({0, 0});
  for (const double e : {1.0, 0.75}) {
    const auto around = contacts_in_any_way(scene_of(5, e), five, 5);
    BOOST_TEST((around[0].a == 0 && around[0].b == 4));
  }
}

BOOST_AUTO_TEST_CASE(a_pair_goes_before_a_wall) {
  // Disk 0 reaches the wall in the instant in which disk 1 reaches it.
  Scene scene = scene_of(2);
  scene.geometry = Geometry::channel;
  scene.width_over_diameter = 8;
  scene.length_over_width = 2;
  const State start{{{0.5, 0.3125}, {1.125, 0.3125}}, {{0, -1}, {-2, -1}}};
  const double t = 0.25;
  const auto found = contacts_in_any_way(scene, start, t);
  BOOST_REQUIRE(found.size() == 3u);
  BOOST_TEST((found[0] == Contact{t, 0, 1}));
  BOOST_TEST((found[1] == Contact{t, 0, -1}));
  BOOST_TEST((found[2] == Contact{t, 1, -1}));
}

BOOST_AUTO_TEST_CASE(lattices_with_regular_velocities_collide_all_at_once) {
  for (const double e : {1.0, 0.75}) {
    State rows, cross;
    for (int i = 0; i < 36; ++i) {
      const Vec2 r{(i % 6 + 0.5) / 8, (i / 6 + 0.5) / 8};
      rows.position.push_back(r);
      rows.velocity.push_back({(i % 6 + i / 6) % 2 == 0 ? -1.0 : 1.0, 0});
      cross.position.push_back(r);
      cross.velocity.push_back({i % 2 == 0 ? -1.0 : 1.0, i / 6 % 2 == 0 ? -1.0 : 1.0});
    }
    const auto in_rows = contacts_in_any_way(scene_of(36, e), rows, 2);
    BOOST_TEST(in_rows[14].time == in_rows[0].time);  // 3 + 2 pairs in two rows, three times
    contacts_in_any_way(scene_of(36, e), cross, 2);
  }
}

BOOST_AUTO_TEST_CASE(ties_at_the_end_of_an_interval_and_of_an_epoch_are_complete) {
  // Contacts happen up to and including the time asked for; stopping in the middle of a tie must not be possible.
  const State start{{{0.25, 0.5}, {0.5, 0.5}, {0.75, 0.5}}, {{1, 0}, {0, 0}, {-1, 0}}};
  const Scene scene = scene_of(3);
  Engine<> engine(scene, start);
  test::ContactLog log;
  engine.advance(0.1875, log);
  BOOST_TEST(log.contacts.size() == 3u);
  // The same when the tie falls on the end of an epoch: the gap is 3/16 and the epoch a power of two.
  const double epoch = Engine<>::epoch_length(scene);
  State scaled = start;
  for (Vec2& v : scaled.velocity) v = (0.1875 / epoch) * v;
  Engine<> slow(scene, scaled);
  test::ContactLog slow_log;
  slow.advance(epoch, slow_log);
  BOOST_TEST(slow_log.contacts.size() == 3u);
  BOOST_TEST(slow.at_epoch_start());
}

BOOST_AUTO_TEST_SUITE_END()
