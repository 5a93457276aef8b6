// Stresses against theory, on made channels that obey the theory, and on channels that do not.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/theory/garzo_dufty.hpp"
#include "gpf/theory/jenkins_richman.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/stress_values.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(rheology_estimators)

constexpr int bins = 12;
constexpr double temperature = 1.7, top_speed = 5;

std::string text(double area_fraction, double restitution = 0.99) {
  return "[scene]\ngeometry = \"channel\"\nparticles = 180\nwidth_over_diameter = 12\narea_fraction = " +
         std::to_string(area_fraction) + "\nnormal_restitution = " + std::to_string(restitution) +
         "\nwall_tangential_restitution = 0.5\n[run]\nstart_up = 2\nduration = 8\nbins = 12\n";
}

/// U = 4 top_speed y (1 - y), uniform T and area fraction; p and viscosity are `pressure` and `viscosity` times
/// Jenkins-Richman's. Bin 6 and its image: viscosity `centre` times that.
Record flow(double area_fraction, double pressure = 1, double viscosity = 1, double centre = 1,
            double restitution = 0.99) {
  const Scene scene = parse_scene(text(area_fraction, restitution), "test").scene;
  const double area = scene.length() / bins, count = 180.0 / bins;
  const Gas gas = jenkins_richman_gas(area_fraction, temperature, scene.diameter());
  const double kinetic = gas.number_density() * temperature, p = pressure * jenkins_richman_pressure(gas);
  return made_record(text(area_fraction, restitution), [&](const SetTally& set) {
    for (int b = 0; b < bins; ++b) {
      const double y = (b + 0.5) / bins, rate = 4 * top_speed * (1 - 2 * y);
      set(Tally::count, b, count);
      set(Tally::freedom, b, count);
      set(Tally::cx, b, count * 4 * top_speed * y * (1 - y));
      set(Tally::ux2, b, count * temperature);
      set(Tally::cy2, b, count * temperature);
      set(Tally::stress_xx, b, (1.1 * p - kinetic) * area);  // p is the mean of both
      set(Tally::stress_yy, b, (0.9 * p - kinetic) * area);
      const double factor = b == 5 || b == 6 ? viscosity * centre : viscosity;
      set(Tally::stress_xy, b, factor * jenkins_richman_shear_stress(gas, rate) * area);
    }
  });
}

Claim theory_claim() { return made_claim(0.05, {{"shear_margin", 0.05}, {"viscosity_margin", 0.05}}); }

