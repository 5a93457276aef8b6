#include "verify/estimators/density_structure.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_flow.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(density_structure)

/// What is not given is as in a gas of independent disks.
DensityContrast contrast(double even, double odd, double varicose = 1, double short_even = 1, double short_odd = 1) {
  return {{even, short_even, 1, 1}, {odd, short_odd, 1, 1}, {varicose, 1, 1, 1}};
}

BOOST_AUTO_TEST_CASE(thresholds_are_quantiles_of_an_exponential_distribution) {
  BOOST_TEST(std::abs(std::exp(-std::log(100.0) / visible_contrast) - 0.5) < 1e-12);
  BOOST_TEST(std::abs(std::exp(-std::log(100.0) * clear_factor / visible_contrast) - 0.25) < 1e-12);
}

BOOST_AUTO_TEST_CASE(each_structure_by_its_mode) {
  BOOST_CHECK(classify(contrast(1, 1)) == Structure::plug);
  BOOST_CHECK(classify(contrast(0.3, 3.3)) == Structure::plug);
  BOOST_CHECK(classify(contrast(2, 8)) == Structure::wave);
  BOOST_CHECK(classify(contrast(60, 2)) == Structure::slug);
  BOOST_CHECK(classify(contrast(60, 2, 50)) == Structure::slug);       // of finite height
  BOOST_CHECK(classify(contrast(1, 1, 1, 1, 20)) == Structure::wave);  // two humps
  BOOST_CHECK(classify(contrast(1, 1, 20)) == Structure::varicose);
  BOOST_CHECK(classify(contrast(20, 1, 15, 20)) == Structure::clumps);
  BOOST_CHECK(classify(contrast(2, 1, 15, 20)) == Structure::clumps);
}

BOOST_AUTO_TEST_CASE(what_lies_between_is_in_no_class) {
  BOOST_CHECK(!classify(contrast(1, 5)));  // seen in some snapshots only
  BOOST_CHECK(!classify(contrast(5, 1)));
  BOOST_CHECK(!classify(contrast(10, 10)));  // wave and slug
  BOOST_CHECK(!classify(contrast(10, 19)));
  BOOST_CHECK(!classify(contrast(19, 10)));
  BOOST_CHECK(!classify(contrast(1, 8, 5)));        // a band that winds and swells
  BOOST_CHECK(!classify(contrast(6, 1, 20)));       // a band that swells, and gathers a little
  BOOST_CHECK(!classify(contrast(1, 8, 1, 1, 5)));  // two humps as well
  BOOST_CHECK(!classify(contrast(20, 1, 1, 12)));   // a short slug, or clumps
  BOOST_CHECK(!classify(contrast(10, 11, 1, 20)));  // clumps that wind
}

BOOST_AUTO_TEST_CASE(between_slug_and_clumps_it_is_one_of_the_two) {
  const std::vector lumps{Structure::slug, Structure::clumps}, slug{Structure::slug},
      flat{Structure::plug, Structure::wave};
  BOOST_TEST(is_one_of(lumps, contrast(20, 1, 1, 12)));
  BOOST_TEST(!is_one_of(slug, contrast(20, 1, 1, 12)));
  BOOST_TEST(!is_one_of(flat, contrast(20, 1, 1, 12)));
  BOOST_TEST(!is_one_of(lumps, contrast(20, 11, 1, 12)));  // it may be a wave
  BOOST_TEST(!is_one_of(lumps, contrast(6, 1, 1, 4)));     // seen in some snapshots only
  BOOST_TEST(is_one_of(lumps, contrast(60, 2)));
  BOOST_TEST(is_one_of(slug, contrast(60, 2)));
  BOOST_TEST(!is_one_of(lumps, contrast(1, 1)));
  BOOST_TEST(is_one_of(flat, contrast(1, 1)));
}

BOOST_AUTO_TEST_CASE(bistable_needs_two_classes_that_are_more_than_rare) {
  using Labels = std::vector<std::optional<Structure>>;
  const auto labels = [](std::size_t waves, std::size_t slugs, std::size_t none) {
    Labels l(waves, Structure::wave);
    l.insert(l.end(), slugs, Structure::slug);
    l.insert(l.end(), none, std::nullopt);
    return l;
  };
  BOOST_TEST(tally_of(labels(8, 0, 0)) == "8 wave");
  BOOST_TEST(tally_of(labels(6, 2, 0)) == "2 slug, 6 wave");            // P(2 or more of 8 | .1) = .19
  BOOST_TEST(tally_of(labels(5, 3, 0)) == "3 slug, 5 wave: bistable");  // .038
  BOOST_TEST(tally_of(labels(4, 0, 4)) == "4 between the classes, 4 wave");
}

BOOST_AUTO_TEST_CASE(contrasts_are_powers_over_the_noise) {
  const std::string text = flow_text(0.3, 0.85, 0.9) + "density_modes = 2\n";
  const std::vector<Record> records{made_record(text, [](const SetTally& set) {
    set(Tally::samples, 0, 5);
    set(Tally::mode_even, 0, 5 * 0.04);
    set(Tally::mode_even, 1, 5 * 0.01);
    set(Tally::mode_odd, 1, 5 * 0.003);
    set(Tally::mode_varicose, 0, 5 * 0.02);
    set(Tally::mode_noise_even, 0, 5 * 0.005);
    set(Tally::mode_noise_odd, 0, 5 * 0.001);
    set(Tally::mode_noise_varicose, 0, 5 * 0.01);
  })};
  const SceneValues scene("made", records);
  const auto contrasts = density_contrasts(scene);
  BOOST_TEST(contrasts.size() == 1u);
  BOOST_TEST(std::abs(contrasts[0].even[0] - 8) < 1e-12);
  BOOST_TEST(std::abs(contrasts[0].even[1] - 2) < 1e-12);
  BOOST_TEST(std::abs(contrasts[0].odd[1] - 3) < 1e-12);
  BOOST_TEST(std::abs(contrasts[0].varicose[0] - 2) < 1e-12);
  BOOST_TEST(std::abs(scene.of("density_power_even")[0] - 0.035) < 1e-12);  // less the noise
  const std::vector<Record> without{made_record(flow_text(0.3, 0.85, 0.9), [](const SetTally&) {})};
  BOOST_CHECK_THROW(density_contrasts(SceneValues("made", without)), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
