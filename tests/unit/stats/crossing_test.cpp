// Fieller's interval: by hand, its coverage, and what it refuses.
#include "gpf/stats/crossing.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "gpf/base/error.hpp"
#include "synthetic.hpp"

namespace {

using namespace gpf;

BOOST_AUTO_TEST_SUITE(crossings)

BOOST_AUTO_TEST_CASE(two_points_by_hand) {
  // y(-1) = 1 and y(1) = -1, errors s: line -x, var_intercept = var_slope = s^2/2, no covariance.
  // x^2 (1 - q^2 s^2/2) = q^2 s^2/2: with q = 2, s = .5, x^2 = 1.
  const LineFit line = fit_line(std::vector<double>{-1, 1}, std::vector<Estimate>{{1, 0.5}, {-1, 0.5}});
  const Crossing crossing = zero_crossing(line, 2);
  BOOST_TEST(std::abs(crossing.at) < 1e-15);
  BOOST_TEST(crossing.bounded());
  BOOST_TEST(crossing.interval.lo == -1.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(crossing.interval.hi == 1.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_interval_leans_towards_the_uncertain_end) {
  const LineFit line = fit_line(std::vector<double>{0, 1}, std::vector<Estimate>{{1, 0.01}, {-1, 0.3}});
  const Crossing crossing = zero_crossing(line, 2);
  BOOST_TEST(crossing.at == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(crossing.interval.hi - 0.5 > 1.5 * (0.5 - crossing.interval.lo));
}

BOOST_AUTO_TEST_CASE(a_slope_that_may_be_zero_bounds_nothing) {
  const LineFit line = fit_line(std::vector<double>{-1, 1}, std::vector<Estimate>{{1, 1}, {-1, 1}});
  BOOST_TEST(zero_crossing(line, 1.4).bounded());  // slope -1 +- .71
  BOOST_TEST(!zero_crossing(line, 1.5).bounded());
}

BOOST_AUTO_TEST_CASE(coverage) {
  // Slope 5 errors from zero, 2000 lines: 95 % of the intervals hold the true zero, +- .5 % (one standard error).
  const std::vector<double> x = {0, 1, 2, 3};
  int held = 0;
  for (std::uint64_t key = 0; key < 2000; ++key) {
    const std::vector<double> noise = synthetic::white(key + 9000, x.size());
    std::vector<Estimate> y;
    for (std::size_t k = 0; k < x.size(); ++k) y.push_back({1.3 - x[k] + 0.45 * noise[k], 0.45});
    held += zero_crossing(fit_line(x, y), 1.959964).interval.contains(1.3);
  }
  BOOST_TEST(std::abs(held / 2000.0 - 0.95) < 4 * 0.005);
}

BOOST_AUTO_TEST_CASE(refusals) {
  BOOST_CHECK_THROW(zero_crossing(LineFit{1, 0, 1, 0, 1, 0, 0}, 2), InputError);
  BOOST_CHECK_THROW(zero_crossing(LineFit{1, 1, 1, 0, 1, 0, 0}, 0), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
