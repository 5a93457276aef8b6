// Student's t against printed tables, and the interval's error rates against synthetic replicas.
#include "gpf/stats/interval.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "gpf/base/error.hpp"
#include "synthetic.hpp"

namespace {

using namespace gpf;

BOOST_AUTO_TEST_SUITE(intervals)

BOOST_AUTO_TEST_CASE(t_quantiles_are_those_of_the_tables) {
  // Printed to three decimals in every table of Student's t.
  const double digits = 0.0005;
  BOOST_TEST(std::abs(student_t_quantile(0.975, 1) - 12.706) < digits);
  BOOST_TEST(std::abs(student_t_quantile(0.99, 3) - 4.541) < digits);
  BOOST_TEST(std::abs(student_t_quantile(0.995, 7) - 3.499) < digits);
  BOOST_TEST(std::abs(student_t_quantile(0.95, 30) - 1.697) < digits);
  BOOST_TEST(std::abs(student_t_quantile(0.025, 10) + 2.228) < digits);
  BOOST_TEST(student_t_quantile(0.5, 4) == 0.0);
  // One degree of freedom is Cauchy: tan(pi (p - 1/2)).
  BOOST_TEST(student_t_quantile(0.75, 1) == 1.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(t_quantile_refuses) {
  BOOST_CHECK_THROW(student_t_quantile(0, 3), InputError);
  BOOST_CHECK_THROW(student_t_quantile(1, 3), InputError);
  BOOST_CHECK_THROW(student_t_quantile(0.9, 0), InputError);
  BOOST_CHECK_THROW(student_t_quantile(std::numeric_limits<double>::quiet_NaN(), 3), InputError);
}

BOOST_AUTO_TEST_CASE(summary_by_hand) {
  const ReplicaSummary s = summarise(std::vector<double>{2, 4, 4, 6});
  BOOST_TEST(s.mean == 4.0);
  BOOST_TEST(s.deviation == std::sqrt(8.0 / 3), boost::test_tools::tolerance(1e-15));
  BOOST_TEST(s.standard_error() == std::sqrt(2.0 / 3), boost::test_tools::tolerance(1e-15));
  BOOST_TEST(s.count == 4u);
  BOOST_TEST(std::isnan(summarise(std::vector<double>{3}).deviation));
  BOOST_TEST(summarise(std::vector<double>{3}).mean == 3.0);
  BOOST_TEST(std::isnan(summarise({}).mean));
}

BOOST_AUTO_TEST_CASE(interval_by_hand) {
  // t_{.99,3} = 4.541: 4 +- 4.541 sqrt(2/3).
  const Interval i = t_interval(summarise(std::vector<double>{2, 4, 4, 6}), 0.01);
  BOOST_TEST(std::abs(i.hi - (4 + 4.541 * std::sqrt(2.0 / 3))) < 0.0005);
  BOOST_TEST(i.centre() == 4.0, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(one_replica_bounds_nothing) {
  const Interval i = t_interval(summarise(std::vector<double>{2}), 0.01);
  BOOST_TEST(std::isinf(i.lo));
  BOOST_TEST(std::isinf(i.hi));
  BOOST_TEST(i.contains(1e300));
}

BOOST_AUTO_TEST_CASE(each_end_errs_as_often_as_it_says) {
  // 4000 sets of 4 replicas, truth .7, alpha .05 per direction: 200 misses at each end, +- sqrt(4000 .05 .95) = 13.8.
  // Within 4 of those: one false alarm in 16,000 other seeds.
  int low = 0, high = 0;
  for (std::uint64_t key = 0; key < 4000; ++key) {
    std::vector<double> values = synthetic::white(key, 4);
    for (double& v : values) v = 0.7 + 3 * v;
    const Interval i = t_interval(summarise(values), 0.05);
    low += 0.7 < i.lo ? 1 : 0;
    high += 0.7 > i.hi ? 1 : 0;
  }
  BOOST_TEST(std::abs(low - 200) < 4 * 13.8);
  BOOST_TEST(std::abs(high - 200) < 4 * 13.8);
}

BOOST_AUTO_TEST_CASE(error_rate_must_be_one) {
  const ReplicaSummary s = summarise(std::vector<double>{2, 4});
  BOOST_CHECK_THROW(t_interval(s, 0), InputError);
  BOOST_CHECK_THROW(t_interval(s, 0.5), InputError);
}

BOOST_AUTO_TEST_CASE(relations_of_intervals) {
  const Interval a{1, 2};
  BOOST_TEST(a.contains(1.0));
  BOOST_TEST(!a.contains(2.5));
  BOOST_TEST(a.contains(Interval{1.25, 2}));
  BOOST_TEST(!a.contains(Interval{0.5, 1.5}));
  BOOST_TEST(a.disjoint(Interval{2.25, 3}));
  BOOST_TEST(a.disjoint(Interval{-1, 0.5}));
  BOOST_TEST(!a.disjoint(Interval{2, 3}));
  BOOST_TEST(a.width() == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
