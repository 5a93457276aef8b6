// The weighted mean by hand, and its error and chi square in an ensemble.
#include "gpf/stats/combine.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/error.hpp"
#include "synthetic.hpp"

namespace {

using namespace gpf;

BOOST_AUTO_TEST_SUITE(combine)

BOOST_AUTO_TEST_CASE(by_hand) {
  // Weights 1 and 1/4: (10 + 14/4)/(5/4) = 10.8, error 1/sqrt(1.25), chi2 = .8^2 + (3.2/2)^2.
  const Combination c = weighted_mean(std::vector<Estimate>{{10, 1}, {14, 2}});
  BOOST_TEST(c.value.mean == 10.8, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(c.value.error == 1 / std::sqrt(1.25), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(c.chi2 == 0.64 + 2.56, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(c.degrees_of_freedom == 1u);
}

BOOST_AUTO_TEST_CASE(one_estimate_is_itself) {
  const Combination c = weighted_mean(std::vector<Estimate>{{-3, 0.25}});
  BOOST_TEST(c.value.mean == -3.0);
  BOOST_TEST(c.value.error == 0.25);
  BOOST_TEST(c.chi2 == 0.0);
  BOOST_TEST(c.degrees_of_freedom == 0u);
}

BOOST_AUTO_TEST_CASE(ensemble) {
  // 2000 combinations of 5 with errors 1 ... 5. The mean of z^2 is 1 +- sqrt(2/2000) = .032, that of chi2 4 +-
  // sqrt(8/2000) = .063; 4 of each.
  double z2 = 0, chi2 = 0;
  for (std::uint64_t key = 0; key < 2000; ++key) {
    const std::vector<double> g = synthetic::white(key, 5);
    std::vector<Estimate> estimates;
    for (std::size_t k = 0; k < g.size(); ++k) {
      const double error = 1.0 + static_cast<double>(k);
      estimates.push_back({2.5 + error * g[k], error});
    }
    const Combination c = weighted_mean(estimates);
    z2 += std::pow((c.value.mean - 2.5) / c.value.error, 2) / 2000;
    chi2 += c.chi2 / 2000;
  }
  BOOST_TEST(std::abs(z2 - 1) < 4 * 0.032);
  BOOST_TEST(std::abs(chi2 - 4) < 4 * 0.063);
}

BOOST_AUTO_TEST_CASE(refuses_what_has_no_weight) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(weighted_mean({}), InputError);
  BOOST_CHECK_THROW(weighted_mean(std::vector<Estimate>{{1, 0}}), InputError);
  BOOST_CHECK_THROW(weighted_mean(std::vector<Estimate>{{1, 1}, {1, nan}}), InputError);
  BOOST_CHECK_THROW(weighted_mean(std::vector<Estimate>{{nan, 1}}), InputError);
  BOOST_CHECK_THROW(weighted_mean(std::vector<Estimate>{{1, -1}}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
