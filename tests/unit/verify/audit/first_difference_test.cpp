#include "verify/audit/first_difference.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace gpf;

namespace {

using How = EventDifference::Kind;

const std::vector<TracedContact> run{{0.25, 1, 2, {1, 0, -1, 0.5}},
                                     {0.5, 3, -1, {0.25, 0.125, 0, 0}},
                                     {0.75, 1, 4, {0.5, 0, 0, 1}},
                                     {0.875, 2, 5, {0, 2, 0, 1}}};
constexpr double epoch_length = 1;

}  // namespace

BOOST_AUTO_TEST_SUITE(first_differences)

BOOST_AUTO_TEST_CASE(equal_events_in_any_order_of_execution_do_not_differ) {
  auto other = run;
  std::swap(other[1], other[2]);
  BOOST_TEST(!first_differing(run, other, epoch_length).has_value());
}

BOOST_AUTO_TEST_CASE(the_last_bit_of_a_time_is_one_unit_of_the_epoch_or_less) {
  auto other = run;
  other[2].time = std::nextafter(0.75, 1);
  const auto found = first_differing(run, other, epoch_length);
  BOOST_REQUIRE(found.has_value());
  BOOST_CHECK(found->kind == How::numbers);
  BOOST_TEST(found->event == 3U);
  BOOST_REQUIRE(found->numbers.size() == 1U);
  BOOST_TEST(found->numbers[0].name == "time in the epoch");
  BOOST_TEST(found->largest_ulps == 0.5);
  BOOST_TEST(found->numbers[0].relative == 0x1p-53 / 0.75);
}

BOOST_AUTO_TEST_CASE(a_velocity_differs_in_units_of_the_largest_of_its_event) {
  auto other = run;
  other[0].velocity[1] = 0x1p-52;
  const auto found = first_differing(run, other, epoch_length);
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(found->event == 1U);
  BOOST_TEST(found->numbers.at(0).name == "v_y of disk 1");
  BOOST_TEST(found->largest_ulps == 1.0);
  BOOST_TEST(std::isinf(found->numbers.at(0).relative));
}

BOOST_AUTO_TEST_CASE(a_wall_rule_that_is_off_shows_at_the_wall) {
  auto other = run;
  other[1].velocity[0] *= 1.005;
  const auto found = first_differing(run, other, epoch_length);
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(partners_text(found->before) == "disk 3 and the lower wall");
  BOOST_TEST(found->largest_ulps > 1e12);
}

BOOST_AUTO_TEST_CASE(two_events_that_change_places_are_an_exchange) {
  auto before = run, after = run;
  before[2].time = 0.875 - 0x1p-53;
  after[2].time = std::nextafter(0.875, 1);
  const auto found = first_differing(before, after, epoch_length);
  BOOST_REQUIRE(found.has_value());
  BOOST_CHECK(found->kind == How::exchange);
  BOOST_TEST(partners_text(found->before) == "disks 1 and 4");
  BOOST_TEST(partners_text(found->after) == "disks 2 and 5");
  BOOST_TEST(found->largest_ulps < 2);
}

BOOST_AUTO_TEST_CASE(other_partners_and_a_missing_event_have_no_counterpart) {
  auto other = run;
  other[2].second = 7;
  auto found = first_differing(run, other, epoch_length);
  BOOST_REQUIRE(found.has_value());
  BOOST_CHECK(found->kind == How::partners);
  BOOST_TEST(std::isinf(found->largest_ulps));
  other = run;
  other.pop_back();
  found = first_differing(run, other, epoch_length);
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(found->event == 4U);
  BOOST_CHECK(found->kind == How::partners);
  BOOST_TEST(std::isinf(found->largest_ulps));
}

BOOST_AUTO_TEST_CASE(the_first_mark_that_differs_in_anything) {
  const std::vector<EpochMark> marks{{0, 0, 0, 1}, {1, 10, 5, 2}, {2, 20, 9, 3}};
  auto other = marks;
  BOOST_TEST(!first_differing(marks, other).has_value());
  other[2].trace_hash = 21;
  BOOST_TEST(first_differing(marks, other).value() == 2U);
  other[1].state_hash = 9;
  BOOST_TEST(first_differing(marks, other).value() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()
