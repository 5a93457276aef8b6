#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "unit/verify/estimators/made_flow.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(skewness)

/// Skewness of u_x in the bins from the wall, of u_y on the lower side of the second one, and the area fraction there.
struct Skewed {
  double wall = 0, shear = 0, centre = 0, y = 0, disks = 30;
};

Record skewed(double nu, double restitution, double roughness, const Skewed& s) {
  return made_flow(flow_text(nu, restitution, roughness), [&](int b) {
    MadeBin bin;
    bin.disks = s.disks;
    bin.skewness_x = from_wall(b) == 0 ? s.wall : from_wall(b) == 1 ? s.shear : s.centre;
    bin.skewness_y = from_wall(b) == 1 ? side(b) * s.y : 0;
    return bin;
  });
}

Evidence elastic(const Skewed& smooth) {
  SceneRecords records;
  records["a"] = {skewed(0.3, 0.99, 0.1, {.wall = 0.5, .shear = 0.1})};
  records["b"] = {skewed(0.3, 0.99, 0.9, smooth)};
  records["c"] = {skewed(0.5, 0.99, 0.1, {.wall = 0.1})};  // another exception for another area fraction
  return estimate_skewness_elastic(made_claim(0), Tier::standard, records);
}

BOOST_AUTO_TEST_CASE(everything_but_the_rough_wall_is_nearer_to_zero) {
  const Evidence evidence = elastic({.wall = -0.2, .y = 0.2});
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(evidence.checks.size() == 3 * 9u - 2 * 2u);  // three flows, three bins, three moments, two exceptions
  BOOST_TEST(std::abs(check_with(evidence, "beta_w 0.9, bins 1 and 6: size of the skewness of u_x less").values[0] +
                      0.05) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_skewness_near_that_of_the_rough_wall_is_seen) {
  const std::vector<std::string> labels = outside(elastic({.wall = -0.2, .y = 0.3}));
  BOOST_TEST_REQUIRE(labels.size() == 1u);
  BOOST_TEST(labels[0].find("bins 2 and 5: size of the skewness of u_y") != std::string::npos);
  BOOST_TEST(outside(elastic({.wall = -0.3})).size() == 2u);
}

Evidence dissipation(const Skewed& elastic_flow, const Skewed& last) {
  SceneRecords records;
  records["a"] = {skewed(0.5, 0.8, 0.9, last)};
  records["b"] = {skewed(0.5, 0.99, 0.9, elastic_flow)};
  return estimate_skewness_dissipation(made_claim(0, {{"dense_from", 0.78}, {"shear_bin", 2}, {"dense_shear_bin", 1}}),
                                       Tier::standard, records);
}

BOOST_AUTO_TEST_CASE(it_grows_where_the_flow_shears) {
  const Skewed before{.wall = -0.01, .shear = -0.05, .centre = -0.02, .y = 0.1};
  BOOST_TEST(all_inside(dissipation(before, {.wall = -0.2, .shear = -0.6, .centre = -0.1, .y = 0.5})));
  const auto wrong = [&](const Skewed& last) { return outside(dissipation(before, last)).size(); };
  BOOST_TEST(wrong({.wall = 0.2, .shear = -0.6, .centre = -0.1, .y = 0.5}) == 1u);    // sign at the wall
  BOOST_TEST(wrong({.wall = -0.2, .shear = -0.04, .centre = -0.1, .y = 0.5}) == 3u);  // no growth, plug above
  BOOST_TEST(wrong({.wall = -0.2, .shear = -0.6, .centre = -0.1, .y = 0.05}) == 1u);  // u_y does not grow
}

Evidence density(const std::map<double, double>& sizes) {
  SceneRecords records;
  for (const auto& [nu, size] : sizes) {
    // local area fraction 0.9 from nu 0.5 on: disks of a bin of one sixth of the length 180 pi/(4 144 nu)
    const double length = 180 * 3.14159265358979 / (4 * 144 * nu), disk = 3.14159265358979 / (4 * 144);
    records["nu" + std::to_string(nu)] = {
        skewed(nu, 0.8, 0.9, {.centre = -size, .disks = (nu < 0.49 ? nu : 0.9) * length / 6 / disk})};
  }
  return estimate_skewness_density(made_claim(0.1, {{"peak", 0.3}, {"constant_from", 0.5}, {"local_from", 0.8}}),
                                   Tier::standard, records);
}

BOOST_AUTO_TEST_CASE(it_rises_falls_and_stays) {
  BOOST_TEST(all_inside(density({{0.05, 0.1}, {0.15, 0.3}, {0.3, 0.6}, {0.4, 0.4}, {0.5, 0.25}, {0.6, 0.2}})));
  BOOST_TEST(outside(density({{0.05, 0.3}, {0.15, 0.2}, {0.3, 0.6}, {0.4, 0.4}, {0.5, 0.25}, {0.6, 0.2}})).size() ==
             1u);
  BOOST_TEST(outside(density({{0.05, 0.1}, {0.15, 0.3}, {0.3, 0.6}, {0.4, 0.7}, {0.5, 0.25}, {0.6, 0.2}})).size() ==
             1u);
  BOOST_TEST(outside(density({{0.05, 0.1}, {0.15, 0.3}, {0.3, 0.9}, {0.4, 0.7}, {0.5, 0.6}, {0.6, 0.2}})).size() ==
             2u);  // not constant: both stray from their mean
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
