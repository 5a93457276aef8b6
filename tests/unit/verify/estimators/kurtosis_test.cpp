#include <boost/test/unit_test.hpp>

#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(kurtosis)

/// Velocities with U = 2, variances .5 and .7 and the given kurtosis of the first pair of bins; 3 elsewhere.
Record record_with(double first_x, double first_y) {
  return made_record(channel_text(0.2), [&](const SetTally& set) {
    for (int b = 0; b < 6; ++b) {
      const double n = 30, mean = 2, vx = 0.5, vy = 0.7;
      const bool first = b == 0 || b == 5;
      const double kx = (first ? first_x : 3) * vx * vx, ky = (first ? first_y : 3) * vy * vy;
      set(Tally::count, b, n);
      set(Tally::freedom, b, n - 1);
      set(Tally::ux2, b, n * vx);
      set(Tally::ux4, b, n * kx);
      set(Tally::cx, b, n * mean);
      set(Tally::cx2, b, n * (mean * mean + vx));
      set(Tally::cx3, b, n * (mean * mean * mean + 3 * mean * vx));
      set(Tally::cx4, b, n * (mean * mean * mean * mean + 6 * mean * mean * vx + kx));
      set(Tally::cy2, b, n * vy);
      set(Tally::cy4, b, n * ky);
    }
  });
}

BOOST_AUTO_TEST_CASE(a_gaussian_has_three_in_every_bin_by_both_definitions) {
  SceneRecords records;
  records["a"] = {record_with(3, 3), record_with(3, 3)};
  const Evidence evidence = estimate_kurtosis(made_claim(1e-9), Tier::quick, records);
  BOOST_TEST(evidence.checks.size() == 9u);  // three pairs of bins, three quantities
  BOOST_TEST(all_inside(evidence));
}

BOOST_AUTO_TEST_CASE(each_component_is_judged_where_it_departs) {
  SceneRecords records;
  records["a"] = {record_with(3.5, 2.5)};
  const Evidence evidence = estimate_kurtosis(made_claim(0.1), Tier::quick, records);
  const std::vector<std::string> labels = outside(evidence);
  BOOST_TEST(labels.size() == 3u);
  for (const std::string& label : labels) BOOST_TEST(label.find("bins 1 and 6") != std::string::npos);
  BOOST_TEST(check_with(evidence, "bins 1 and 6: kurtosis of u_y").values[0] == 2.5,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(check_with(evidence, "bins 1 and 6: kurtosis of u_x about the long-time mean").values[0] == 3.5,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
