// Vectors on huge pages are vectors.
#include "gpf/event/huge_pages.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <numeric>
#include <vector>

using namespace gpf;

BOOST_AUTO_TEST_SUITE(huge_pages)

BOOST_AUTO_TEST_CASE(small_and_large_arrays_hold_what_is_put_in_them) {
  for (const std::size_t count : {1u, 1000u, 262143u, 262144u, 262145u, 1000000u}) {
    std::vector<double, HugePages<double>> values(count);
    std::iota(values.begin(), values.end(), 0.5);
    BOOST_TEST(values.front() == 0.5);
    BOOST_TEST(values.back() == static_cast<double>(count) - 0.5);
    const auto address = reinterpret_cast<std::uintptr_t>(values.data());
    BOOST_TEST(address %
                   (count * sizeof(double) >= HugePages<double>::page ? HugePages<double>::page : alignof(double)) ==
               0u);
    auto copy = values;
    values.push_back(-1);  // grows into another array, perhaps across the size of a page
    copy.swap(values);
    BOOST_TEST(copy.size() == count + 1);
    BOOST_TEST(copy[count / 2] == values[count / 2]);
  }
}

BOOST_AUTO_TEST_CASE(over_aligned_types_keep_their_alignment) {
  struct alignas(128) Wide {
    double x[16];
  };
  for (const std::size_t count : {1u, 3u, 100u, 20000u}) {
    const std::vector<Wide, HugePages<Wide>> values(count);
    BOOST_TEST(reinterpret_cast<std::uintptr_t>(values.data()) % 128 == 0u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
