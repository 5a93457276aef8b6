// A disk begins a flight and forgets whom it was to meet; what others know of it stays.
#include "gpf/event/disk.hpp"

#include <boost/test/unit_test.hpp>

namespace gpf {
namespace {

Disk meeting_somebody() {
  return {.flight = {1, 2, 3, 4, 5}, .contact = 6, .partner = 7, .partner_events = 8, .events = 9, .id = 10};
}

void require_nobody_to_meet(const Disk& disk) {
  BOOST_TEST(disk.contact == never);
  BOOST_TEST(disk.partner == -1);
  BOOST_TEST(disk.events == 9u);
  BOOST_TEST(disk.id == 10);
}

BOOST_AUTO_TEST_SUITE(disk)

BOOST_AUTO_TEST_CASE(a_flight_that_begins_knows_of_no_contact) {
  Disk disk = meeting_somebody();
  disk.begin({11, 12, 13, 14, 15});
  BOOST_TEST(disk.flight.x == 11);
  BOOST_TEST(disk.flight.y == 12);
  BOOST_TEST(disk.flight.vx == 13);
  BOOST_TEST(disk.flight.vy == 14);
  BOOST_TEST(disk.flight.time == 15);
  require_nobody_to_meet(disk);
}

BOOST_AUTO_TEST_CASE(forgetting_leaves_the_flight) {
  Disk disk = meeting_somebody();
  disk.forget();
  BOOST_TEST(disk.flight.x == 1);
  BOOST_TEST(disk.flight.vy == 4);
  BOOST_TEST(disk.flight.time == 5);
  require_nobody_to_meet(disk);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace gpf
