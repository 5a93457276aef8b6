#include "verify/estimators/onset.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace gpf;

BOOST_AUTO_TEST_SUITE(onset_of_a_curve)

BOOST_AUTO_TEST_CASE(it_is_linear_between_two_points) {
  BOOST_TEST(onset({1, 2, 4}, {0, 1, 5}, 2) == 2.5);
  BOOST_TEST(onset({1, 2, 4}, {0, 1, 5}, 5) == 4);
}

BOOST_AUTO_TEST_CASE(the_first_of_several_counts) { BOOST_TEST(onset({0, 1, 2, 3}, {0, 2, 0, 4}, 1) == 0.5); }

BOOST_AUTO_TEST_CASE(a_curve_above_from_the_start_begins_there) { BOOST_TEST(onset({3, 4}, {7, 8}, 1) == 3); }

BOOST_AUTO_TEST_CASE(a_curve_below_has_none) {
  BOOST_TEST(std::isnan(onset({1, 2}, {0, 1}, 2)));
  BOOST_TEST(std::isnan(onset({}, {}, 2)));
}

BOOST_AUTO_TEST_SUITE_END()
