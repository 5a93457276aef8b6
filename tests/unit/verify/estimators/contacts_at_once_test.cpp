#include "verify/estimators/contacts_at_once.hpp"

#include <boost/test/unit_test.hpp>

using namespace gpf;

namespace {

PairContact pair_at(double time, std::int32_t first, std::int32_t second) {
  PairContact c{};
  c.time = time, c.first = first, c.second = second;
  return c;
}

ContactsAtOnce watcher() {
  Scene scene;
  scene.particles = 4;
  return ContactsAtOnce(scene);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(contacts_at_once)

BOOST_AUTO_TEST_CASE(either_disk_may_have_met_another_at_that_time) {
  ContactsAtOnce seen = watcher();
  seen.on_pair(pair_at(1, 0, 1));
  seen.on_pair(pair_at(1, 1, 2));
  seen.on_pair(pair_at(1, 2, 3));
  BOOST_TEST(seen.count() == 2);
}

BOOST_AUTO_TEST_CASE(other_disks_at_the_same_time_and_later_contacts_do_not_count) {
  ContactsAtOnce seen = watcher();
  seen.on_pair(pair_at(1, 0, 1));
  seen.on_pair(pair_at(1, 2, 3));
  seen.on_pair(pair_at(1 + 0x1p-52, 0, 1));
  BOOST_TEST(seen.count() == 0);
}

BOOST_AUTO_TEST_CASE(a_wall_is_a_contact_too) {
  ContactsAtOnce seen = watcher();
  WallContact wall{};
  wall.time = 2, wall.disk = 3;
  seen.on_wall(wall);
  seen.on_pair(pair_at(2, 1, 3));
  BOOST_TEST(seen.count() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
