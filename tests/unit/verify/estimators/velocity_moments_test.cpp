#include "verify/estimators/velocity_moments.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_flow.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(velocity_moments)

const auto close = boost::test_tools::tolerance(1e-9);

BOOST_AUTO_TEST_CASE(mirror_images_are_averaged_with_their_parity) {
  const std::vector<Record> records{made_flow(flow_text(0.3, 0.9, 0.5), [](int b) {
    MadeBin bin;
    bin.skewness_x = b == 0 ? -0.2 : -0.4;  // bin 6: -0.4
    bin.skewness_y = b == 0 ? 0.3 : b == 5 ? -0.5 : 0;
    return bin;
  })};
  const SceneValues scene("a", records);
  BOOST_TEST(moment(scene, skewness_x, 0)[0] == -0.3, close);
  BOOST_TEST(moment(scene, skewness_x_long_time, 0)[0] == -0.3, close);
  BOOST_TEST(moment(scene, skewness_y, 0)[0] == 0.4, close);
  BOOST_TEST(departure(scene, skewness_x, 0)[0] == 0.3, close);
  BOOST_TEST(departure(scene, kurtosis_x, 0, 2.5)[0] == 0.5, close);
  const Series profile = moment_profile(scene, skewness_y, "u_y");
  BOOST_TEST(profile.y.front() == 0.4, close);
  BOOST_TEST(profile.y.back() == -0.4, close);
  BOOST_TEST(moment_check(scene, skewness_y, 1, {0, 1}).label ==
             "nu 0.3, e_n 0.9, beta_w 0.5, bins 2 and 5: skewness of u_y");
}

BOOST_AUTO_TEST_CASE(a_bin_of_a_claim_is_counted_from_one_on_the_lower_side) {
  const std::vector<Record> records{made_flow(flow_text(0.3, 0.9, 0.5), [](int) { return MadeBin{}; })};
  const SceneValues scene("a", records);
  BOOST_TEST(bin_parameter(made_claim(0, {{"bin", 3}}), "bin", scene) == 2);
  BOOST_CHECK_THROW(bin_parameter(made_claim(0, {{"bin", 4}}), "bin", scene), InputError);
  BOOST_CHECK_THROW(bin_parameter(made_claim(0, {{"bin", 0}}), "bin", scene), InputError);
}

BOOST_AUTO_TEST_CASE(the_bias_of_the_instantaneous_mean_is_stated) {
  // Two disks: u = +-(c1 - c2)/2 has no skewness left, and (4 - 6 + 3)/2 = half of the excess kurtosis.
  const std::vector<Record> records{made_flow(flow_text(0.3, 0.9, 0.5), [](int b) {
    MadeBin bin;
    bin.disks = b == 0 || b == 5 ? 2 : 30;
    return bin;
  })};
  const std::string note = notes_on_definitions({SceneValues("a", records)}).front();
  BOOST_TEST(note.find("at the 2 of the emptiest bin here, the skewness to 0.000 and the excess kurtosis to 0.500") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
