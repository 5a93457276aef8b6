// Lines and power laws: exact data, known covariance, ensembles, and data that bend.
#include "gpf/stats/fit.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/error.hpp"
#include "synthetic.hpp"

namespace {

using namespace gpf;
using Numbers = std::vector<double>;
using Points = std::vector<Estimate>;

BOOST_AUTO_TEST_SUITE(fit)

BOOST_AUTO_TEST_CASE(exact_line) {
  const Numbers x = {-1, 0, 2, 5};
  Points y;
  for (const double v : x) y.push_back({3 - 0.5 * v, 0.1 + v * v});
  const LineFit f = fit_line(x, y);
  BOOST_TEST(f.intercept == 3.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f.slope == -0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f.chi2 < 1e-20);
  BOOST_TEST(f.degrees_of_freedom == 2u);
}

BOOST_AUTO_TEST_CASE(covariance_by_hand) {
  // Equal errors s = .2 at x = 0, 1, 2, 3: Sxx = 5, mean 1.5. var slope = s^2/5, var intercept = s^2 (1/4 + 2.25/5),
  // covariance = -1.5 s^2/5.
  const LineFit f = fit_line(Numbers{0, 1, 2, 3}, Points{{1, 0.2}, {2, 0.2}, {2, 0.2}, {4, 0.2}});
  BOOST_TEST(f.slope == 0.9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f.var_slope == 0.04 / 5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f.var_intercept == 0.04 * 0.7, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f.covariance == -0.04 * 0.3, boost::test_tools::tolerance(1e-12));
  // Residuals .1, .2, -.7, .4 over .2.
  BOOST_TEST(f.chi2 == 0.7 / 0.04, boost::test_tools::tolerance(1e-12));
  // At the mean of x the error is s/2.
  BOOST_TEST(f.at(1.5).mean == 2.25, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f.at(1.5).error == 0.1, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(line_ensemble) {
  // 2000 fits: the slope's and the line's z have mean square 1 +- .032, chi2 with 6 degrees of freedom 6 +- .077; 4 of
  // each.
  const Numbers x = {0, 1, 2, 3, 4, 5, 6, 7};
  double slope = 0, at_ten = 0, chi2 = 0;
  for (std::uint64_t key = 0; key < 2000; ++key) {
    const Numbers g = synthetic::white(key, x.size());
    Points y;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double error = 0.5 + 0.2 * x[k];
      y.push_back({2 + 0.7 * x[k] + error * g[k], error});
    }
    const LineFit f = fit_line(x, y);
    slope += std::pow(f.slope - 0.7, 2) / f.var_slope / 2000;
    at_ten += std::pow((f.at(10).mean - 9) / f.at(10).error, 2) / 2000;
    chi2 += f.chi2 / 2000;
  }
  BOOST_TEST(std::abs(slope - 1) < 4 * 0.032);
  BOOST_TEST(std::abs(at_ten - 1) < 4 * 0.032);
  BOOST_TEST(std::abs(chi2 - 6) < 4 * 0.077);
}

BOOST_AUTO_TEST_CASE(exact_power_law_in_any_order) {
  const Numbers x = {0.3, 0.02, 0.15, 0.05, 0.4, 0.1};
  Points y;
  for (const double v : x) y.push_back({1.7 * std::pow(v, -0.91), 0.01});
  const PowerLaw p = fit_power_law(x, y);
  BOOST_TEST(p.exponent.mean == -0.91, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(std::exp(p.log_prefactor) == 1.7, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(p.low_end.mean == -0.91, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(p.high_end.mean == -0.91, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(std::abs(p.bend_z()) < 1e-6);
  BOOST_TEST(p.degrees_of_freedom == 4u);
}

BOOST_AUTO_TEST_CASE(ends_are_the_thirds) {
  // Exponent 1 below x = 1 and 2 above: three points on each side of nine lie wholly on one branch.
  Numbers x;
  Points y;
  for (int k = -4; k <= 4; ++k) {
    const double v = std::pow(2.0, k);
    x.push_back(v);
    y.push_back({k < 0 ? v : v * v, 0.01 * v});
  }
  const PowerLaw p = fit_power_law(x, y);
  BOOST_TEST(p.low_end.mean == 1.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(p.high_end.mean == 2.0, boost::test_tools::tolerance(1e-9));
  // Relative errors .01 (below) and .01/v (above), ln 2 apart: the slope of the low end has error .01/(sqrt 2 ln 2).
  BOOST_TEST(p.low_end.error == 0.01 / (std::sqrt(2.0) * std::log(2.0)), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(p.bend_z() > 50);
}

BOOST_AUTO_TEST_CASE(power_law_ensemble) {
  // Relative errors of 2 %: ln y is biased by -.0002, far below its error. z^2 of the exponent and of the bend: 1 +-
  // .045 over 1000 fits; 4 of each.
  const Numbers x = {0.015, 0.03, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4};
  double exponent = 0, bend = 0;
  for (std::uint64_t key = 0; key < 1000; ++key) {
    const Numbers g = synthetic::white(key + 5000, x.size());
    Points y;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double exact = 0.4 * std::pow(x[k], -0.9);
      y.push_back({exact * (1 + 0.02 * g[k]), exact * 0.02});
    }
    const PowerLaw p = fit_power_law(x, y);
    exponent += std::pow((p.exponent.mean + 0.9) / p.exponent.error, 2) / 1000;
    bend += std::pow(p.bend_z(), 2) / 1000;
  }
  BOOST_TEST(std::abs(exponent - 1) < 4 * 0.045);
  BOOST_TEST(std::abs(bend - 1) < 4 * 0.045);
}

BOOST_AUTO_TEST_CASE(refusals) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(fit_line(Numbers{1, 2}, Points{{1, 1}}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{2, 2}, Points{{1, 1}, {2, 1}}), InputError);
  BOOST_CHECK_THROW(fit_line({}, {}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{1, 2}, Points{{1, 1}, {2, 0}}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{1, 2}, Points{{1, 1}, {nan, 1}}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{1, nan}, Points{{1, 1}, {2, 1}}), InputError);
  const Points four(4, Estimate{1, 0.1});
  BOOST_CHECK_THROW(fit_power_law(Numbers{1, 2, 3}, Points(3, Estimate{1, 0.1})), InputError);
  BOOST_CHECK_THROW(fit_power_law(Numbers{0, 1, 2, 3}, four), InputError);
  BOOST_CHECK_THROW(fit_power_law(Numbers{1, 2, 3, 4}, Points{{1, 1}, {1, 1}, {-1, 1}, {1, 1}}), InputError);
  BOOST_CHECK_THROW(fit_power_law(Numbers{nan, 2, 3, 4}, four), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
