// Lanes against doubles.
#include "gpf/event/lane.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

using namespace gpf;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

Lane filled(double even, double odd) {
  Lane lane{};
  for (int k = 0; k < lane_width; ++k) lane[k] = k % 2 == 0 ? even : odd;
  return lane;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double samples[] = {-1.5, -0.0, 0.0, 5e-324, 2.25, std::numeric_limits<double>::infinity(), not_a_number};

}  // namespace

BOOST_AUTO_TEST_SUITE(lane)

BOOST_AUTO_TEST_CASE(positive_part_is_that_of_each_double) {
  for (const double a : samples)
    for (const double b : samples) {
      const Lane result = positive_part(filled(a, b));
      for (int k = 0; k < lane_width; ++k) BOOST_TEST(same_bits(result[k], positive_part(k % 2 == 0 ? a : b)));
    }
  BOOST_TEST(positive_part(3.5) == 3.5);
  BOOST_TEST(positive_part(-3.5) == 0);
  BOOST_TEST(positive_part(not_a_number) == 0);
}

BOOST_AUTO_TEST_CASE(bits_has_a_bit_for_each_comparison_that_holds) {
  for (const double a : samples)
    for (const double b : samples) {
      unsigned expected = 0;
      for (int k = 0; k < lane_width; ++k) expected |= ((k % 2 == 0 ? a : b) < 1 ? 1u : 0u) << k;
      BOOST_TEST(bits(filled(a, b) < 1) == expected);
    }
  for (int k = 0; k < lane_width; ++k) {
    Lane one{};
    one[k] = -1;
    BOOST_TEST(bits(one < 0) == 1u << k);
  }
}

BOOST_AUTO_TEST_SUITE_END()
