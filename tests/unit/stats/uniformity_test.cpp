#include "gpf/stats/uniformity.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "gpf/base/error.hpp"
#include "unit/stats/synthetic.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(uniformity)

// n = 10, D = 0.40925 is the 5 % point of the exact distribution (tables of Kolmogorov and Smirnov); here the values
// lie on the diagonal's lower side but for one gap of that size.
BOOST_AUTO_TEST_CASE(tabulated_point) {
  std::vector<double> values;
  for (int k = 0; k < 10; ++k) values.push_back(std::max(0.0, (k + 1) / 10.0 - 0.40925));
  BOOST_TEST(std::abs(uniformity_p_value(values) - 0.05) < 0.003);
}

BOOST_AUTO_TEST_CASE(uniform_numbers_have_uniform_p_values) {
  std::vector<double> p_values;
  for (std::uint64_t set = 0; set < 1000; ++set) {
    std::vector<double> values = synthetic::white(set, 50);
    for (double& x : values) x = std::erfc(x / std::sqrt(2.0)) / 2;
    p_values.push_back(uniformity_p_value(values));
  }
  BOOST_TEST(uniformity_p_value(p_values) > 1e-4);
  int small = 0;
  for (const double p : p_values) small += p <= 0.05;
  BOOST_TEST(std::abs(small - 50) < 4 * std::sqrt(1000 * 0.05 * 0.95));
}

BOOST_AUTO_TEST_CASE(other_numbers_have_small_ones) {
  std::vector<double> values;
  for (int k = 0; k < 200; ++k) values.push_back((k + 0.5) * (k + 0.5) / 40000);
  BOOST_TEST(uniformity_p_value(values) < 1e-6);
  BOOST_TEST(uniformity_p_value({{0.1, 0.3, 0.5, 0.7, 0.9}}) > 0.99);
}

BOOST_AUTO_TEST_CASE(what_is_no_p_value_is_refused) {
  BOOST_CHECK_THROW(uniformity_p_value({}), InputError);
  BOOST_CHECK_THROW(uniformity_p_value({{0.5, 1.5}}), InputError);
  BOOST_CHECK_THROW(uniformity_p_value({{NAN}}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
