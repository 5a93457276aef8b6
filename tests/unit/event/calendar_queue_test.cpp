// The calendar against an ordered set.
#include "gpf/event/calendar_queue.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "queue_model.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(calendar_queue)

BOOST_AUTO_TEST_CASE(follows_its_model_whatever_rate_of_events_it_expects) {
  // From one day for all events to a thousand days between two of 64 disks.
  for (const double events_per_time : {0.0, 1e-6, 1.0, 2000.0, 1e5})
    test::queue_follows_its_model<CalendarQueue>(events_per_time);
}

BOOST_AUTO_TEST_CASE(follows_its_model_with_many_disks_most_of_which_lie_in_sheaves) {
  test::QueueModel<CalendarQueue> model(60'000, 64, 20'000);
  for (Index i = 0; i < 60'000; ++i) model.schedule(i, 0.001 * i);
  model.run(20'000, 5, 2, 0);
}

BOOST_AUTO_TEST_CASE(without_disks_or_events_it_has_no_earliest) {
  test::queue_without_disks_or_events_has_no_earliest<CalendarQueue>();
}

BOOST_AUTO_TEST_CASE(forgets_what_lies_beyond_its_horizon) {
  test::queue_forgets_what_lies_beyond_its_horizon<CalendarQueue>();
}

BOOST_AUTO_TEST_CASE(takes_times_before_the_earliest_it_has_given) {
  test::queue_takes_times_before_the_earliest_it_has_given<CalendarQueue>();
}

BOOST_AUTO_TEST_CASE(lets_the_caller_order_equal_times) {
  test::queue_lets_the_caller_order_equal_times<CalendarQueue>();
}

BOOST_AUTO_TEST_CASE(is_empty_after_a_reset) { test::queue_is_empty_after_a_reset<CalendarQueue>(); }

BOOST_AUTO_TEST_CASE(names_each_event_once_some_events_before_it_comes) {
  // Disks with an event each, evenly spread, however wrong the guess of how many events a day has.
  constexpr Index count = 8000;
  for (const double events_per_day : {0.25, 1.0, 2.0}) {
    CalendarQueue queue;
    queue.reset(count, 1, count / events_per_day);
    for (Index i = 0; i < count; ++i) queue.schedule(i, (i + 0.5) / count);
    std::vector<int> named(count, 0);
    Index last = 0;
    const auto name = [&](Index i) {
      ++named[static_cast<std::size_t>(i)];
      last = std::max(last, i);
    };
    for (Index i = 0; i < count; ++i) {
      BOOST_REQUIRE(test::earliest(queue) == i);
      queue.foresee(name);
      BOOST_REQUIRE(named[static_cast<std::size_t>(i)] == 1);
      if (i > 2100 && i < count - 20) BOOST_REQUIRE((last - i >= 12 && last - i <= 15));
      queue.schedule(i, never);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