BOOST_AUTO_TEST_CASE(shear_rate_of_a_parabola_is_exact) {
  const std::vector<Record> records{flow(0.3), flow(0.3)};
  const SceneValues scene("s", records);
  for (int bin = 2; bin < 6; ++bin)
    BOOST_TEST(shear_rate(scene, bin)[1] == 4 * top_speed * (1 - 2 * scene.centre(bin)),
               boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_THROW((void)shear_rate(scene, 1), InputError);
  BOOST_CHECK_THROW((void)shear_rate(scene, 6), InputError);
}

BOOST_AUTO_TEST_CASE(stresses_and_viscosity_are_in_the_units_of_the_thesis) {
  const std::vector<Record> records{flow(0.3)};
  const SceneValues scene("s", records);
  const Rheology found = rheology(scene, 3);
  const auto close = boost::test_tools::tolerance(1e-12);
  // rho_p g W = 4/(pi d^2) with m = g = W = 1, d = 1/12: p = nu T (1 + 2 nu g).
  const double g = henderson_contact_value(0.3);
  BOOST_TEST(found.pressure[0] == 0.3 * temperature * (1 + 0.6 * g), close);
  BOOST_TEST(found.theory_pressure[0] == found.pressure[0], close);
  BOOST_TEST(found.shear_stress[0] > 0);
  BOOST_TEST(found.viscosity[0] == found.theory_viscosity[0], close);
  BOOST_TEST(found.shear_stress[0] == found.theory_shear_stress[0], close);
}

BOOST_AUTO_TEST_CASE(a_flow_that_obeys_the_theory_deviates_by_round_off) {
  SceneRecords records;
  records["a"] = {flow(0.3), flow(0.3)};
  records["b"] = {flow(0.5), flow(0.5)};
  const Evidence evidence = estimate_stress_theory(theory_claim(), Tier::standard, records);
  BOOST_TEST(evidence.checks.size() == 2u * (4 + 4 + 3));
  for (const Check& check : evidence.checks)
    for (const double value : check.values) BOOST_TEST(std::abs(value) < 1e-12, check.label << ": " << value);
}

BOOST_AUTO_TEST_CASE(each_wrong_quantity_is_seen) {
  SceneRecords pressure, viscosity;
  pressure["a"] = {flow(0.5, 0.9)};
  viscosity["a"] = {flow(0.5, 1, 1.2)};
  for (const std::string& label : outside(estimate_stress_theory(theory_claim(), Tier::standard, pressure)))
    BOOST_TEST(label.find("p over") != std::string::npos);
  const Evidence evidence = estimate_stress_theory(theory_claim(), Tier::standard, viscosity);
  BOOST_TEST(check_with(evidence, "bins 3 and 10: viscosity").values[0] == 0.2, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(check_with(evidence, "bins 3 and 10: -P_xy").values[0] == 0.2, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(outside(evidence).size() == 3u + 3);  // bin 6 carries a seventh of bin 3's shear stress
}

BOOST_AUTO_TEST_CASE(bins_within_a_free_path_of_the_wall_are_not_judged) {
  // Free path .2777 d/(nu g) = .46 W at nu .05: no bin but the centre pair lies beyond it and half a diameter.
  const std::vector<Record> records{flow(0.05)};
  BOOST_TEST(bulk_bins(SceneValues("s", records)).first == 6);
  const std::vector<Record> denser{flow(0.1)};  // .2777/(12 x .1 x 1.18) + .042 = .238: bin 4 has its centre at .29
  BOOST_TEST(bulk_bins(SceneValues("s", denser)).first == 3);
}

BOOST_AUTO_TEST_CASE(restitution_lowers_the_pressure_that_enskog_expects) {
  const Gas gas = jenkins_richman_gas(0.5, temperature, 1.0 / 12);
  SceneRecords elastic, inelastic;
  elastic["a"] = {flow(0.5, 1, 1, 1, 0.7)};
  inelastic["a"] = {flow(0.5, garzo_dufty_pressure(gas, 0.7) / jenkins_richman_pressure(gas),
                         garzo_dufty_viscosity(gas, 0.7) / shear_viscosity(gas), 1, 0.7)};
  const Claim claim = made_claim(0.02, {{"viscosity_margin", 1e-9}});
  BOOST_TEST(all_inside(estimate_stress_enskog(claim, Tier::standard, inelastic)));
  BOOST_TEST(outside(estimate_stress_enskog(claim, Tier::standard, elastic)).size() == 4u + 3);
}

Claim misfit_claim() { return made_claim(0, {{"dense", 0.3}, {"quasi_elastic", 0.95}}); }

BOOST_AUTO_TEST_CASE(misfits_grow_with_density_and_dissipation) {
  SceneRecords records;
  records["a"] = {flow(0.15, 1.01, 1.01)};
  records["b"] = {flow(0.5, 1.01, 1.01)};
  records["c"] = {flow(0.15, 1.02, 1.2, 1, 0.9)};
  records["d"] = {flow(0.5, 1.1, 1.2, 1, 0.9)};
  const Evidence evidence = estimate_stress_misfit(misfit_claim(), Tier::standard, records);
  BOOST_TEST(evidence.checks.size() == 4u);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(check_with(evidence, "misfit of p less that at e_n 0.99").values[0] == 0.09,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(check_with(evidence, "misfit of p at nu 0.5 less").values[0] == 0.08, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_misfit_at_low_density_is_seen) {
  SceneRecords records;
  records["c"] = {flow(0.15, 1.2, 1.2, 1, 0.9)};
  records["d"] = {flow(0.5, 1.1, 1.2, 1, 0.9)};
  const std::vector<std::string> labels = outside(estimate_stress_misfit(misfit_claim(), Tier::standard, records));
  BOOST_TEST_REQUIRE(labels.size() == 1u);
  BOOST_TEST(labels[0].find("misfit of p at") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(more_disks_in_a_longer_channel_change_nothing) {
  const auto with_disks = [](const char* disks, double pressure) {
    std::string longer = text(0.3);
    longer.replace(longer.find("180"), 3, disks);
    Record record = flow(0.3, pressure);
    record.scene = parse_scene(longer, "test").scene;
    const double times = record.scene.particles / 180.0;
    const TallyLayout layout(bins);
    for (std::size_t k = layout.at(Tally::count); k < layout.size(); ++k) record.sums[k] *= times;
    return record;
  };
  const Claim claim = made_claim(0.03, {{"viscosity_margin", 0.05}, {"normal_stress_margin", 0.02}});
  SceneRecords same, other;
  same["a"] = other["a"] = {with_disks("180", 1)};
  same["b"] = {with_disks("720", 1)};
  other["b"] = {with_disks("720", 1.05)};
  const Evidence evidence = estimate_stress_size(claim, Tier::standard, same);
  BOOST_TEST(evidence.checks.size() == 4u * 3 + 3);
  for (const Check& check : evidence.checks) BOOST_TEST(std::abs(check.values[0]) < 1e-12, check.label);
  const Evidence changed = estimate_stress_size(claim, Tier::standard, other);
  BOOST_TEST(check_with(changed, "bins 3 and 10: p").values[0] == 0.05, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(outside(changed).size() == 4u);
}

BOOST_AUTO_TEST_CASE(a_plug_that_hardly_shears_has_a_large_viscosity) {
  const Claim claim = made_claim(0, {{"first_bin", 5}});
  SceneRecords plug, fluid;
  plug["a"] = {flow(0.5, 1, 1, 50)};
  fluid["a"] = {flow(0.5, 1, 1, 0.98)};
  BOOST_TEST(estimate_stress_divergence(claim, Tier::standard, plug).checks.size() == 2u);
  BOOST_TEST(all_inside(estimate_stress_divergence(claim, Tier::standard, plug)));
  BOOST_TEST(outside(estimate_stress_divergence(claim, Tier::standard, fluid)).size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
