#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(balances)

constexpr int bins = 6, disks = 180;
constexpr double pressure = 3;

/// A channel in balance: 30 disks in each bin, a constant P_yy, and P_xy that grows by g for each disk passed. Wall
/// bins: the mean height of the disks there is that of the final state, so P_xy is built from it. `shift`: bins by
/// which P_xy is misplaced; `shear`: friction of the walls in units of the weight; `lost`: share of P_yy missing in
/// bin 2.
Record channel(double shear = 1, int shift = 0, double lost = 0) {
  const Scene scene = parse_scene(channel_text(0.2), "test").scene;
  const double length = scene.length(), area = length / bins, weight = disks * scene.gravity / length;
  const State state = start_state(scene);
  const auto height = [&](int b) {  // of the disks in bin b, within it
    if (b > 0 && b < bins - 1) return 0.5;
    double sum = 0, count = 0;
    for (const Vec2 r : state.position)
      if (static_cast<int>(r.y * bins) == b) sum += r.y * bins - b, count += 1;
    return sum / count;
  };
  return made_record(channel_text(0.2), [&](const SetTally& set) {
    for (int wall = 0; wall < 2; ++wall) {
      set(Tally::wall_normal, wall, pressure * length);
      set(Tally::wall_tangential, wall, shear * 0.5 * weight * length);
    }
    for (int b = 0; b < bins; ++b) {
      set(Tally::count, b, 30);
      set(Tally::freedom, b, 29);
      const double kinetic = 1;  // of P_yy; the rest is collisional
      set(Tally::cy2, b, kinetic * area);
      set(Tally::stress_yy, b, (pressure * (b == 1 ? 1 - lost : 1) - kinetic) * area);
      const int at = b + shift;
      const double passed = (at + 1 - height(b)) / bins;  // share of the disks below a height, averaged over the bin
      set(Tally::stress_xy, b, (passed - 0.5) * weight * area);
    }
  });
}

Claim claim() { return made_claim(0.03, {{"shear_margin", 0.05}, {"whole_channel_margin", 0.01}}); }

BOOST_AUTO_TEST_CASE(a_channel_in_balance_deviates_by_round_off_only) {
  SceneRecords records;
  records["a"] = {channel(), channel()};
  const Evidence evidence = estimate_momentum_balance(claim(), Tier::quick, records);
  BOOST_TEST(evidence.checks.size() == 2u + 3 + 1 + 3 + 1);
  for (const Check& check : evidence.checks)
    for (const double value : check.values) BOOST_TEST(std::abs(value) < 1e-12, check.label << ": " << value);
}

BOOST_AUTO_TEST_CASE(friction_off_by_two_per_cent_is_seen) {
  SceneRecords records;
  records["a"] = {channel(1.02)};
  const std::vector<std::string> labels = outside(estimate_momentum_balance(claim(), Tier::quick, records));
  BOOST_TEST_REQUIRE(labels.size() == 1u);
  BOOST_TEST(labels[0].find("friction") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_pressure_missing_in_one_bin_is_seen_there_and_in_the_virial) {
  SceneRecords records;
  records["a"] = {channel(1, 0, 0.10)};
  const Evidence evidence = estimate_momentum_balance(claim(), Tier::quick, records);
  // Half of it in the pair of bins, a sixth in the mean.
  BOOST_TEST(check_with(evidence, "P_yy of bins 2 and 5").values[0] == -0.05, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(check_with(evidence, "y virial").values[0] == -0.10 / 6, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(outside(evidence).size() == 2u);
}

BOOST_AUTO_TEST_CASE(profiles_shifted_by_a_bin_are_seen) {
  SceneRecords records;
  records["a"] = {channel(1, 1)};
  const Evidence evidence = estimate_momentum_balance(claim(), Tier::quick, records);
  BOOST_TEST(check_with(evidence, "mean of P_xy").values[0] == 2.0 / bins, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(outside(evidence).size() == 1u);
}

BOOST_AUTO_TEST_CASE(shear_stress_of_the_wrong_size_is_seen) {
  std::vector<Record> records{channel()};
  const TallyLayout layout(bins);
  for (int b = 0; b < bins; ++b) records[0].sums[layout.at(Tally::stress_xy, b)] *= 0.9;
  SceneRecords scenes;
  scenes["a"] = records;
  const std::vector<std::string> labels = outside(estimate_momentum_balance(claim(), Tier::quick, scenes));
  BOOST_TEST_REQUIRE(labels.size() == 1u);  // 10 % of P_xy exceeds .05 of the weight next to the wall only
  BOOST_TEST(labels[0].find("P_xy of bins 1 and 6") != std::string::npos);
}

/// Work 100 per time, of which `pairs` and twice `wall` are lost, the rest stored.
Record powered(double pairs, double wall, double stored) {
  return made_record(channel_text(0.2), [&](const SetTally& set) {
    set(Tally::gravity_work, 0, 100);
    set(Tally::pair_loss, 0, pairs);
    for (int k = 0; k < 2; ++k) set(Tally::wall_loss, k, wall);
    set(Tally::energy_change, 0, stored);
    set(Tally::momentum, 0, 100);  // N <u_x>; g = 1
  });
}

BOOST_AUTO_TEST_CASE(what_is_not_lost_must_be_stored) {
  const Claim claim = made_claim(0.01, {{"round_off", 1e-12}});
  SceneRecords steady, heating, leaking;
  steady["a"] = {powered(60, 20, 0)};
  heating["a"] = {powered(60, 19, 2)};
  leaking["a"] = {powered(60, 19.9, 0)};
  BOOST_TEST(all_inside(estimate_energy_balance(claim, Tier::quick, steady)));
  const Evidence hot = estimate_energy_balance(claim, Tier::quick, heating);
  BOOST_TEST(check_with(hot, "losses over the power of gravity").values[0] == -0.02,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(check_with(hot, "losses and energy gained").values[0] == 0);
  const std::vector<std::string> labels = outside(estimate_energy_balance(claim, Tier::quick, leaking));
  BOOST_TEST_REQUIRE(labels.size() == 1u);  // 0.2 % missing: within the steady margin, far beyond round-off
  BOOST_TEST(labels[0].find("losses and energy gained") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
