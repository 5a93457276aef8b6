// Errors split into bias and noise.
#include "verify/methods/misfit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/random.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(misfit)

BOOST_AUTO_TEST_CASE(numbers_worked_out_by_hand) {
  // Means 11 and 10, variances 2 and 8/7 of 2 and 8 replicas.
  std::vector<std::vector<double>> reference;
  for (int k = 0; k < 8; ++k) reference.push_back({k % 2 == 0 ? 9.0 : 11.0});
  const Misfit m = misfit_of({{10}, {12}}, reference, false);
  const double error = 2.0 / 2 + 8.0 / 7 / 8;
  BOOST_TEST(m.noise == std::sqrt(2.0) / 10, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(m.resolution == std::sqrt(error) / 10, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(m.bias == 0);  // 1 is less than its error
  const Misfit far = misfit_of({{20}, {22}}, reference, true);
  BOOST_TEST(far.bias == std::sqrt(121 - error), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(far.total() == std::hypot(far.bias, far.noise));
  BOOST_TEST(far.bias_at_most() > far.bias);
}

BOOST_AUTO_TEST_CASE(bins_that_are_not_known_are_left_out) {
  const std::vector<std::vector<double>> reference{{1, NAN, 2}, {1, 5, 2}};
  BOOST_TEST(misfit_of({{1.1, 7, 2.2}}, reference, false).bias == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::isnan(misfit_of({{NAN, NAN, NAN}}, reference, false).bias));
  BOOST_TEST(std::isnan(misfit_of({{NAN, NAN, NAN}}, reference, true).noise));
}

BOOST_AUTO_TEST_CASE(a_known_bias_is_found_on_average) {
  // 18 bins of noise .05, bias .02 of the value, 4 runs against 8: over many trials the square of the bias is found.
  double squares = 0;
  constexpr int trials = 400;
  for (std::uint64_t t = 0; t < trials; ++t) {
    const auto draw = [t](std::uint64_t replica, double mean) {
      std::vector<double> values;
      for (std::uint64_t b = 0; b < 18; ++b) values.push_back(mean + 0.05 * gaussian_pair(100 * t + replica, b).x);
      return values;
    };
    std::vector<std::vector<double>> runs, reference;
    for (std::uint64_t r = 0; r < 4; ++r) runs.push_back(draw(r, 1.1));
    for (std::uint64_t r = 0; r < 8; ++r) reference.push_back(draw(50 + r, 1.0));
    const Misfit m = misfit_of(runs, reference, false);
    squares += m.bias * m.bias / trials;
  }
  // The mean of 400: (.1^2) +- 2 * .1 * .05 sqrt(3/8)/sqrt(18 * 400).
  BOOST_TEST(std::abs(squares - 0.01) < 4 * 7.3e-5);
}

BOOST_AUTO_TEST_SUITE_END()
