#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(ratios)

/// A gas of 64 disks that has lost `lost` (of ln T) in 3 collisions of each disk and a time 3.
Record cooled(double lost, const std::string& more = "") {
  const double begin = 64 * std::exp(lost);  // the state of the start is that of the end here: 64
  Record record = made_record(
      "[scene]\ngeometry = \"periodic\"\nparticles = 64\nlength_over_width = 1\narea_fraction = 0.1\n"
      "normal_restitution = 0.9\n" +
          more + "[run]\nduration = 3\nbins = 1\n",
      [&](const SetTally& set) {
        set(Tally::measured_time, 0, 3);
        set(Tally::pair_contacts, 0, 3 * 64 / 2);
        set(Tally::energy_change, 0, 64 - begin);
      });
  return record;
}

/// 64 disks between walls of .9 and .5, with a temperature of 2, drifting at .03: 30 contacts with each, and what they
/// took.
Record braked(double lower_loss, double upper_loss) {
  return made_record(
      "[scene]\ngeometry = \"channel\"\ngravity = 0\nparticles = 64\nwidth_over_diameter = 12\narea_fraction = 0.1\n"
      "normal_restitution = 1\nwall_tangential_restitution = [0.9, 0.5]\n[run]\nduration = 3\nbins = 1\n",
      [&](const SetTally& set) {
        set(Tally::samples, 0, 10);
        set(Tally::energy, 0, 10 * 64 * 2);
        set(Tally::momentum, 0, 10 * 64 * 0.03);
        for (const int wall : {0, 1}) set(Tally::wall_contacts, wall, 30);
        set(Tally::wall_loss, 0, lower_loss);
        set(Tally::wall_loss, 1, upper_loss);
      });
}

/// Two bins of 3 and 5 disks that move with +-1 about the means of their bins, sampled once; `freedom` of each.
Record binned(double less) {
  return made_record(
      "[scene]\ngeometry = \"periodic\"\nparticles = 8\nlength_over_width = 1\narea_fraction = 0.1\n"
      "normal_restitution = 1\n[run]\nduration = 3\nbins = 2\n",
      [&](const SetTally& set) {
        set(Tally::samples, 0, 1);
        set(Tally::ux2, 0, 3 - 1);
        set(Tally::ux2, 1, 5 - 1);
        set(Tally::freedom, 0, 3 - less);
        set(Tally::freedom, 1, 5 - less);
        set(Tally::cx2, 0, 3);
        set(Tally::cx2, 1, 4);
      });
}

BOOST_AUTO_TEST_CASE(a_gas_that_cools_is_measured_by_its_collisions) {
  SceneRecords records;
  const double right = 0.5 * (1 - 0.81) * 3;
  records["gas"] = {cooled(right, "tc_time = 0\n"), cooled(1.1 * right, "tc_time = 0\n")};
  records["gas with TC"] = {cooled(right * std::exp(-2.37 * 0.02), "tc_time = 0.02\n")};
  const Evidence evidence = estimate_cooling(made_claim(0.02), Tier::quick, records);
  BOOST_TEST(std::abs(evidence.checks.at(0).values.at(0) - 1) < 1e-12);
  BOOST_TEST(std::abs(evidence.checks.at(0).values.at(1) - 1.1) < 1e-12);
  BOOST_TEST(std::abs(evidence.checks.at(1).values.at(0) - 1) < 1e-12);
  BOOST_TEST(evidence.checks.at(0).band.hi == 1.02);
}

BOOST_AUTO_TEST_CASE(each_wall_is_measured_by_its_own_contacts) {
  SceneRecords records;
  const double lower = 30 * 0.5 * (1 - 0.81) * 2, upper = 30 * 0.5 * (1 - 0.25) * 2;
  records["walls"] = {braked(lower, 1.1 * upper), braked(upper, lower)};
  const Evidence evidence = estimate_wall_losses(made_claim(0.04, {{"at_rest", 0.005}}), Tier::quick, records);
  BOOST_TEST_REQUIRE(evidence.checks.size() == 3u);
  BOOST_TEST(std::abs(evidence.checks[0].values.at(0) - 1) < 1e-12);
  BOOST_TEST(std::abs(evidence.checks[1].values.at(0) - 1.1) < 1e-12);
  BOOST_TEST(std::abs(evidence.checks[0].values.at(1) - 0.75 / 0.19) < 1e-12);  // walls exchanged
  BOOST_TEST(evidence.checks[0].band.lo == 0.96);
  BOOST_TEST(evidence.checks[2].values == std::vector({0.03 / std::sqrt(2), 0.03 / std::sqrt(2)}),
             boost::test_tools::tolerance(1e-12) << boost::test_tools::per_element());
  BOOST_TEST(evidence.checks[2].band.hi == 0.005);
}

BOOST_AUTO_TEST_CASE(bins_are_measured_with_a_degree_of_freedom_less) {
  SceneRecords records;
  records["bins"] = {binned(1), binned(0)};
  const Evidence evidence = estimate_bin_temperature(made_claim(0.002), Tier::quick, records);
  BOOST_TEST_REQUIRE(evidence.checks.size() == 1u);
  BOOST_TEST(std::abs(evidence.checks[0].values.at(0) - 1) < 1e-12);
  BOOST_TEST(std::abs(evidence.checks[0].values.at(1) - 0.75) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
