#include "verify/estimators/collapse_boundary.hpp"

#include <boost/test/unit_test.hpp>

using namespace gpf;

BOOST_AUTO_TEST_SUITE(collapse_boundary_of_runs)

BOOST_AUTO_TEST_CASE(it_lies_between_the_last_run_that_collapses_and_the_first_that_does_not) {
  BOOST_TEST(collapse_boundary(0.1, 0.1, {true, true, false, false}) == 0.25, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(collapse_boundary(0.1, 0.1, {false, false}) == 0.05, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(collapse_boundary(0.1, 0.1, {true, true}) == 0.25, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(of_runs_out_of_order_it_is_the_mean) {
  BOOST_TEST(collapse_boundary(0.3, 0.2, {true, false, true, false}) ==
             collapse_boundary(0.3, 0.2, {true, true, false, false}));
}

BOOST_AUTO_TEST_SUITE_END()
