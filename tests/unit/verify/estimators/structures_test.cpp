#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(structures)

/// A channel of 55 disks for each W of its length, six bins. Contrasts of the modes k = 1; skewnesses in bin 2 and at
/// the centre (and their mirror images).
struct MadeChannel {
  double length = 1, even = 1, odd = 1, velocity = 2, skewness_x = -0.5, skewness_y = 0.5;
};

Record made(const MadeChannel& c) {
  const std::string text =
      "[scene]\ngeometry = \"channel\"\nparticles = " + std::to_string(std::lround(55 * c.length)) +
      "\nwidth_over_diameter = 12\narea_fraction = 0.3\nnormal_restitution = 0.85\n"
      "wall_tangential_restitution = 0.9\n[run]\nduration = 8\nbins = 6\ndensity_modes = 2\n";
  return made_record(text, [&](const SetTally& set) {
    const double noise = 0.001;
    for (const Tally tally : {Tally::mode_noise_even, Tally::mode_noise_odd, Tally::mode_noise_varicose})
      set(tally, 0, noise);
    set(Tally::mode_even, 0, c.even * noise);
    set(Tally::mode_odd, 0, c.odd * noise);
    for (int b = 0; b < 6; ++b) {
      const double n = 10 * c.length, u = c.velocity, side = b < 3 ? 1 : -1;
      set(Tally::count, b, n);
      set(Tally::freedom, b, n);
      set(Tally::cx, b, n * u);
      set(Tally::cx2, b, n * (u * u + 1));
      set(Tally::cx3, b, n * (u * u * u + 3 * u + c.skewness_x));
      set(Tally::ux2, b, n);
      set(Tally::ux3, b, n * c.skewness_x);
      set(Tally::cy2, b, n);
      set(Tally::cy3, b, n * side * c.skewness_y);
    }
  });
}

SceneRecords flows(const MadeChannel& plug, const MadeChannel& wave, const MadeChannel& slug) {
  SceneRecords records;
  records["a"] = {made(slug)};
  records["b"] = {made(wave)};
  records["c"] = {made(plug)};
  records["d"] = {made({.length = 3, .even = 10, .odd = 10})};  // shown only
  return records;
}

const Claim claim = made_claim(0.05, {{"plug", 1}, {"wave", 2}, {"slug_above", 3}, {"shear_bin", 2}});
const MadeChannel plug{}, wave{.length = 2, .even = 2, .odd = 9, .velocity = 1.98, .skewness_x = -0.6},
    slug{.length = 4, .even = 50, .odd = 2, .velocity = 1.96, .skewness_x = -0.8, .skewness_y = 0.6};

Evidence evidence_of(const MadeChannel& p, const MadeChannel& w, const MadeChannel& s) {
  return estimate_structures(claim, Tier::standard, flows(p, w, s));
}

BOOST_AUTO_TEST_CASE(plug_wave_and_slug_as_stated) {
  const Evidence evidence = evidence_of(plug, wave, slug);
  BOOST_TEST(evidence.checks.size() == 3u + 8u);  // classes; 2 pairs x 2 bins x 2 means
  BOOST_TEST(all_inside(evidence));
  const Check& share = check_with(evidence, "L/W 2: replicas with a wave");
  BOOST_TEST(share.share);
  BOOST_TEST(share.values[0] == 1);
  const Check& asymmetry = check_with(evidence, "L/W 4 less L/W 2, bins 3 and 4: size of the skewness of u_x about");
  BOOST_TEST(std::abs(asymmetry.values[0] - 0.2) < 1e-9);
  BOOST_TEST(evidence.plot.series.size() == 3u);
  BOOST_TEST(evidence.plot.series[1].x.size() == 4u);
}

BOOST_AUTO_TEST_CASE(each_part_of_it_can_fail) {
  MadeChannel other = wave;
  other.even = 9;
  BOOST_TEST(outside(evidence_of(plug, other, slug)) == std::vector<std::string>{"L/W 2: replicas with a wave"},
             boost::test_tools::per_element());
  other = plug;
  other.odd = 5;
  BOOST_TEST(outside(evidence_of(other, wave, slug)) == std::vector<std::string>{"L/W 1: replicas with a plug"},
             boost::test_tools::per_element());
  other = slug;
  other.skewness_x = -0.55;  // more than the plug, less than the wave
  BOOST_TEST(outside(evidence_of(plug, wave, other)).size() == 4u);
}

BOOST_AUTO_TEST_CASE(profiles_are_the_same_within_a_part_of_their_height) {
  const auto judged = [](double velocity) {
    MadeChannel other = slug;
    other.velocity = velocity;
    return estimate_structure_profiles(claim, Tier::standard, flows(plug, wave, other));
  };
  BOOST_TEST(judged(1.96).checks.size() == 27u);  // 3 pairs x 3 profiles x 3 bins
  BOOST_TEST(all_inside(judged(1.96)));
  BOOST_TEST(std::abs(check_with(judged(1.96), "L/W 4 less L/W 1, bins 1 and 6: U over its largest value").values[0] +
                      0.02) < 1e-12);
  BOOST_TEST(outside(judged(1.8)).size() == 6u);  // three bins, against plug and against wave
  BOOST_TEST(judged(1.96).plot.series.size() == 3u);
}

BOOST_AUTO_TEST_CASE(skewness_of_uy_is_judged_by_itself) {
  const auto judged = [](double skewness) {
    MadeChannel other = slug;
    other.skewness_y = skewness;
    return estimate_structures_y(claim, Tier::standard, flows(plug, wave, other));
  };
  BOOST_TEST(judged(0.6).checks.size() == 4u);
  BOOST_TEST(all_inside(judged(0.6)));
  BOOST_TEST(outside(judged(0.4)).size() == 4u);
}

BOOST_AUTO_TEST_CASE(a_claim_without_one_of_the_structures_is_refused) {
  SceneRecords records = flows(plug, wave, slug);
  records.erase("a");
  BOOST_CHECK_THROW(estimate_structures(claim, Tier::standard, records), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
