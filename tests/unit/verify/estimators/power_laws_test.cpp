#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/wall_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(power_laws)

const std::vector<double> area_fractions = {0.02, 0.05, 0.1, 0.2, 0.4};

Claim power_claim(double low, double high, double lowest_x = 0.02, double highest_x = 0.4) {
  return made_claim(0.001, {{"exponent_low", low},
                            {"exponent_high", high},
                            {"lowest_x", lowest_x},
                            {"highest_x", highest_x},
                            {"lowest_restitution", 0.8},
                            {"departure", 0.05},
                            {"rises_from", 0.2},
                            {"rises_to", 0.4}});
}

/// Slip nu^-.6, gradient (dU/dy)/U_0 = 5 nu^.3 and Kn = .01/nu, times nu^(bend ln nu).
SceneRecords scan(double restitution, double bend = 0) {
  SceneRecords records;
  for (const double nu : area_fractions) {
    const double bent = std::pow(nu, bend * std::log(nu)), centre = 3;
    const double slip = 0.1 * std::pow(nu, -0.6) * bent, gradient = 5 * std::pow(nu, 0.3) * bent;
    add(records, {.area_fraction = nu,
                  .restitution = restitution,
                  .knudsen = 0.01 / nu * bent,
                  .velocity = {centre * slip, centre * (slip + gradient / 6), centre}});
  }
  return records;
}

BOOST_AUTO_TEST_CASE(exact_power_laws_are_inside_and_give_their_exponents) {
  const SceneRecords records = scan(0.9);
  const auto close = boost::test_tools::tolerance(1e-6);
  const Evidence slip = estimate_slip_density(power_claim(-0.65, -0.55), Tier::quick, records);
  BOOST_TEST(check_with(slip, "e_n 0.9: exponent").values[1] == -0.6, close);
  BOOST_TEST(all_inside(slip));
  const Evidence gradient = estimate_gradient_density(power_claim(0.3, 0.3), Tier::quick, records);
  BOOST_TEST(check_with(gradient, "exponent").values[0] == 0.3, close);
  BOOST_TEST(all_inside(gradient));
  const Evidence kn = estimate_kn_density(power_claim(-1, -1), Tier::quick, records);
  BOOST_TEST(check_with(kn, "exponent").values[0] == -1.0, close);
  BOOST_TEST(all_inside(kn));
  const Evidence against_kn = estimate_slip_knudsen(power_claim(0.6, 0.6, 0.024, 0.6), Tier::quick, records);
  BOOST_TEST(check_with(against_kn, "exponent").values[0] == 0.6, close);
  BOOST_TEST(all_inside(against_kn));
  const Evidence gradient_kn = estimate_gradient_knudsen(power_claim(-0.3, -0.3, 0.024, 0.6), Tier::quick, records);
  BOOST_TEST(check_with(gradient_kn, "exponent").values[0] == -0.3, close);
}

BOOST_AUTO_TEST_CASE(another_exponent_fails) {
  BOOST_TEST(outside(estimate_slip_density(power_claim(-0.5, -0.4), Tier::quick, scan(0.9))).size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_bent_curve_is_no_power_law) {
  const Evidence slip = estimate_slip_density(power_claim(-2, 2), Tier::quick, scan(0.9, -0.1));
  const std::vector<std::string> labels = outside(slip);
  BOOST_TEST_REQUIRE(labels.size() == 1u);
  BOOST_TEST(labels[0].find("power law") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(below_the_stated_restitution_kn_has_to_rise_again) {
  const Evidence monotonic = estimate_kn_density(power_claim(-1, -1), Tier::quick, scan(0.6));
  BOOST_TEST(monotonic.checks.size() == 2u);  // by both definitions; no exponent
  BOOST_TEST(outside(monotonic).size() == 2u);
  SceneRecords rising = scan(0.6);
  add(rising, {.area_fraction = 0.3, .restitution = 0.6, .knudsen = 0.01});
  Claim claim = power_claim(-1, -1);
  claim.parameters["rises_from"] = 0.3;
  BOOST_TEST(all_inside(estimate_kn_density(claim, Tier::quick, rising)));
}

BOOST_AUTO_TEST_CASE(a_larger_system_is_compared_with_that_of_the_same_area_fraction) {
  SceneRecords records = scan(0.9);
  const double slip = 0.1 * std::pow(0.1, -0.6);
  add(records, {.area_fraction = 0.1,
                .restitution = 0.9,
                .particles = 1800,
                .knudsen = 0.1,
                .velocity = {3 * slip * 1.1, 3, 3}});
  const Evidence evidence = estimate_slip_knudsen(power_claim(0.6, 0.6, 0.024, 0.6), Tier::quick, records);
  BOOST_TEST(check_with(evidence, "ln of slip_velocity").values[0] == std::log(1.1),
             boost::test_tools::tolerance(1e-6));
  const std::vector<std::string> labels = outside(evidence);
  BOOST_TEST_REQUIRE(labels.size() == 1u);
  BOOST_TEST(labels[0].find("ln of slip_velocity with 1800") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(too_few_scenes_in_the_range_are_refused) {
  BOOST_CHECK_THROW(estimate_slip_density(power_claim(-1, 0, 0.06, 0.4), Tier::quick, scan(0.9)), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
