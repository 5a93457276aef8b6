// Lines: exact data, known covariance, ensembles.
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

BOOST_AUTO_TEST_CASE(refusals) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(fit_line(Numbers{1, 2}, Points{{1, 1}}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{2, 2}, Points{{1, 1}, {2, 1}}), InputError);
  BOOST_CHECK_THROW(fit_line({}, {}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{1, 2}, Points{{1, 1}, {2, 0}}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{1, 2}, Points{{1, 1}, {nan, 1}}), InputError);
  BOOST_CHECK_THROW(fit_line(Numbers{1, nan}, Points{{1, 1}, {2, 1}}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
