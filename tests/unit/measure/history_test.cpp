#include "gpf/measure/history.hpp"

#include <boost/test/unit_test.hpp>

using namespace gpf;

BOOST_AUTO_TEST_SUITE(history)

BOOST_AUTO_TEST_CASE(moment_separates_flow_from_fluctuation) {
  // Two bins; the lower pair moves at 3 +- 1 along x, the upper at -2 with c_y = +-1.
  const State state{{{0.1, 0.2}, {0.2, 0.3}, {0.1, 0.7}, {0.2, 0.8}}, {{4, 0}, {2, 0}, {-2, 1}, {-2, -1}}};
  const Moment m = moment_of(state, 2);
  BOOST_TEST(m.energy == (16 + 4 + 5 + 5) / 8.0);
  BOOST_TEST(m.temperature == (1 + 1 + 1 + 1) / 8.0);
}

BOOST_AUTO_TEST_CASE(keeps_evenly_spaced_moments_in_bounded_memory) {
  History h;
  const State state{{{0.5, 0.5}}, {{1, 0}}};
  for (int k = 0; k < 10000; ++k) h.offer(k, state, 1);
  BOOST_TEST(h.time.size() < History::most_moments);
  BOOST_TEST(h.time.size() >= History::most_moments / 2);
  for (std::size_t k = 0; k < h.time.size(); ++k) BOOST_TEST(h.time[k] == static_cast<double>(k * h.stride));
}

BOOST_AUTO_TEST_SUITE_END()
