#include "verify/estimators/local_order.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "unit/verify/estimators/sampled_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {
namespace {

/// L/d at which 900 disks fill W/d = 31 to that area fraction.
double length_at(double area_fraction) { return std::numbers::pi * 900 / (4 * 31 * area_fraction); }

/// Random disks without overlap, put down one after the other.
State random_disks(const Scene& scene, std::uint64_t seed) {
  State state;
  const double d = scene.diameter();
  for (std::uint64_t k = 0; state.position.size() < static_cast<std::size_t>(scene.particles); ++k) {
    const Vec2 p{scene.length() * uniform(seed, 2 * k), d / 2 + (1 - d) * uniform(seed, 2 * k + 1)};
    bool free = true;
    for (const Vec2 q : state.position) {
      const double x = std::remainder(p.x - q.x, scene.length());
      free = free && x * x + (p.y - q.y) * (p.y - q.y) > d * d;
    }
    if (free) state.position.push_back(p), state.velocity.push_back(gaussian_pair(seed, k));
  }
  return state;
}

/// Equilibrium elastic disks: a periodic run of the engine.
std::vector<State> equilibrium(double area_fraction, int count) {
  Scene scene;
  scene.geometry = Geometry::periodic;
  scene.particles = 900;
  scene.width_over_diameter = 31;
  scene.length_over_width = length_at(area_fraction) / 31;
  Engine<> engine(scene, start_state(scene));
  std::vector<State> states;
  for (int k = 0; k < count; ++k) {
    engine.advance(1 + 0.1 * k);
    states.push_back(engine.state());
  }
  return states;
}

/// A triangular crystal with rows along x, of 30 by 34 disks 1.03 d apart, each displaced by a Gaussian of .03 d.
std::vector<State> crystal(const Scene& scene, int count) {
  std::vector<State> states;
  for (int s = 0; s < count; ++s) {
    State state;
    const double a = 1.03 * scene.diameter();
    for (int row = 0; row < 34; ++row)
      for (int column = 0; column < 30; ++column) {
        const auto disk = static_cast<std::uint64_t>(30 * row + column);
        const Vec2 shift = gaussian_pair(static_cast<std::uint64_t>(s), disk);
        state.position.push_back({a * (column + 0.5 * (row % 2)) + 0.03 * scene.diameter() * shift.x,
                                  0.02 + a * std::sqrt(0.75) * row + 0.03 * scene.diameter() * shift.y});
        state.velocity.push_back(gaussian_pair(99, disk));
      }
    states.push_back(state);
  }
  return states;
}

Record gas_record() {
  const std::string text = long_channel(900, length_at(0.2));
  const Scene scene = made_record(text, [](const SetTally&) {}).scene;
  std::vector<State> states;
  for (std::uint64_t s = 1; s < 20; ++s) states.push_back(random_disks(scene, s));
  return sampled_record(text, states);
}

Record crystal_record() {
  const std::string text = long_channel(1020, 30 * 1.03);
  return sampled_record(text, crystal(made_record(text, [](const SetTally&) {}).scene, 4));
}

Record fluid_record(double area_fraction) {
  return sampled_record(long_channel(900, length_at(area_fraction)), equilibrium(area_fraction, 20));
}

/// Class of the inner bins, where the walls that the periodic run does not have play no part.
std::string class_of(const Record& record) {
  return name_of(classify(local_order(PairFunctions(record, {5, 6, 7, 8, 9, 10}))));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(local_order_classes)

BOOST_AUTO_TEST_CASE(random_disks_are_a_gas) { BOOST_TEST(class_of(gas_record()) == "gas"); }

BOOST_AUTO_TEST_CASE(equilibrium_disks_are_a_gas_then_between_then_a_liquid) {
  BOOST_TEST(class_of(fluid_record(0.25)) == "gas");
  BOOST_TEST(class_of(fluid_record(0.43)) == "between the classes");
  BOOST_TEST(class_of(fluid_record(0.6)) == "liquid");
}

BOOST_AUTO_TEST_CASE(a_thermal_triangular_lattice_is_a_crystal) {
  const Record record = crystal_record();
  BOOST_TEST(class_of(record) == "crystal");
  BOOST_TEST(PairFunctions(record, {8}).neighbours() == 6, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(between_freezing_and_melting_there_is_no_class) {
  BOOST_TEST(!classify({.shell = 1.3, .split = 1.0, .hexatic = 0.75}));
  BOOST_TEST(!classify({.shell = 1.4, .split = 1.2, .hexatic = 0.85}));  // hexatic, but no crystal
  BOOST_TEST(name_of(classify({.shell = 1.2, .split = 1.0, .hexatic = 0.69})) == "liquid");
}

BOOST_AUTO_TEST_CASE(each_claim_sees_which_bin_is_not_what_is_stated) {
  SceneRecords liquid, solid;
  const Record fluid = fluid_record(0.6), lattice = crystal_record();
  liquid["a"] = {fluid, fluid};
  solid["a"] = {lattice, lattice};
  const Claim claim = made_claim(0);
  BOOST_TEST(outside(estimate_liquid_order(claim, Tier::quick, liquid)).empty());
  BOOST_TEST(outside(estimate_liquid_order(claim, Tier::quick, solid)).size() >= 18u);
  // A crystal everywhere: right at the centre, wrong in the two bins that should be a gas.
  const std::vector<std::string> wrong = outside(estimate_plug_order(claim, Tier::quick, solid));
  BOOST_REQUIRE(wrong.size() == 2u);
  BOOST_TEST(wrong[0].find("bins 5 and 14: second shell, for a gas") != std::string::npos);
  BOOST_TEST(wrong[1].find("bins 1 and 18: second shell, for a gas") != std::string::npos);
  for (const std::string& label : outside(estimate_dense_order(claim, Tier::quick, solid)))
    BOOST_TEST(label.find("bins 2 and 17") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
