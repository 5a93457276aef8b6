// phase.*: regions of a diagram, and how much the walls matter, from records whose modes are set by hand.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "gpf/base/error.hpp"
#include "unit/verify/evidence_means.hpp"
#include "unit/verify/fake_run.hpp"
#include "verify/estimators/density_structure.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/store.hpp"

using namespace gpf;

namespace {

/// A channel of four replicas: with `mode` at 40 times the noise, or without any (plug).
void add(SceneRecords& records, const std::string& length, const std::string& width, const std::string& beta,
         std::optional<Tally> mode) {
  const SceneFile file = parse_scene(
      "[scene]\ngeometry = \"channel\"\narea_fraction = 0.2\nlength_over_width = " + length +
          "\nwidth_over_diameter = " + width + "\nnormal_restitution = 0.9\nwall_tangential_restitution = " + beta +
          "\n[run]\nstart_up = 0\nduration = 16\nbins = 2\ndensity_modes = 2\n",
      "scene.toml");
  const TallyLayout layout(file.run);
  for (int r = 0; r < 4; ++r) {
    Record record = test::fake_record(replica_of(file, r, 0), 16);
    for (std::size_t b = 0; b < record.blocks; ++b) {
      double* row = record.sums.data() + b * layout.size();
      using enum Tally;
      for (const Tally t : {mode_even, mode_odd, mode_varicose, mode_noise_even, mode_noise_odd, mode_noise_varicose})
        for (std::size_t k = 0; k < layout.extent(t); ++k) row[layout.at(t) + k] = 0.5;
      row[layout.at(band_cos)] = 0.5;
      if (mode) row[layout.at(*mode)] = 20;
    }
    records["map: L " + length + ", W " + width + ", " + beta].push_back(std::move(record));
  }
}

/// Plugs at L/W 1, waves at 2, slugs at 4, for two walls; but a slug at L/W 2 between smooth walls.
SceneRecords ladder() {
  SceneRecords records;
  for (const char* beta : {"0.1", "0.9"}) {
    add(records, "1", "12", beta, std::nullopt);
    add(records, "2", "12", beta, beta == std::string("0.1") ? Tally::mode_odd : Tally::mode_even);
    add(records, "4", "12", beta, Tally::mode_even);
  }
  return records;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(phase_diagram_claims)

BOOST_AUTO_TEST_CASE(each_region_is_judged_by_all_of_its_runs) {
  Claim claim;
  claim.structures = {
      {"longest", "slug"}, {"shortest", "plug"}, {"somewhere between", "wave"}, {"everywhere", "slug or wave"}};
  claim.parameters = {{"alike", 0.75}, {"most_varicose", 0.1}};
  const Evidence evidence = estimate_phase_diagram(claim, Tier::full, ladder());
  // everywhere 16 of 24; longest; shortest; between 2 of the 4 odd replicas; alike 16 of 24, as the two points at L/W 2
  // differ from each other; none
  const std::vector<double> expected{16.0 / 24, 1, 1, 0.5, 16.0 / 24, 0};
  BOOST_TEST(test::means(evidence) == expected, boost::test_tools::per_element());
  BOOST_TEST(evidence.checks[2].values.size() == 8U);
  for (const Check& check : evidence.checks) BOOST_TEST(check.share);
  BOOST_TEST(evidence.notes.size() == 6U);
  BOOST_TEST(evidence.drawings.size() == 3U);  // one row of the diagram
  BOOST_TEST(evidence.plot.ylabel == "beta_w of the lower wall");
  BOOST_TEST(evidence.plot.series.size() == 3U);  // plug, slug, wave
}

BOOST_AUTO_TEST_CASE(width_is_an_axis_with_regions_too) {
  SceneRecords records;
  for (const char* length : {"1", "2"}) {
    add(records, length, "12", "0.5", std::nullopt);
    add(records, length, "20", "0.5", Tally::mode_varicose);
  }
  Claim claim;
  claim.structures = {{"narrow", "plug"}, {"widest or longest", "varicose wave"}};
  claim.parameters = {{"most_varicose", 0.1}};
  const Evidence evidence = estimate_phase_diagram(claim, Tier::full, records);
  BOOST_TEST(test::means(evidence) == (std::vector<double>{1, 2.0 / 3, 0.5}), boost::test_tools::per_element());
  BOOST_TEST(evidence.checks[0].values.size() == 8U);   // two of the four points
  BOOST_TEST(evidence.checks[1].values.size() == 12U);  // three of them
  BOOST_TEST(evidence.plot.ylabel == "W/d");
  claim.parameters["alike"] = 0.75;  // nothing to compare with: no value, no verdict
  BOOST_TEST(estimate_phase_diagram(claim, Tier::full, records).checks[2].values.empty());
}

BOOST_AUTO_TEST_CASE(each_width_has_its_own_length_between) {
  SceneRecords records;
  for (const char* length : {"1", "2", "3", "4"}) {
    const bool middle = length == std::string("2"), long_middle = length == std::string("3");
    add(records, length, "12", "0.5", middle ? std::optional(Tally::mode_odd) : std::nullopt);
    add(records, length, "20", "0.5", long_middle ? Tally::mode_odd : Tally::mode_even);
  }
  Claim claim;
  claim.structures = {{"somewhere between", "wave"}};
  const Evidence evidence = estimate_phase_diagram(claim, Tier::full, records);
  BOOST_TEST(evidence.checks[0].values == std::vector<double>(4, 1), boost::test_tools::per_element());
  BOOST_TEST(evidence.checks[0].label.find("L/W 2, 3") != std::string::npos, evidence.checks[0].label);
}

BOOST_AUTO_TEST_CASE(pictures_are_compared_run_by_run) {
  Claim claim;
  claim.parameters = {{"agreeing", 0.8}};
  claim.structures = {{"map: L 1, W 12, 0.1 #1", "plug"},
                      {"map: L 2, W 12, 0.1 #4", "wave"},
                      {"map: L 4, W 12, 0.1 #2", "wave"},
                      {"map: L 4, W 12, 0.9 #2", "between the classes"}};
  const Evidence evidence = estimate_picture_labels(claim, Tier::full, ladder());
  BOOST_TEST(test::means(evidence) == std::vector<double>{0.5}, boost::test_tools::per_element());
  BOOST_TEST(evidence.drawings.size() == 4U);
  BOOST_TEST(evidence.notes.size() == 4U);
  for (const std::string name : {"map: L 1, W 12, 0.1 #5", "map: L 1, W 12, 0.1 #0", "map: L 1, W 12, 0.1",
                                 "map: L 9, W 12, 0.1 #1", "map: L 1, W 12, 0.1 #x"}) {
    claim.structures = {{name, "plug"}};
    BOOST_CHECK_THROW(estimate_picture_labels(claim, Tier::full, ladder()), InputError);
  }
  claim.structures = {{"map: L 1, W 12, 0.1 #1", "slug or clumps"}};
  BOOST_CHECK_THROW(estimate_picture_labels(claim, Tier::full, ladder()), InputError);
  claim.structures = {{"map: L 1, W 12, 0.1 #1", "ripple"}};
  BOOST_CHECK_THROW(estimate_picture_labels(claim, Tier::full, ladder()), InputError);
}

BOOST_AUTO_TEST_CASE(an_unknown_region_or_structure_is_refused) {
  Claim claim;
  claim.structures = {{"longer", "slug"}};
  BOOST_CHECK_THROW(estimate_phase_diagram(claim, Tier::full, ladder()), InputError);
  claim.structures = {{"longest", "slugs"}};
  BOOST_CHECK_THROW(estimate_phase_diagram(claim, Tier::full, ladder()), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
