#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/vec2.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(energy)

const std::string periodic =
    "[scene]\ngeometry = \"periodic\"\nparticles = 64\nlength_over_width = 1\narea_fraction = 0.3\n"
    "normal_restitution = 1\n[run]\nduration = 1\nbins = 1\n";
const std::string channel =
    "[scene]\ngeometry = \"channel\"\nparticles = 64\nwidth_over_diameter = 12\narea_fraction = 0.2\n"
    "normal_restitution = 1\nwall_tangential_restitution = 1\n[run]\nduration = 4\nbins = 1\n";

Claim claim() { return made_claim(1e-12, {{"collisions", 1e7}}); }

Record resting() {
  Record record = made_record(periodic, [](const SetTally&) {});
  record.counts.pair_contacts = 20'000'000;
  return record;
}

/// 64 disks that fell for a time 4: velocity +4 each, work 64 x 16/2.
Record falling(double gain) {
  Record record = made_record(channel, [&](const SetTally& set) {
    set(Tally::gravity_work, 0, 512);
    set(Tally::energy_change, 0, 512 + gain);
  });
  record.time = 4;
  for (Vec2& v : record.final_state.velocity) v.x += 4;
  return record;
}

BOOST_AUTO_TEST_CASE(states_that_conserve_pass) {
  SceneRecords records;
  records["box"] = {resting()};
  records["channel"] = {falling(0)};
  const Evidence evidence = estimate_energy(claim(), Tier::quick, records);
  BOOST_TEST(evidence.checks.size() == 6u);
  for (const Check& check : evidence.checks) BOOST_TEST(check.exact);
  BOOST_TEST(all_inside(evidence));
}

BOOST_AUTO_TEST_CASE(a_part_in_ten_to_the_eleven_is_seen) {
  SceneRecords records;
  records["box"] = {resting()};
  for (Vec2& v : records["box"][0].final_state.velocity) v = (1 + 1e-11) * v;
  const std::vector<std::string> box = outside(estimate_energy(claim(), Tier::quick, records));
  BOOST_TEST_REQUIRE(box.size() == 1u);
  BOOST_TEST(box[0].find("energy drift") != std::string::npos);

  records.clear();
  records["channel"] = {falling(512e-11)};
  const std::vector<std::string> fall = outside(estimate_energy(claim(), Tier::quick, records));
  BOOST_TEST_REQUIRE(fall.size() == 1u);
  BOOST_TEST(fall[0].find("less work of gravity") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(momentum_and_too_few_collisions_are_seen) {
  SceneRecords records;
  records["box"] = {resting()};
  records["box"][0].counts.pair_contacts = 9'999'999;
  for (Vec2& v : records["box"][0].final_state.velocity) v.y = -v.y;  // keeps energy and zero momentum
  BOOST_TEST(outside(estimate_energy(claim(), Tier::quick, records)).size() == 1u);
  Vec2& first = records["box"][0].final_state.velocity[0];
  first = {-first.x, -first.y};  // keeps the energy
  BOOST_TEST(outside(estimate_energy(claim(), Tier::quick, records)).size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
