#include "gpf/measure/bins.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

using gpf::Bins;

namespace {

std::vector<double> shared(const Bins& bins, double from, double to, bool wrap) {
  std::vector<double> fractions(static_cast<std::size_t>(bins.count()), 0);
  bins.share(from, to, wrap, [&](int bin, double f) { fractions[static_cast<std::size_t>(bin)] += f; });
  return fractions;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bins)

BOOST_AUTO_TEST_CASE(heights_outside_belong_to_the_outermost_bins) {
  const Bins b(18);
  BOOST_TEST(b.at(-0.01) == 0);
  BOOST_TEST(b.at(0.0) == 0);
  BOOST_TEST(b.at(0.999999) == 17);
  BOOST_TEST(b.at(1.01) == 17);
  BOOST_TEST(b.at(b.centre(7)) == 7);
}

BOOST_AUTO_TEST_CASE(a_line_is_shared_by_the_length_inside_each_bin) {
  const auto f = shared(Bins(4), 0.2, 0.6, false);  // bins of 0.25: .05, .25, .10 of .4
  BOOST_TEST(f[0] == 0.125, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(f[1] == 0.625, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(f[2] == 0.25, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(f[3] == 0);
  BOOST_TEST(shared(Bins(4), 0.6, 0.2, false) == f);  // direction does not matter
}

BOOST_AUTO_TEST_CASE(a_horizontal_line_lies_in_one_bin) {
  BOOST_TEST(shared(Bins(4), 0.3, 0.3, false) == (std::vector<double>{0, 1, 0, 0}));
}

BOOST_AUTO_TEST_CASE(a_periodic_line_goes_on_at_the_other_side) {
  const auto down = shared(Bins(10), 0.05, -0.05, true);
  BOOST_TEST(down[0] == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(down[9] == 0.5, boost::test_tools::tolerance(1e-12));
  const auto up = shared(Bins(10), 0.98, 1.06, true);
  BOOST_TEST(up[9] == 0.25, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(up[0] == 0.75, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(fractions_add_up_to_one_wherever_the_line_lies) {
  for (const bool wrap : {false, true})
    for (int k = 0; k < 1000; ++k) {
      const double from = 0.001 * k, length = 0.13 * std::sin(0.7 * k);
      const double to = wrap ? from + length : std::fmin(1, std::fmax(0, from + length));
      double sum = 0;
      for (const double f : shared(Bins(7), from, to, wrap)) sum += f;
      BOOST_TEST(sum == 1,
                 boost::test_tools::tolerance(1e-10));  // (b - a)/extent: extents down to 1e-4 lose four digits
    }
}

BOOST_AUTO_TEST_SUITE_END()
