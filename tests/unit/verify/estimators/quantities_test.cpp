// The estimator whose checks stand in the claim file, and what it refuses.
#include "gpf/measure/quantities.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/scene/scene_file.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/quantity_expression.hpp"

namespace gpf {
namespace {

/// Two replicas of a channel of six bins with T = 2 b in bin b = 1, 2, ... 6 (and .2 more in the second) and wall
/// losses 3 and 5 per time.
SceneRecords made() {
  SceneRecords records;
  for (const double more : {0.0, 0.2})
    records["made"].push_back(test::made_record(test::channel_text(0.3), [&](const test::SetTally& set) {
      set(Tally::measured_time, 0, 1);
      set(Tally::samples, 0, 1);
      for (int b = 0; b < 6; ++b) {
        set(Tally::count, b, 30);
        set(Tally::freedom, b, 29);
        set(Tally::ux2, b, 29 * (2 * (b + 1) + more));
        set(Tally::cy2, b, 30 * (2 * (b + 1) + more));
      }
      set(Tally::wall_loss, 0, 3);
      set(Tally::wall_loss, 1, 5);
    }));
  return records;
}

std::vector<double> values(const std::string& text) {
  const SceneRecords records = made();
  return values_of(parse_quantity_expression(text), SceneValues("made", records.at("made")));
}

std::string refusal(const std::string& text) {
  try {
    parse_quantity_expression(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

BOOST_AUTO_TEST_SUITE(quantities_test, *boost::unit_test::tolerance(1e-12))

BOOST_AUTO_TEST_CASE(a_quantity_has_a_value_at_each_place) {
  BOOST_TEST(values("granular_temperature at lower wall") == (std::vector<double>{2, 2.2}),
             boost::test_tools::per_element());
  BOOST_TEST(values("granular_temperature at upper wall")[0] == 12);
  BOOST_TEST(values("granular_temperature at walls")[0] == 7);   // (2 + 12)/2
  BOOST_TEST(values("granular_temperature at centre")[0] == 7);  // (6 + 8)/2
  BOOST_TEST(values("granular_temperature at bin 2")[0] == 4);
  BOOST_TEST(values("wall_loss_upper")[0] == 5);
}

BOOST_AUTO_TEST_CASE(two_are_compared_replica_by_replica) {
  BOOST_TEST(values("wall_loss_lower / wall_loss_upper")[0] == 0.6);
  BOOST_TEST(values("granular_temperature at bin 6 - granular_temperature at bin 1") == (std::vector<double>{10, 10}),
             boost::test_tools::per_element());
  BOOST_TEST(values("granular_temperature at bin 1 / granular_temperature at bin 2")[1] == 2.2 / 4.2);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_read_is_refused) {
  for (const char* text : {"", "two words", "mean_velocity at the centre", "mean_velocity at bin 0",
                           "mean_velocity at bin 2x", "mean_velocity at", " / mean_flow", "mean_flow * 2"})
    BOOST_TEST(refusal(text).find("cannot be read") != std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(what_a_scene_does_not_measure_is_refused_before_it_runs) {
  const SceneFile file = parse_scene(test::channel_text(0.3), "made.toml");
  const auto refused = [&](const std::string& value) -> std::string {
    Claim claim;
    claim.checks.push_back({"", value, {}, 0.0, {}});
    try {
      require_quantities(claim, "made", file.scene, file.run);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  BOOST_TEST(refused("mean_flow") == "");
  BOOST_TEST(refused("mean_velocity at bin 6 / mean_flow") == "");
  BOOST_TEST(refused("mean_flaw").find("did you mean 'mean_flow'?") != std::string::npos);
  BOOST_TEST(refused("mean_flow / mean_flaw").find("mean_flaw") != std::string::npos);
  BOOST_TEST(refused("mean_velocity").find("no place is named") != std::string::npos);
  BOOST_TEST(refused("mean_flow at centre").find("leave out the place") != std::string::npos);
  BOOST_TEST(refused("mean_velocity at bin 7").find("it has 6 values") != std::string::npos);
  const SceneFile waves = parse_scene(test::channel_text(0.3) + "density_modes = 2\n", "made.toml");
  Claim modes;
  modes.checks.push_back({"", "density_power_odd at bin 2", {}, 0.0, {}});
  BOOST_CHECK_NO_THROW(require_quantities(modes, "made", waves.scene, waves.run));
  modes.checks.front().value = "density_power_odd at walls";
  BOOST_CHECK_THROW(require_quantities(modes, "made", waves.scene, waves.run), InputError);
  BOOST_TEST(refused("compressibility").find("no quantity") != std::string::npos);  // of periodic scenes
}

/// Without the ends that the page names once for several: "_x", "_lower", ...
BOOST_AUTO_TEST_CASE(the_guide_names_every_quantity) {
  const std::string page = read_text(GPF_REFERENCE "/guide/quantities.md");
  std::size_t count = 0;
  for (const char* geometry : {"channel", "periodic"}) {
    const bool channel = std::string(geometry) == "channel";
    const SceneFile file =
        parse_scene(channel ? test::channel_text(0.3, "") + "density_modes = 2\n"
                            : "[scene]\ngeometry = \"periodic\"\nparticles = 100\nlength_over_width = 1\n"
                              "area_fraction = 0.3\nnormal_restitution = 1\n[run]\nduration = 1\n",
                    "made.toml");
    const TallyLayout layout(file.run);
    const std::vector<double> totals(layout.size(), 0.0);
    for (const Quantity& q : derive_quantities(file.scene, layout, totals)) {
      ++count;
      std::string name = q.name;
      while (page.find('`' + name) == std::string::npos && name.find('_') != std::string::npos)
        name.resize(name.rfind('_'));
      BOOST_TEST(page.find('`' + name) != std::string::npos, q.name);
      const std::string end = q.name.substr(name.size());
      BOOST_TEST(
          (end.empty() || page.find('`' + end + '`') != std::string::npos || page.find(end + '`') != std::string::npos),
          q.name);
    }
  }
  BOOST_TEST(count > 50U);
}

BOOST_AUTO_TEST_CASE(bands_are_those_of_the_claim) {
  Claim claim = test::made_claim(0.5);
  claim.checks = {{"centre", "granular_temperature at centre", 7.0, {}, {}},
                  {"hot", "granular_temperature at bin 6", {}, 10.0, {}},
                  {"cold", "granular_temperature at bin 1", {}, 1.0, 3.0}};
  const auto band = [&](const char* label) {
    return test::check_with(estimate_quantities(claim, Tier::quick, made()), label).band;
  };
  BOOST_TEST(band("centre").lo == 6.5);
  BOOST_TEST(band("centre").hi == 7.5);
  BOOST_TEST(band("hot").lo == 9.5);
  BOOST_TEST(band("hot").contains(1e300));
  BOOST_TEST(band("cold").lo == 0.5);
  BOOST_TEST(band("cold").hi == 3.5);
  claim.tolerance_unit = "relative";
  BOOST_TEST(band("centre").lo == 3.5);
  BOOST_TEST(band("cold").hi == 4.5);
  BOOST_TEST(test::check_with(estimate_quantities(claim, Tier::quick, made()), "made: hot").values[1] == 12.2);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace gpf
