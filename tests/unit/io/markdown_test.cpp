#include "gpf/io/markdown.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "gpf/base/error.hpp"

namespace {

using gpf::number_with_error;

BOOST_AUTO_TEST_SUITE(markdown)

BOOST_AUTO_TEST_CASE(table_is_aligned_by_characters_not_bytes) {
  BOOST_TEST(gpf::markdown_table({"claim", "\xce\xbd"}, {{"slip", "0.1 \xc2\xb1 0.2"}, {"long name"}}) ==
             "| claim     | \xce\xbd         |\n"
             "|-----------|-----------|\n"
             "| slip      | 0.1 \xc2\xb1 0.2 |\n"
             "| long name |           |\n");
}

BOOST_AUTO_TEST_CASE(cells_cannot_leave_their_cell) {
  BOOST_TEST(gpf::markdown_cell("a|b\nc\r\nd") == "a\\|b c  d");
  // In GitHub's tables \\| is an escaped backslash and a cell's end, so the backslashes before a pipe are doubled too.
  BOOST_TEST(gpf::markdown_cell("\\|") == "\\\\\\|");
  BOOST_TEST(gpf::markdown_cell("\\alpha") == "\\alpha");
  BOOST_TEST(gpf::markdown_table({"a|b"}, {}) == "| a\\|b |\n|------|\n");
}

BOOST_AUTO_TEST_CASE(row_wider_than_the_header_is_refused) {
  BOOST_CHECK_THROW(gpf::markdown_table({"a"}, {{"1", "2"}}), gpf::InputError);
}

BOOST_AUTO_TEST_CASE(value_is_given_to_the_second_digit_of_its_error) {
  BOOST_TEST(number_with_error(0.123456, 0.00562) == "0.1235 \xc2\xb1 0.0056");
  BOOST_TEST(number_with_error(-12.3456, 1.04) == "-12.3 \xc2\xb1 1.0");
  BOOST_TEST(number_with_error(3.00004, -0.05) == "3.000 \xc2\xb1 0.050");
  BOOST_TEST(number_with_error(123456, 789) == "123456 \xc2\xb1 789");
  BOOST_TEST(number_with_error(0, 0.25) == "0.00 \xc2\xb1 0.25");
}

BOOST_AUTO_TEST_CASE(rounding_that_carries_keeps_two_digits) {
  BOOST_TEST(number_with_error(1.23456, 0.0996) == "1.23 \xc2\xb1 0.10");
  BOOST_TEST(number_with_error(1.23456, 0.994) == "1.23 \xc2\xb1 0.99");
  BOOST_TEST(number_with_error(1.23456, 0.996) == "1.2 \xc2\xb1 1.0");
}

BOOST_AUTO_TEST_CASE(very_large_and_small_numbers_share_a_power_of_ten) {
  BOOST_TEST(number_with_error(1.2343e-7, 5.6e-9) == "(1.234 \xc2\xb1 0.056)e-07");
  BOOST_TEST(number_with_error(1.2e9, 3.4e10) == "(0.1 \xc2\xb1 3.4)e+10");
  BOOST_TEST(number_with_error(2e-4, 1e-4) == "0.00020 \xc2\xb1 0.00010");
}

BOOST_AUTO_TEST_CASE(errors_that_give_no_digits) {
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(number_with_error(0.5, 0) == "0.5 \xc2\xb1 0");
  BOOST_TEST(number_with_error(1. / 3, infinity) == "0.333333 \xc2\xb1 inf");
  BOOST_TEST(number_with_error(1. / 3, 1e-20) == "0.333333 \xc2\xb1 1e-20");
  BOOST_TEST(number_with_error(infinity, 1) == "inf \xc2\xb1 1");
  BOOST_TEST(number_with_error(0, 0) == "0 \xc2\xb1 0");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
