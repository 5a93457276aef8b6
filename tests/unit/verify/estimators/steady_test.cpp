#include <boost/test/unit_test.hpp>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(steady)

/// Start-up 2, end 10. E = T = `first` before 2, then 1 until 6, then 1 + step.
Record record_with(double first, double step) {
  Record record = made_record(channel_text(0.2), [](const SetTally&) {});
  record.time = 10;
  for (int k = 1; k <= 100; ++k) {
    const double time = 0.1 * k;
    const double value = time < 2 ? first : time < 6 ? 1 : 1 + step;
    record.history.time.push_back(time);
    record.history.energy.push_back(value);
    record.history.temperature.push_back(value);
  }
  return record;
}

Claim claim() { return made_claim(0.1, {{"transient_below", 0.5}}); }

BOOST_AUTO_TEST_CASE(a_plateau_after_a_transient_passes) {
  SceneRecords records;
  records["a"] = {record_with(0.1, 0), record_with(0.1, 0)};
  const Evidence evidence = estimate_steady(claim(), Tier::quick, records);
  BOOST_TEST(evidence.checks.size() == 4u);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(check_with(evidence, "drift of kinetic").values[1] == 0);
  BOOST_TEST(check_with(evidence, "least kinetic").values[0] == 0.1, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_step_in_the_window_is_a_drift) {
  SceneRecords records;
  records["a"] = {record_with(0.1, 0.2)};
  const Evidence evidence = estimate_steady(claim(), Tier::quick, records);
  // Halves 1 and 1.2 of 40 and 41 moments.
  BOOST_TEST(check_with(evidence, "drift of granular").values[0] == 0.2 / (1 + 0.2 * 41 / 81),
             boost::test_tools::tolerance(0.01));
  BOOST_TEST(outside(evidence).size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_run_that_begins_where_it_ends_shows_nothing) {
  SceneRecords records;
  records["a"] = {record_with(0.9, 0)};
  const std::vector<std::string> labels = outside(estimate_steady(claim(), Tier::quick, records));
  BOOST_TEST_REQUIRE(labels.size() == 2u);
  BOOST_TEST(labels[0].find("least") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_history_without_a_window_is_refused) {
  Record record = record_with(0.1, 0);
  record.run.start_up = 50;
  SceneRecords records;
  records["a"] = {record};
  BOOST_CHECK_THROW(estimate_steady(claim(), Tier::quick, records), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
