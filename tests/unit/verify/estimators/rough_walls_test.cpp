#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "unit/verify/estimators/made_flow.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(rough_walls)

/// Skewness and kurtosis of u_x by distance from the wall: bins 1, 2, 3.
using Profile = std::vector<std::pair<double, double>>;

Record rough(double nu, const Profile& profile, double roughness = 0.1) {
  return made_flow(flow_text(nu, 0.99, roughness), [&](int b) {
    MadeBin bin;
    std::tie(bin.skewness_x, bin.kurtosis_x) = profile[static_cast<std::size_t>(from_wall(b))];
    return bin;
  });
}

const Profile dilute{{1, 3.6}, {0.8, 3.3}, {0.6, 3.2}}, dense{{0.5, 3.5}, {0.05, 2.95}, {0.02, 3.1}};

Evidence centre(const Profile& thin, const Profile& thick) {
  SceneRecords records;
  records["thick"] = {rough(0.3, thick)};
  records["thin"] = {rough(0.015, thin)};
  return estimate_rough_centre(made_claim(0.1, {{"dense_from", 0.3}, {"wall_bins", 1}}), Tier::standard, records);
}

BOOST_AUTO_TEST_CASE(walls_felt_everywhere_when_dilute_and_beside_them_when_dense) {
  const Evidence evidence = centre(dilute, dense);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(std::abs(check_with(evidence,
                                 "nu 0.015, e_n 0.99, beta_w 0.1, bins 3 and 4: size of the skewness of u_x "
                                 "about")
                          .values[0] -
                      0.6) < 1e-9);
  // |3.2 - 3| less |3.1 - 3|
  BOOST_TEST(std::abs(check_with(evidence, "bins 3 and 4: departure of the kurtosis of u_x from").values[0] - 0.1) <
             1e-9);
}

BOOST_AUTO_TEST_CASE(a_dilute_flow_without_asymmetry_or_departure_is_seen) {
  const std::vector<std::string> labels = outside(centre({{1, 3.6}, {0.8, 3.3}, {0.05, 3.05}}, dense));
  BOOST_TEST(labels.size() == 4u);  // either definition: skewness and kurtosis at the centre
  for (const std::string& label : labels) BOOST_TEST(label.find("bins 3 and 4") != std::string::npos, label);
}

BOOST_AUTO_TEST_CASE(a_dense_flow_that_feels_the_wall_at_the_centre_is_seen) {
  BOOST_TEST(outside(centre(dilute, {{0.5, 3.5}, {0.3, 3.1}, {0.3, 3.6}})).size() >= 4u);
}

Evidence beta(double rough_wall, double middle, double smooth) {
  SceneRecords records;
  records["c"] = {rough(0.015, {{rough_wall, 3}, {0, 3}, {0, 3}}, 0.1)};
  records["b"] = {rough(0.015, {{middle, 3}, {0, 3}, {0, 3}}, 0.5)};
  records["a"] = {rough(0.015, {{smooth, 3}, {0, 3}, {0, 3}}, 0.9)};
  return estimate_rough_beta(made_claim(0.1), Tier::standard, records);
}

BOOST_AUTO_TEST_CASE(asymmetry_falls_with_smoothness_and_vanishes) {
  BOOST_TEST(all_inside(beta(1, 0.4, -0.05)));
  BOOST_TEST(outside(beta(1, 1.2, 0)).size() == 2u);
  BOOST_TEST(outside(beta(1, 0.5, 0.3)).size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
