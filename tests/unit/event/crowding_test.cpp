// Crowding: 1 in a gas, the ratio of densities where all disks are in one part, and no matter of order.
#include "gpf/event/crowding.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "gpf/base/random.hpp"

using namespace gpf;

namespace {

/// `count` points anywhere within the given part of a box of length 3 between y = 0.1 and 0.9.
std::vector<Flight> points(int count, double part_x, double part_y) {
  std::vector<Flight> flights;
  for (int i = 0; i < count; ++i) {
    const auto words = random_words(7, 3, static_cast<std::uint64_t>(i));
    flights.push_back({3 * part_x * words[0] * 0x1p-32, 0.1 + 0.8 * part_y * words[1] * 0x1p-32, 0, 0, 0});
  }
  return flights;
}
double crowding_of(const std::vector<Flight>& flights) { return crowding(flights, 3, 0.1, 0.9); }

}  // namespace

BOOST_AUTO_TEST_SUITE(crowding_of_disks)

BOOST_AUTO_TEST_CASE(points_without_structure_do_not_crowd) {
  BOOST_TEST(crowding_of(points(100'000, 1, 1)) == 1, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(disks_in_one_part_crowd_as_much_as_that_is_smaller_than_the_whole) {
  BOOST_TEST(crowding_of(points(100'000, 0.5, 1)) == 2, boost::test_tools::tolerance(0.02));
  BOOST_TEST(crowding_of(points(100'000, 0.2, 0.5)) == 10, boost::test_tools::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(where_most_disks_are_counts_most) {
  // 9 of 10 disks in a tenth of the box, nine times the mean density; the rest spread over the other nine tenths, a
  // ninth of it. Pairs there are 1 in 730.
  auto flights = points(90'000, 0.1, 1);
  for (Flight f : points(10'000, 0.9, 1)) f.x += 0.3, flights.push_back(f);
  BOOST_TEST(crowding_of(flights) == 9, boost::test_tools::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(the_order_of_disks_and_a_little_overshoot_do_not_matter) {
  auto flights = points(1000, 0.3, 1);
  const double before = crowding_of(flights);
  std::reverse(flights.begin(), flights.end());
  BOOST_TEST(crowding_of(flights) == before);
  for (Flight& f : flights)
    if (f.x < 1e-2) f.x = -1e-9;
  BOOST_TEST(crowding_of(flights) == before);
}

BOOST_AUTO_TEST_CASE(too_few_disks_to_share_a_box_do_not_crowd) {
  BOOST_TEST(crowding_of(points(1, 1, 1)) == 1);
  std::vector<Flight> apart(20);
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i].x = 3 * (static_cast<double>(i) + 0.5) / 20, apart[i].y = 0.5;
  BOOST_TEST(crowding_of(apart) < 1);
}

BOOST_AUTO_TEST_SUITE_END()
