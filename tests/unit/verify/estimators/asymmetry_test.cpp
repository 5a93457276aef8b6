#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "unit/verify/estimators/made_flow.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(asymmetry)

/// Skewness of u_x in the bins from the wall, and of u_y in the second one and its mirror image.
struct Skewed {
  double wall = 0, shear = 0, centre = 0, y_lower = 0, y_upper = 0, kurtosis = 3;
};

Record skewed(double restitution, const Skewed& s) {
  return made_flow(flow_text(0.3, restitution, 0.9), [&](int b) {
    MadeBin bin;
    bin.skewness_x = from_wall(b) == 0 ? s.wall : from_wall(b) == 1 ? s.shear : s.centre;
    bin.skewness_y = b == 1 ? s.y_lower : b == 4 ? s.y_upper : 0;
    bin.kurtosis_x = from_wall(b) == 0 ? s.kurtosis : 3;
    return bin;
  });
}

Evidence moderate(const Skewed& s) {
  SceneRecords records;
  records["a"] = {skewed(0.99, {})};  // not judged
  records["b"] = {skewed(0.8, s)};
  return estimate_moderate_asymmetry(made_claim(0.1, {{"highest_restitution", 0.9}, {"shear_bin", 2}}), Tier::standard,
                                     records);
}

BOOST_AUTO_TEST_CASE(asymmetric_but_for_the_wall) {
  const Evidence evidence = moderate({.wall = 0.05, .shear = -0.5, .centre = -0.3, .y_lower = 0.4, .y_upper = -0.4});
  BOOST_TEST(evidence.checks.size() == 10u);
  BOOST_TEST(all_inside(evidence));
}

BOOST_AUTO_TEST_CASE(each_part_of_it_can_fail) {
  BOOST_TEST(outside(moderate({.wall = 0.3, .shear = -0.5, .centre = -0.3, .y_lower = 0.4, .y_upper = -0.4})).size() ==
             2u);
  BOOST_TEST(outside(moderate({.wall = 0, .shear = -0.5, .centre = 0.02, .y_lower = 0.4, .y_upper = -0.4})).size() ==
             2u);
  const Evidence same = moderate({.wall = 0, .shear = -0.5, .centre = -0.3, .y_lower = 0.4, .y_upper = 0.4});
  BOOST_TEST(outside(same).size() == 3u);  // product, size of the odd part, sum
  BOOST_TEST(std::abs(check_with(same, "skewness of u_y in the one").values[0] - 0.16) < 1e-9);
}

Evidence shear(const Skewed& elastic, const Skewed& dissipative) {
  SceneRecords records;
  records["a"] = {skewed(0.8, dissipative)};
  records["b"] = {skewed(0.99, elastic)};
  return estimate_shear_asymmetry(made_claim(0.1, {{"shear_bin", 2}}), Tier::standard, records);
}

BOOST_AUTO_TEST_CASE(negative_velocities_grow_likelier_with_dissipation) {
  BOOST_TEST(all_inside(shear({.shear = -0.05}, {.shear = -0.6, .y_lower = 0.4, .y_upper = -0.4})));
  BOOST_TEST(outside(shear({.shear = 0.05}, {.shear = 0.6, .y_lower = 0.4, .y_upper = -0.4})).size() == 6u);
  BOOST_TEST(outside(shear({.shear = -0.7}, {.shear = -0.6, .y_lower = 0.4, .y_upper = -0.4})).size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_wall_bin_is_gaussian_by_both_moments) {
  const auto wall = [](double skewness, double kurtosis) {
    SceneRecords records;
    records["a"] = {skewed(0.8, {.wall = skewness, .kurtosis = kurtosis})};
    return estimate_wall_gaussian(made_claim(0.15, {{"largest_skewness", 0.1}}), Tier::standard, records);
  };
  BOOST_TEST(wall(0.09, 3.1).checks.size() == 6u);
  BOOST_TEST(all_inside(wall(0.09, 3.1)));
  BOOST_TEST(std::abs(check_with(wall(0.09, 3.1), "bins 1 and 6: kurtosis of u_x about").values[0] - 3.1) < 1e-9);
  BOOST_TEST(outside(wall(0.09, 2.8)).size() == 2u);  // either mean
  BOOST_TEST(outside(wall(-0.11, 3)).size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
