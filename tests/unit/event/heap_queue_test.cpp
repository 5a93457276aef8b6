// The implicit heap against an ordered set.
#include "gpf/event/heap_queue.hpp"

#include <boost/test/unit_test.hpp>

#include "queue_model.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(heap_queue)

BOOST_AUTO_TEST_CASE(follows_its_model) { test::queue_follows_its_model<HeapQueue>(1); }

BOOST_AUTO_TEST_CASE(without_disks_or_events_it_has_no_earliest) {
  test::queue_without_disks_or_events_has_no_earliest<HeapQueue>();
}

BOOST_AUTO_TEST_CASE(forgets_what_lies_beyond_its_horizon) {
  test::queue_forgets_what_lies_beyond_its_horizon<HeapQueue>();
}

BOOST_AUTO_TEST_CASE(takes_times_before_the_earliest_it_has_given) {
  test::queue_takes_times_before_the_earliest_it_has_given<HeapQueue>();
}

BOOST_AUTO_TEST_CASE(lets_the_caller_order_equal_times) { test::queue_lets_the_caller_order_equal_times<HeapQueue>(); }

BOOST_AUTO_TEST_CASE(is_empty_after_a_reset) { test::queue_is_empty_after_a_reset<HeapQueue>(); }

BOOST_AUTO_TEST_SUITE_END()
