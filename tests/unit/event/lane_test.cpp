// Lanes against doubles.
#include "gpf/event/lane.hpp"

#include <array>
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
  for (unsigned k = 0; k < lane_width; ++k) lane[k] = k % 2 == 0 ? even : odd;
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
      for (unsigned k = 0; k < lane_width; ++k) BOOST_TEST(same_bits(result[k], positive_part(k % 2 == 0 ? a : b)));
    }
  BOOST_TEST(positive_part(3.5) == 3.5);
  BOOST_TEST(positive_part(-3.5) == 0);
  BOOST_TEST(positive_part(not_a_number) == 0);
}

BOOST_AUTO_TEST_CASE(bits_has_a_bit_for_each_comparison_that_holds) {
  for (const double a : samples)
    for (const double b : samples) {
      unsigned expected = 0;
      for (unsigned k = 0; k < lane_width; ++k) expected |= ((k % 2 == 0 ? a : b) < 1 ? 1u : 0u) << k;
      BOOST_TEST(bits(filled(a, b) < 1) == expected);
    }
  for (unsigned k = 0; k < lane_width; ++k) {
    Lane one{};
    one[k] = -1;
    BOOST_TEST(bits(one < 0) == 1u << k);
  }
}

BOOST_AUTO_TEST_CASE(later_and_square_root_are_those_of_each_double) {
  for (const double a : samples)
    for (const double b : samples)
      for (const double c : samples) {
        const Lane later_of = later(c, filled(a, b)), root = square_root(filled(a, b));
        for (unsigned k = 0; k < lane_width; ++k) {
          const double each = k % 2 == 0 ? a : b;
          BOOST_TEST(same_bits(later_of[k], later(c, each)));
          BOOST_TEST((same_bits(root[k], square_root(each)) || (std::isnan(root[k]) && std::isnan(square_root(each)))));
        }
      }
  BOOST_TEST(later(1, 2) == 2);
  BOOST_TEST(later(2, 1) == 2);
}

BOOST_AUTO_TEST_CASE(abreast_puts_each_disk_in_its_place) {
  std::array<Disk, lane_width> disks;
  double number = 0;
  for (Disk& d : disks) {
    for (double* value : {&d.flight.x, &d.flight.y, &d.flight.vx, &d.flight.vy, &d.flight.time, &d.contact})
      *value = ++number;
    d.partner = d.id = 77;
  }
  const Abreast all = abreast([&](unsigned k) -> const Disk& { return disks[k]; });
  for (unsigned k = 0; k < lane_width; ++k) {
    const Flight& f = disks[k].flight;
    BOOST_TEST((all.flight.x[k] == f.x && all.flight.y[k] == f.y && all.flight.vx[k] == f.vx));
    BOOST_TEST((all.flight.vy[k] == f.vy && all.flight.time[k] == f.time && all.contact[k] == disks[k].contact));
  }
}

BOOST_AUTO_TEST_CASE(columns_are_read_from_any_address) {
  std::array<double, 2 * lane_width + 1> numbers;
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<double>(k);
  const auto [first, second] = columns([&](unsigned k) { return &numbers[2 * (lane_width - 1 - k) + 1]; });
  for (unsigned k = 0; k < lane_width; ++k) {
    const double expected = 2 * (lane_width - 1 - k) + 1;
    BOOST_TEST((first[k] == expected && second[k] == expected + 1));
  }
}

BOOST_AUTO_TEST_CASE(alike_changes_no_bit) {
  for (const double a : samples)
    for (unsigned k = 0; k < lane_width; ++k) BOOST_TEST((same_bits(alike(a)[k], a) || std::isnan(a)));
}

BOOST_AUTO_TEST_SUITE_END()
