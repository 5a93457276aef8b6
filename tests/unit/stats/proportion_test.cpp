// Clopper-Pearson intervals against closed forms and binomial sums.
#include "gpf/stats/proportion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"

using namespace gpf;
namespace tt = boost::test_tools;

namespace {

/// P(X >= hits) for X ~ Bin(trials, p).
double upper_tail(std::size_t hits, std::size_t trials, double p) {
  double sum = 0;
  for (std::size_t k = hits; k <= trials; ++k) {
    const auto n = static_cast<double>(trials), m = static_cast<double>(k);
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(m + 1) - std::lgamma(n - m + 1) + m * std::log(p) +
                    (n - m) * std::log1p(-p));
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(proportion)

BOOST_AUTO_TEST_CASE(all_and_none_in_closed_form) {
  BOOST_TEST(proportion_interval({8, 8}, 0.05).lo == std::pow(0.05, 1.0 / 8), tt::tolerance(1e-12));
  BOOST_TEST(proportion_interval({8, 8}, 0.05).hi == 1.0);
  BOOST_TEST(proportion_interval({0, 4}, 0.01).lo == 0.0);
  BOOST_TEST(proportion_interval({0, 4}, 0.01).hi == 1 - std::pow(0.01, 0.25), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(at_its_ends_the_tail_is_alpha) {
  for (const Share share : {Share{3, 4}, Share{7, 8}, Share{9, 16}, Share{1, 32}}) {
    const Interval interval = proportion_interval(share, 0.0125);
    BOOST_TEST(upper_tail(share.hits, share.trials, interval.lo) == 0.0125, tt::tolerance(1e-9));
    BOOST_TEST(1 - upper_tail(share.hits + 1, share.trials, interval.hi) == 0.0125, tt::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(the_p_value_belongs_to_the_interval) {
  const Interval band{0.5, 0.7};
  for (std::size_t hits = 0; hits <= 16; ++hits)
    for (const double alpha : {0.0025, 0.01, 0.05, 0.2})
      BOOST_TEST((outside_band_p_value({hits, 16}, band) < alpha) ==
                 proportion_interval({hits, 16}, alpha).disjoint(band));
  for (const Interval wide : {Interval{0.1, 0.9}, Interval{0.5, 1}, Interval{0, 0.4}})
    for (std::size_t hits = 0; hits <= 32; ++hits)
      BOOST_TEST((inside_band_p_value({hits, 32}, wide) <= 0.025) ==
                 wide.contains(proportion_interval({hits, 32}, 0.025)));
  BOOST_TEST(outside_band_p_value({9, 16}, band) == 1);
  BOOST_TEST(outside_band_p_value({0, 8}, {0.5, 1}) == 1.0 / 256, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  BOOST_CHECK_THROW(proportion_interval({0, 0}, 0.05), InputError);
  BOOST_CHECK_THROW(proportion_interval({5, 4}, 0.05), InputError);
  BOOST_CHECK_THROW(proportion_interval({1, 4}, 0.5), InputError);
  BOOST_CHECK_THROW(outside_band_p_value(Share{0, 0}, {0, 1}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
