#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(smooth_fields)

/// Bins 3 and 4 are the centre, 2 and 5 the edge. U = 4 at the centre and 4 - du at the edge, T = 1 and 1 + dt, 30
/// disks and 30 - dn; bins 1 and 6 are far off in everything and must not count, but for their disks in the mean T.
Record record_with(double nu, double du, double dt, double dn) {
  return made_record(channel_text(nu), [&](const SetTally& set) {
    set(Tally::momentum, 0, 180 * 3.0);
    for (int b = 0; b < 6; ++b) {
      const int from_wall = b < 3 ? b : 5 - b;
      const double n = from_wall == 2 ? 30 : from_wall == 1 ? 30 - dn : 0;
      const double u = from_wall == 2 ? 4 : 4 - du, t = from_wall == 2 ? 1 : 1 + dt;
      set(Tally::count, b, from_wall == 0 ? 1e-12 : n);
      set(Tally::freedom, b, from_wall == 0 ? 1e-12 : n);
      set(Tally::cx, b, from_wall == 0 ? 1e-9 : n * u);
      set(Tally::ux2, b, (from_wall == 0 ? 1e-12 : n) * t);
      set(Tally::cy2, b, (from_wall == 0 ? 1e-12 : n) * t);
    }
  });
}

BOOST_AUTO_TEST_CASE(differences_are_measured_between_centre_and_edge) {
  SceneRecords records;
  records["a"] = {record_with(0.1, 0.5, 0, 0)};
  records["b"] = {record_with(0.3, 1, 0.2, 3)};
  const Evidence evidence = estimate_smooth_fields(made_claim(0, {{"edge_bin", 2}}), Tier::quick, records);
  const double disks = 2 * (30 + 27), temperature = 2 * (30 * 1 + 27 * 1.2) / disks;
  const auto close = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(check_with(evidence, "U: variation").values[0] == 1 / std::sqrt(temperature) - 0.5, close);
  BOOST_TEST(check_with(evidence, "T: variation").values[0] == 0.2 / temperature, close);
  BOOST_TEST(check_with(evidence, "nu: variation at").values[0] == 3 / (disks / 6), close);
  BOOST_TEST(check_with(evidence, "nu 0.1: variation of U less that of T").values[0] == 0.5, close);
  BOOST_TEST(all_inside(evidence));
}

BOOST_AUTO_TEST_CASE(a_field_that_varies_less_in_a_denser_flow_is_seen) {
  SceneRecords records;
  records["a"] = {record_with(0.1, 0.5, 0.2, 2)};
  records["b"] = {record_with(0.3, 1, 0.1, 3)};
  const Evidence evidence = estimate_smooth_fields(made_claim(0, {{"edge_bin", 2}}), Tier::quick, records);
  const std::vector<std::string> labels = outside(evidence);
  BOOST_TEST_REQUIRE(labels.size() == 1u);
  BOOST_TEST(labels[0].find("T: variation") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_temperature_that_varies_more_than_the_velocity_is_seen) {
  SceneRecords records;
  records["a"] = {record_with(0.1, 0.1, 0.5, 0)};
  const Evidence evidence = estimate_smooth_fields(made_claim(0, {{"edge_bin", 2}}), Tier::quick, records);
  const std::vector<std::string> labels = outside(evidence);
  BOOST_TEST_REQUIRE(labels.size() == 1u);
  BOOST_TEST(labels[0].find("variation of U less that of T") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
