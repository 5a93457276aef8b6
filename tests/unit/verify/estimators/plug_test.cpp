#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "unit/verify/estimators/made_flow.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(plug)

const auto close = boost::test_tools::tolerance(1e-9);

/// U, T and disks in the bins from the wall.
struct Fields {
  std::vector<double> velocity, temperature, disks;
};

Record flow(double restitution, const Fields& fields) {
  return made_flow(flow_text(0.5, restitution, 0.9), [&](int b) {
    const auto k = static_cast<std::size_t>(from_wall(b));
    MadeBin bin;
    bin.disks = fields.disks[k];
    bin.mean = fields.velocity[k];
    bin.variance_y = fields.temperature[k];
    bin.variance_x = fields.temperature[k] * (1 - 1 / bin.disks);  // divided by n - 1 in the end
    return bin;
  });
}

const Fields parabolic{{1, 2, 2.5}, {0.5, 0.4, 0.35}, {25, 28, 29.5}},
    plug{{1, 3, 3.1}, {0.9, 0.2, 0.19}, {20, 30, 30.5}};

Evidence forms(const Fields& elastic, const Fields& last) {
  SceneRecords records;
  records["a"] = {flow(0.8, last)};
  records["b"] = {flow(0.99, elastic)};
  return estimate_plug_forms(made_claim(0, {{"plug_from", 2}, {"shear_from", 1}, {"shear_to", 2}}), Tier::standard,
                             records);
}

BOOST_AUTO_TEST_CASE(flat_inside_and_steep_outside) {
  const Evidence evidence = forms(parabolic, plug);
  BOOST_TEST(evidence.checks.size() == 7u);
  BOOST_TEST(all_inside(evidence));
  // a parabola about the centre: (1.5^2 - 0.5^2)/(2.5^2 - 1.5^2)
  BOOST_TEST(check_with(evidence, "of U, against a parabola").band.hi == 0.5, close);
  BOOST_TEST(check_with(evidence, "of U, against a parabola").values[0] == 0.05, close);
  BOOST_TEST(check_with(evidence, "ratio of gradients of T less").values[0] == 0.01 / 0.7 - 0.5, close);
}

BOOST_AUTO_TEST_CASE(a_flow_without_a_plug_is_seen) {
  BOOST_TEST(outside(forms(plug, parabolic)).size() == 6u);  // a parabola itself lies on the edge of its check
  Fields sheared = plug;
  sheared.velocity = {1, 3, 4.2};
  BOOST_TEST(outside(forms(parabolic, sheared)).size() == 2u);
}

/// Area fractions of the centre at e_n .99, .85 and .80.
Evidence density(double elastic, double knee, double last) {
  const double per_fraction = 180 / (6 * 0.5);  // disks per bin: N/bins at the mean area fraction 0.5
  SceneRecords records;
  const auto add = [&](const char* name, double restitution, double fraction) {
    const double n = fraction * per_fraction;
    records[name] = {flow(restitution, {{1, 2, 3}, {1, 1, 1}, {n, n, n}})};
  };
  add("a", 0.99, elastic);
  add("b", 0.85, knee);
  add("c", 0.8, last);
  return estimate_plug_density(made_claim(0.05, {{"close_packing", 0.9}, {"saturated", 0.85}}), Tier::standard,
                               records);
}

BOOST_AUTO_TEST_CASE(the_density_of_the_plug_saturates) {
  const Evidence evidence = density(0.6, 0.88, 0.89);
  BOOST_TEST(evidence.checks.size() == 3u);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(check_with(evidence, "e_n 0.85, beta_w 0.9: area fraction").values[0] == 0.88, close);
  BOOST_TEST(check_with(evidence, "rise per unit").values[0] == 0.01 / 0.05 - 0.28 / 0.14, close);
  BOOST_TEST(outside(density(0.6, 0.7, 0.89)).size() == 2u);
  BOOST_TEST(outside(density(0.6, 0.78, 0.79)).size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_thin_shear_layer_holds_most_of_the_velocity_difference) {
  SceneRecords records;
  records["a"] = {flow(0.8, {{1, 2.7, 3}, {1, 1, 1}, {30, 30, 30}})};
  const auto of = [&] {
    return estimate_shear_layer(made_claim(0, {{"layer_bins", 1}, {"least_share", 0.8}}), Tier::standard, records);
  };
  BOOST_TEST(of().checks.at(0).values[0] == 0.85, close);
  BOOST_TEST(all_inside(of()));
  records["a"] = {flow(0.8, {{1, 2.4, 3}, {1, 1, 1}, {30, 30, 30}})};
  BOOST_TEST(outside(of()).size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
