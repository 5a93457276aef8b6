#include "gpf/measure/block_series.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "gpf/base/error.hpp"

using gpf::BlockSeries;

BOOST_AUTO_TEST_SUITE(block_series)

BOOST_AUTO_TEST_CASE(blocks_merge_and_lose_nothing) {
  BlockSeries series(2);
  const std::size_t intervals = 1000;
  for (std::size_t k = 0; k < intervals; ++k) series.add(std::vector<double>{1, static_cast<double>(k)});
  // 256 blocks of one become 128 of two at the 256th, and so on: 1000 intervals give blocks of 4.
  BOOST_TEST(series.intervals_per_block() == 4u);
  BOOST_TEST(series.blocks() == 250u);
  for (std::size_t b = 0; b < series.blocks(); ++b) {
    BOOST_TEST(series.sums()[2 * b] == 4);
    BOOST_TEST(series.sums()[2 * b + 1] == 16.0 * static_cast<double>(b) + 6);  // 4b + (4b+1) + (4b+2) + (4b+3)
  }
}

BOOST_AUTO_TEST_CASE(never_more_than_the_limit_of_blocks) {
  BlockSeries series(1);
  for (int k = 0; k < 5000; ++k) {
    series.add(std::vector<double>{1});
    BOOST_TEST(series.blocks() < BlockSeries::most_blocks);
  }
}

BOOST_AUTO_TEST_CASE(a_restored_series_goes_on_as_if_nothing_had_happened) {
  BlockSeries whole(1), first(1), second(1);
  for (int k = 0; k < 777; ++k) {
    whole.add(std::vector<double>{0.1 * k});
    (k < 301 ? first : second).add(std::vector<double>{0.1 * k});
    if (k == 300) second.restore(first.memory());
  }
  BOOST_TEST(std::vector<double>(whole.sums().begin(), whole.sums().end()) ==
             std::vector<double>(second.sums().begin(), second.sums().end()));
}

BOOST_AUTO_TEST_CASE(memory_of_other_tallies_is_refused) {
  BlockSeries two(2), three(3);
  BOOST_CHECK_THROW(three.restore(two.memory()), gpf::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
