// Engines of either lane width in one program, as where a program compiled for its machine uses the library, which was
// compiled for all: the linker must not take a function of the one for the other's.
#include <boost/test/unit_test.hpp>

#include "lane_widths_trace.hpp"
#include "support/scenes.hpp"

using namespace gpf;

BOOST_AUTO_TEST_CASE(engines_of_two_lane_widths_live_in_one_program) {
  if (__builtin_cpu_supports("avx") == 0) {
    BOOST_TEST_MESSAGE("no AVX: nothing to compare");
    return;
  }
  for (const Scene& scene : {test::gas(200, 0.4), test::channel(200, 0.4, 15)}) {
    const test::LanesTrace two = test::trace_in_lanes_of_2(scene), four = test::trace_in_lanes_of_4(scene);
    BOOST_TEST(two.hash == four.hash);
    for (std::size_t i = 0; i < two.types.size(); ++i) BOOST_TEST(two.types[i] != four.types[i]);
    BOOST_TEST(two.function != four.function);
  }
}
