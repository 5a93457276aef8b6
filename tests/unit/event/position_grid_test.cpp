// The grid of positions: nearest, symmetric, idempotent, and exact under differences and shifts.
#include "gpf/event/position_grid.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/random.hpp"

using namespace gpf;

namespace {

constexpr double lengths[] = {0.0371, 0.5, 0.9999, 1, 1.0000000001, 1.3, 4, 14.7, 1024, 3000.123};

/// Anything between -4 and 4 sides of the box.
double coordinate(double side, std::uint64_t index) { return side * std::fmod(gaussian_pair(7, index).x, 4.0); }

}  // namespace

BOOST_AUTO_TEST_SUITE(position_grid)

BOOST_AUTO_TEST_CASE(quantum_is_two_to_the_minus_52_of_the_power_of_two_above_the_longest_side) {
  BOOST_TEST(PositionGrid(1, 1).quantum() == 0x1p-52);
  BOOST_TEST(PositionGrid(0.3, 1).quantum() == 0x1p-52);
  BOOST_TEST(PositionGrid(1.3, 1).quantum() == 0x1p-51);
  BOOST_TEST(PositionGrid(1, 2).quantum() == 0x1p-51);
  BOOST_TEST(PositionGrid(2.0000001, 1).quantum() == 0x1p-50);
}

BOOST_AUTO_TEST_CASE(rounds_to_the_nearest_multiple_symmetrically_and_once) {
  for (const double length : lengths) {
    const PositionGrid grid(length, 1);
    for (std::uint64_t k = 0; k < 1000; ++k) {
      const double a = coordinate(std::max(length, 1.0), k), r = grid.round(a);
      BOOST_TEST(std::abs(r - a) <= grid.quantum() / 2);
      BOOST_TEST(std::fmod(r, grid.quantum()) == 0);
      BOOST_TEST(grid.round(r) == r);
      BOOST_TEST(grid.round(-a) == -r);
    }
  }
}

BOOST_AUTO_TEST_CASE(halves_go_to_the_even_multiple) {
  const PositionGrid grid(1, 1);
  const double q = grid.quantum();
  BOOST_TEST(grid.round(0.5 * q) == 0);
  BOOST_TEST(grid.round(1.5 * q) == 2 * q);
  BOOST_TEST(grid.round(-2.5 * q) == -2 * q);
}

BOOST_AUTO_TEST_CASE(differences_shifts_and_reflections_are_exact_to_twice_the_longest_side) {
  // A double holds multiples of q up to 2^53 q, and 2^53 q is twice the power of two above the longest side.
  for (const double length : lengths) {
    const PositionGrid grid(length, 1);
    const double period = grid.round(length), far = 0x1p53 * grid.quantum();
    BOOST_TEST(far >= 2 * std::max(period, 1.0));
    for (std::uint64_t k = 0; k < 1000; ++k) {
      const double a = grid.round(0.25 * coordinate(std::max(length, 1.0), k));  // to one side on either side of zero
      const double b = grid.round(0.25 * coordinate(std::max(length, 1.0), k + 1000));
      for (const double shift : {period, 1.0}) {
        BOOST_TEST((a + shift) - shift == a);
        BOOST_TEST((a - shift) + shift == a);
        if (std::abs(b - a) <= shift) BOOST_TEST((b - (a + shift)) == (b - a) - shift);
        BOOST_TEST(((b - shift) - (a - shift)) == b - a);
        BOOST_TEST((shift - a) - (shift - b) == b - a);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
