// Stationarity and relative misfit: known answers, and their behaviour under the null hypothesis.
#include "gpf/stats/compare.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/stats/blocks.hpp"
#include "synthetic.hpp"

namespace {

using namespace gpf;

BOOST_AUTO_TEST_SUITE(compare)

BOOST_AUTO_TEST_CASE(stationary_series_pass) {
  // z is about Student's t: for 400 correlated series (correlation time 3, 2048 values, some 50 blocks a half) |z| > 3
  // is expected for .3 % (t_50: .4 %), errors 6 % low make it .6 %: 2.4. Ten or more has probability below 1e-3.
  int alarms = 0;
  for (std::uint64_t key = 0; key < 400; ++key) {
    alarms += std::abs(stationarity_z(synthetic::autoregressive(key, 2048, std::exp(-1.0 / 3)))) > 3 ? 1 : 0;
  }
  BOOST_TEST(alarms < 10);
}

BOOST_AUTO_TEST_CASE(a_step_is_seen_with_its_sign_and_size) {
  // White noise, 1024 values a half: the difference of the halves has error sqrt(2/1024) = .0442. A step of .44 is 10
  // of those, seen with an error of the error of about 10 %, and the scatter of z is 1.
  std::vector<double> series = synthetic::white(77, 2048);
  for (std::size_t k = 1024; k < series.size(); ++k) series[k] += 0.442;
  BOOST_TEST(std::abs(stationarity_z(series) - 10) < 4 * std::hypot(1.0, 1.0));
  for (double& v : series) v = -v;
  BOOST_TEST(stationarity_z(series) < -5);
}

BOOST_AUTO_TEST_CASE(is_the_difference_over_the_block_errors) {
  const std::vector<double> series = synthetic::autoregressive(3, 201, 0.5);  // the middle value is in neither half
  const BlockError a = block_error(std::span(series).first(100)), b = block_error(std::span(series).last(100));
  BOOST_TEST(stationarity_z(series) == (b.mean - a.mean) / std::hypot(a.error, b.error),
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(stationarity_at_the_edges) {
  BOOST_TEST(stationarity_z(std::vector<double>(40, 3.0)) == 0.0);
  std::vector<double> step(40, 3.0);
  for (std::size_t k = 20; k < 40; ++k) step[k] = 4;
  BOOST_TEST(std::isinf(stationarity_z(step)));
  BOOST_TEST(std::isnan(stationarity_z(std::vector<double>(15, 3.0))));  // halves of 7
  BOOST_TEST(std::isnan(stationarity_z({})));
}

BOOST_AUTO_TEST_CASE(misfit_by_hand) {
  // [(3 - 2)^2 - .25 + (4 - 4)^2 - 1]/(4 + 16) = -.0125; with weights 2 and 1: (1.5 - 1)/24.
  const std::vector<Estimate> y = {{3, 0.5}, {4, 1}};
  const std::vector<double> theta = {2, 4}, w = {2, 1};
  BOOST_TEST(relative_misfit(y, theta) == -0.0125, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(relative_misfit(y, theta, w) == 0.5 / 24, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(misfit_is_free_of_noise) {
  // Reference 10 % too small everywhere, errors 20 %: D^2 = .01 on average, though noise alone would give .04/.81. One
  // profile of 18 bins scatters by sqrt(2 x .04^2 + 4 x .01 x .04)/sqrt(18)/.81 = .02; 400 of them by 1e-3; 4 of those.
  double sum = 0;
  for (std::uint64_t key = 0; key < 400; ++key) {
    const std::vector<double> g = synthetic::white(key, 18);
    std::vector<Estimate> y;
    for (const double v : g) y.push_back({1 + 0.2 * v, 0.2});
    sum += relative_misfit(y, std::vector<double>(18, 0.9)) / 400;
  }
  BOOST_TEST(std::abs(sum - 0.01 / 0.81) < 4e-3);
}

BOOST_AUTO_TEST_CASE(misfit_leaves_out_what_was_not_measured) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Estimate> y = {{3, 0.5}, {nan, nan}, {4, 1}, {7, nan}};
  const std::vector<double> theta = {2, 5, 4, 1};
  BOOST_TEST(relative_misfit(y, theta) == -0.0125, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(misfit_refuses) {
  const std::vector<Estimate> y = {{3, 0.5}};
  BOOST_CHECK_THROW(relative_misfit(y, std::vector<double>{1, 2}), InputError);
  BOOST_CHECK_THROW(relative_misfit(y, std::vector<double>{1}, std::vector<double>{1, 2}), InputError);
  BOOST_CHECK_THROW(relative_misfit(y, std::vector<double>{0}), InputError);
  BOOST_CHECK_THROW(relative_misfit({}, {}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
