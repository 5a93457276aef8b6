#include "verify/estimators/velocity_moments.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_flow.hpp"
#include "verify/estimators/velocity_histogram.hpp"

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

BOOST_AUTO_TEST_SUITE(velocity_histogram)

/// Counts that a parabola about `peak` makes, with a second one of `height` about 2.5.
VelocityHistogram made(double peak, double height) {
  std::vector<double> centres, counts;
  for (int k = 0; k < 100; ++k) {
    const double u = -5 + 0.1 * (k + 0.5);
    centres.push_back(u);
    const auto bump = [u](double at) { return std::max(0.0, 1 - (u - at) * (u - at)); };
    counts.push_back(1000 * (bump(peak) + height * bump(2.5)));
  }
  return {centres, counts};
}

BOOST_AUTO_TEST_CASE(the_peak_of_a_parabola_is_its_vertex) {
  BOOST_TEST(std::abs(made(-0.52, 0).peak() + 0.52) < 1e-9);
  BOOST_TEST(made(-0.52, 0).second_rise() == 0);
  BOOST_TEST(std::isnan(VelocityHistogram({0, 1, 2}, {0, 0, 0}).peak()));
}

BOOST_AUTO_TEST_CASE(a_second_peak_is_seen_on_either_side) {
  BOOST_TEST(std::abs(made(-0.52, 0.4).second_rise() - 0.4) < 0.01);
  BOOST_TEST(std::abs(made(4.8, 0.4).second_rise() - 0.4) < 0.05);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
