// Estimators that run engines themselves: short versions of what the claims ask for.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/scene/scene_file.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/simulate.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(codes)

const std::string scene_text =
    "[scene]\ngeometry = \"channel\"\nparticles = 36\nwidth_over_diameter = 8\narea_fraction = 0.5\n"
    "normal_restitution = 0.9\nwall_tangential_restitution = 0.5\n"
    "[run]\nstart_up = 20\nduration = 200\nsample_interval = 0.0625\nbins = 4\n";

const std::vector<Record>& replicas() {
  static const std::vector<Record> records = [] {
    std::vector<Record> made;
    for (int seed = 1; seed <= 2; ++seed) {
      SceneFile file = parse_scene(scene_text, "test");
      file.scene.seed = static_cast<std::uint64_t>(seed);
      made.push_back(*simulate(file));
    }
    return made;
  }();
  return records;
}

Claim two_codes_claim() {
  return made_claim(0.15, {{"velocity_margin", 0.05}, {"same_contacts", 200}, {"window_quick", 40}});
}

BOOST_AUTO_TEST_CASE(two_codes_agree_contact_by_contact_and_in_their_fields) {
  SceneRecords records;
  records["a"] = replicas();
  const Evidence evidence = estimate_two_codes(two_codes_claim(), Tier::quick, records);
  BOOST_TEST(evidence.checks.size() == 1u + 2 + 2);
  for (const double alike : check_with(evidence, "contacts alike").values) BOOST_TEST(alike == 200);
  // A small box fluctuates: U by 5 %, T by 10 % of its maximum over such a window. Three times that must not happen.
  for (const Check& check : evidence.checks)
    if (!check.exact)
      for (const double value : check.values) BOOST_TEST(std::abs(value) < 0.3, check.label << ": " << value);
  BOOST_TEST(evidence.extra_cpu_seconds > 0);
}

BOOST_AUTO_TEST_CASE(a_field_that_the_engine_got_wrong_shows_as_the_difference) {
  SceneRecords right, wrong;
  right["a"] = wrong["a"] = replicas();
  const TallyLayout layout(4);
  for (Record& record : wrong["a"])  // variances of bin pair 2, 3 doubled in the record
    for (std::size_t b = 0; b < record.blocks; ++b)
      for (const int bin : {1, 2})
        for (const Tally tally : {Tally::ux2, Tally::cy2}) record.sums[b * layout.size() + layout.at(tally, bin)] *= 2;
  const auto difference = [&](const SceneRecords& records) {
    return check_with(estimate_two_codes(two_codes_claim(), Tier::quick, records), "T/T_max of bins 2 and 3").values[0];
  };
  const double shift = difference(wrong) - difference(right);
  BOOST_TEST(shift < -0.3);  // T of these bins over the largest T, at most 1, doubled
}

BOOST_AUTO_TEST_CASE(collapse_is_seen_without_the_tc_model_only) {
  const Claim claim = made_claim(0.1, {{"velocity_margin", 0.05}, {"contacts_at_once", 10}, {"tc_time", 1e-6}});
  const Evidence evidence = estimate_tc(claim, Tier::quick, {});
  BOOST_TEST(evidence.checks.size() == 6u);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(check_with(evidence, "nu 0.56, e_n 0.5, no TC").values[0] >= 10);
}

BOOST_AUTO_TEST_CASE(flows_with_different_t_c_are_compared_with_the_shortest) {
  const auto with = [](const char* tc, double velocity) {
    return made_record(channel_text(0.2, std::string("tc_time = ") + tc + "\n"), [&](const SetTally& set) {
      for (int b = 0; b < 6; ++b) {
        set(Tally::count, b, 30);
        set(Tally::freedom, b, 30);
        set(Tally::cx, b, 30 * velocity);
        set(Tally::ux2, b, 30);
        set(Tally::cy2, b, 30);
      }
    });
  };
  SceneRecords records;
  records["long"] = {with("1e-4", 5.5)};
  records["short"] = {with("1e-6", 5)};
  records["other"] = {made_record(channel_text(0.4), [](const SetTally&) {})};  // alone: compared with nothing
  const Claim claim = made_claim(0.2, {{"velocity_margin", 0.05}, {"contacts_at_once", 10}, {"tc_time", 1e-6}});
  const Evidence evidence = estimate_tc(claim, Tier::quick, records);
  BOOST_TEST(evidence.checks.size() == 6u + 3 + 3);
  BOOST_TEST(check_with(evidence, "long less short: U/U_0 of bins 1 and 6").values[0] == 0.1,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(check_with(evidence, "long less short: T/T_max of bins 1 and 6").values[0] == 0);
  BOOST_TEST(outside(evidence).size() == 3u);  // U of three pairs of bins
}

BOOST_AUTO_TEST_CASE(lattices_reach_what_is_claimed) {
  const Evidence evidence = estimate_lattices(made_claim(0, {{"collisions_per_disk", 5}}), Tier::quick, {});
  BOOST_TEST(evidence.checks.size() == 15u);
  BOOST_TEST(all_inside(evidence));
}

BOOST_AUTO_TEST_CASE(overhead_is_a_share_of_the_events) {
  const Claim claim = made_claim(0, {{"limit", 0.15},
                                     {"growth_per_decade", 0.03},
                                     {"collisions_per_disk", 5},
                                     {"largest_disks_quick", 1000},
                                     {"largest_disks_standard", 1000}});
  const Evidence evidence = estimate_overhead(claim, Tier::quick, {});
  BOOST_TEST(evidence.checks.size() == 10u);  // two sizes of five families; growth needs a third size
  for (const Check& check : evidence.checks) {
    BOOST_TEST(check.values[0] > 0);
    BOOST_TEST(check.values[0] < 1);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
