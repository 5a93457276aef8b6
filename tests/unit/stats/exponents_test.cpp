// Exact power laws give their exponent in every window; a curve that is none shows its bend.
#include "gpf/stats/exponents.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/error.hpp"

namespace {

using namespace gpf;
using Points = std::vector<std::vector<double>>;
const auto close = boost::test_tools::tolerance(1e-12);

template <class F>
Points of(const Points& x, F&& f) {
  Points y;
  for (const auto& replicas : x) {
    y.emplace_back();
    for (std::size_t r = 0; r < replicas.size(); ++r) y.back().push_back(f(replicas[r], r));
  }
  return y;
}

BOOST_AUTO_TEST_SUITE(exponents)

BOOST_AUTO_TEST_CASE(an_exact_power_law_gives_its_exponent_everywhere) {
  const Points x = {{0.4, 0.41}, {0.015, 0.014}, {0.05, 0.05}, {0.15, 0.16}, {0.3, 0.3}};  // in no order
  const Exponents fit =
      fit_exponents(x, of(x, [](double v, std::size_t r) { return std::pow(v, r == 0 ? -0.9 : -0.8); }));
  BOOST_TEST(fit.exponent == std::vector({-0.9, -0.8}), close << boost::test_tools::per_element());
  BOOST_TEST(fit.low_end[1] == -0.8, close);
  BOOST_TEST(fit.high_end[1] == -0.8, close);
  for (const double bend : fit.bend()) BOOST_TEST(std::abs(bend) < 1e-12);
  BOOST_TEST(fit.half_spread() < 1e-12);
  BOOST_TEST_REQUIRE(fit.windows.size() == 3u);
  BOOST_TEST(fit.lowest_x() == 0.0145, close);
  BOOST_TEST(fit.windows[1].highest_x == 0.3, close);
  BOOST_TEST(fit.windows[2].lowest_x == 0.05, close);
}

/// ln y = (ln x)^2/4, evenly bent: the slope at ln x = t is t/2, and that between two points their mean over 2.
BOOST_AUTO_TEST_CASE(a_curve_that_is_no_power_law_shows_its_bend) {
  Points x;
  for (int k = 0; k < 8; ++k) x.push_back({std::exp(k)});
  const Exponents fit =
      fit_exponents(x, of(x, [](double v, std::size_t) { return std::exp(std::pow(std::log(v), 2) / 4); }));
  BOOST_TEST(fit.exponent[0] == 1.75, close);  // at the middle, 3.5
  BOOST_TEST(fit.low_end[0] == 0.25, close);   // 0 and 1
  BOOST_TEST(fit.high_end[0] == 3.25, close);  // 6 and 7
  BOOST_TEST(fit.bend()[0] == 3.0, close);
  BOOST_TEST(fit.half_spread() == 0.5, close);  // windows about 2.5 and 4.5: 1.25 and 2.25
}

/// The parabola a t^2 over |t| <= L/2 departs by a L^2/8 from its best line; its slopes 2/3 L apart differ by 4/3 a L.
BOOST_AUTO_TEST_CASE(bend_of_a_departure) {
  const double a = 0.3, range = 5;
  BOOST_TEST(bend_of_departure(a * range * range / 8, 1, std::exp(range)) == 4.0 / 3 * a * range, close);
}

BOOST_AUTO_TEST_CASE(points_without_a_logarithm_are_refused) {
  const Points good = {{1}, {2}, {3}, {4}};
  BOOST_CHECK_NO_THROW(fit_exponents(good, good));
  BOOST_CHECK_THROW(fit_exponents(good, Points{{1}, {2}, {0}, {4}}), InputError);
  BOOST_CHECK_THROW(fit_exponents(good, Points{{1}, {2}, {std::numeric_limits<double>::quiet_NaN()}, {4}}), InputError);
  BOOST_CHECK_THROW(fit_exponents(good, Points{{1}, {2}, {3}}), InputError);
  BOOST_CHECK_THROW(fit_exponents(good, Points{{1}, {2, 3}, {3}, {4}}), InputError);
  BOOST_CHECK_THROW(fit_exponents(Points{{1}, {2}, {3}}, Points{{1}, {2}, {3}}), InputError);
  BOOST_CHECK_THROW(fit_exponents(Points{{}, {}, {}, {}}, Points{{}, {}, {}, {}}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
