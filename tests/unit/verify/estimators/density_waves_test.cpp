// waves.*: classes in windows of time, and the shift of the band, from records whose modes are set by hand.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"
#include "unit/verify/evidence_means.hpp"
#include "unit/verify/fake_run.hpp"
#include "verify/estimators/density_structure.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/made_structures.hpp"
#include "verify/store.hpp"

using namespace gpf;

namespace {

/// Walls and start-up of a channel; 16 blocks of one time unit.
std::string text(const std::string& walls, double start_up = 0) {
  return "[scene]\ngeometry = \"channel\"\nparticles = 36\narea_fraction = 0.2\nwidth_over_diameter = 12\n"
         "normal_restitution = 0.9\nwall_tangential_restitution = " +
         walls + "\n[run]\nstart_up = " + std::to_string(start_up) + "\nduration = 16\nbins = 2\ndensity_modes = 2\n";
}

/// A plug until t = 8, then the odd or the even mode k = 1 at 40 times the noise; the band lies `shift` off the middle.
Record record(const SceneFile& file, Tally later, double shift) {
  Record r = test::fake_record(file, 16);
  r.time = file.run.start_up + 16;
  const TallyLayout layout(file.run);
  for (std::size_t b = 0; b < r.blocks; ++b) {
    double* row = r.sums.data() + b * layout.size();
    using enum Tally;
    for (const Tally noise : {mode_noise_even, mode_noise_odd, mode_noise_varicose}) row[layout.at(noise)] = 0.5;
    for (const Tally power : {mode_even, mode_odd, mode_varicose})
      for (int k = 0; k < 2; ++k) row[layout.at(power, k)] = 0.5;
    if (b >= 8) row[layout.at(later)] = 20;
    row[layout.at(band_cos)] = 0.5 * std::cos(2 * std::numbers::pi * shift);
    row[layout.at(band_sin)] = 0.5 * std::sin(2 * std::numbers::pi * shift);
  }
  return r;
}

SceneRecords records(const std::string& walls, Tally later, double shift) {
  SceneRecords result;
  const SceneFile file = parse_scene(text(walls), "scene.toml");
  for (int r = 0; r < 4; ++r) result["scene"].push_back(record(replica_of(file, r, 0), later, shift));
  return result;
}

Claim claim(const std::string& stated, double early_to, double late_from) {
  Claim c;
  c.id = "waves.example";
  c.structures["scene"] = stated;
  c.parameters = {{"early_from", 0.0}, {"early_to", early_to}, {"late_from", late_from}, {"seen", 3.0}};
  return c;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(density_waves)

BOOST_AUTO_TEST_CASE(a_window_has_its_own_contrast) {
  const Record r = record(parse_scene(text("0.6", 4), "scene.toml"), Tally::mode_odd, 0);
  BOOST_TEST(density_contrast_between(r, 4, 12).odd[0] == 1.0);
  BOOST_TEST(density_contrast_between(r, 12, INFINITY).odd[0] == 40.0);
  BOOST_TEST(density_contrast_between(r, 11, 13).odd[0] == 20.5);
  BOOST_TEST(density_contrast_between(r, 12, INFINITY).odd[1] == 1.0);
  // The band's coefficient is 1/2, modes have 1/2 before and 20 after.
  BOOST_TEST(highest_peak_between(r, 4, 12) == 2.0);
  BOOST_TEST(highest_peak_between(r, 12, INFINITY) == 80.0);
  BOOST_CHECK_THROW(density_contrast_between(r, 0, 4), InputError);
}

BOOST_AUTO_TEST_CASE(each_window_is_judged_by_the_structure_that_is_stated) {
  const SceneRecords waves = records("0.6", Tally::mode_odd, 0), slugs = records("0.6", Tally::mode_even, 0);
  const Evidence right = estimate_density_waves(claim("wave", 8, 8), Tier::standard, waves);
  BOOST_REQUIRE(right.checks.size() == 2U);  // walls alike: no shift
  BOOST_TEST(test::means(right) == (std::vector<double>{2, 1}), boost::test_tools::per_element());
  BOOST_TEST(right.checks[0].band.contains(2.0));
  BOOST_TEST(right.checks[1].share);
  BOOST_TEST(
      test::means(estimate_density_waves(claim("wave", 8, 8), Tier::standard, slugs)) == (std::vector<double>{2, 0}),
      boost::test_tools::per_element());
  const Evidence late = estimate_density_waves(claim("wave", 16, 8), Tier::standard, waves);
  BOOST_TEST(!late.checks[0].band.contains(test::means(late)[0]));  // the wave is there before the plug's window ends
  BOOST_TEST(test::means(estimate_density_waves(claim("clumps or slug", 0, 8), Tier::standard, slugs)) ==
                 (std::vector<double>{1}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_shift_counts_toward_the_wall_that_is_named_if_that_is_the_colder_one) {
  const auto checks = [](const std::string& walls, double up, double toward) {
    Claim c = claim("wave", 0, 8);
    c.parameters["toward_rougher"] = toward;
    return test::means(estimate_density_waves(c, Tier::standard, records(walls, Tally::mode_odd, up)));
  };
  BOOST_TEST(std::abs(checks("[0.1, 0.9]", -0.1, 1)[1] - 0.1) < 1e-12);
  BOOST_TEST(std::abs(checks("[0.9, 0.1]", -0.1, 1)[1] + 0.1) < 1e-12);
  BOOST_TEST(std::abs(checks("[0.9, 0.1]", -0.1, -1)[1] - 0.1) < 1e-12);
  BOOST_TEST(std::abs(checks("[0.1, 0.9]", 0, 1)[2]) < 1e-12);  // bins are alike here
  BOOST_TEST(checks("[0.5, 0.5]", -0.1, 1).size() == 1U);
  BOOST_TEST(checks("[0.1, 0.9]", -0.1, 0).size() == 1U);
}

BOOST_AUTO_TEST_CASE(peaks_along_the_channel_are_counted_by_their_power) {
  Claim c;
  c.parameters = {{"peaks", 1.5}};
  const Evidence one = estimate_density_peaks(c, Tier::full, records("0.6", Tally::mode_even, 0));
  BOOST_REQUIRE(one.checks.size() == 1U);
  BOOST_TEST(std::abs(test::means(one)[0] - 1) < 1e-12);  // k = 1 at 20.5 times the noise, k = 2 at the noise
  SceneRecords two = records("0.6", Tally::mode_even, 0);
  for (Record& record : two["scene"]) {
    const TallyLayout layout(record.run);
    for (std::size_t b = 0; b < record.blocks; ++b)
      record.sums[b * layout.size() + layout.at(Tally::mode_even, 1)] =
          record.sums[b * layout.size() + layout.at(Tally::mode_even, 0)];
  }
  BOOST_TEST(std::abs(test::means(estimate_density_peaks(c, Tier::full, two))[0] - 2) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_claim_and_its_scenes_must_agree) {
  const SceneRecords waves = records("0.6", Tally::mode_odd, 0);
  BOOST_CHECK_THROW(estimate_density_waves(claim("ripple", 0, 8), Tier::standard, waves), InputError);
  Claim other = claim("wave", 0, 8);
  other.structures["another"] = "plug";
  BOOST_CHECK_THROW(estimate_density_waves(other, Tier::standard, waves), InputError);
  other.structures = {};
  BOOST_CHECK_THROW(estimate_density_waves(other, Tier::standard, waves), InputError);
}

BOOST_AUTO_TEST_CASE(made_structures_lie_in_the_channel_and_follow_the_seed) {
  for (const Structure structure : structures) {
    const MadeChannel channel{.disks = 200, .length = 3, .shift = -0.12};
    const State a = made_structure(structure, channel, 5), b = made_structure(structure, channel, 5),
                c = made_structure(structure, channel, 6);
    BOOST_TEST(a.position.size() == 200U);
    for (std::size_t i = 0; i < a.position.size(); ++i) {
      BOOST_TEST((a.position[i].x >= 0 && a.position[i].x < 3 && a.position[i].y > 0 && a.position[i].y < 1));
      BOOST_TEST(a.position[i].x == b.position[i].x);
    }
    BOOST_TEST(a.position[0].x != c.position[0].x);
  }
}

// The classifier is a claim of its own; a claim that wants too much of it must be able to fail.
BOOST_AUTO_TEST_CASE(weak_structures_are_not_recognised) {
  Claim c;
  c.parameters = {{"runs", 4.0}, {"snapshots", 4.0}, {"disks", 300.0}, {"modes", 8.0}, {"right", 0.95}, {"shift", 0.1}};
  const Evidence evidence = estimate_structure_classes(c, Tier::quick, {});
  BOOST_TEST(evidence.checks.size() == 22U);
  for (const Series& series : evidence.plot.series) BOOST_TEST(series.y.front() == 0.0);  // strength 0 is a plug
}

BOOST_AUTO_TEST_SUITE_END()
