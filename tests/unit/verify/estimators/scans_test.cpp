#include "verify/estimators/scans.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

#include "gpf/measure/distributions.hpp"
#include "unit/verify/estimators/wall_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(scans)

const auto close = boost::test_tools::tolerance(1e-6);

BOOST_AUTO_TEST_CASE(scenes_are_grouped_and_ordered) {
  SceneRecords records;
  add(records, {.area_fraction = 0.3, .restitution = 0.9});
  add(records, {.area_fraction = 0.1, .restitution = 0.9, .knudsen = 0.4});
  add(records, {.area_fraction = 0.2, .restitution = 0.8});
  add(records, {.area_fraction = 0.2, .wall = 0.9});
  const Scans scans = scans_by(normal_restitution, area_fraction, records, rough_walls);
  BOOST_TEST_REQUIRE(scans.size() == 2u);
  const std::vector<SceneValues>& scan = scans.rbegin()->second;
  BOOST_TEST(numbers_of(scan, area_fraction) == std::vector({0.1, 0.3}), close << boost::test_tools::per_element());
  BOOST_TEST(mean_knudsen(*find_scene(scan, area_fraction, 0.1)) == 0.4, close);
  BOOST_TEST(find_scene(scan, area_fraction, 0.2) == nullptr);
  BOOST_TEST(between_knudsen(scan, 0.2, 1).size() == 1u);
}

BOOST_AUTO_TEST_CASE(an_extremum_needs_both_sides) {
  const auto judged = [](std::vector<std::vector<double>> values, Extremum kind) {
    Evidence evidence;
    add_extremum(evidence, "y at", {1, 2, 3, 4}, values, kind);
    return outside(evidence).size();
  };
  BOOST_TEST(judged({{1, 1.1}, {2, 2}, {3, 3}, {1, 1}}, Extremum::maximum) == 0u);
  BOOST_TEST(judged({{1, 1}, {2, 2}, {3, 3}, {4, 4}}, Extremum::maximum) == 1u);
  BOOST_TEST(judged({{3, 3}, {1, 1}, {2, 2}, {4, 4}}, Extremum::minimum) == 0u);
  BOOST_TEST(judged({{3, 3}, {2, 2}, {1, 1}, {0, 0}}, Extremum::minimum) == 1u);
}

/// The walls change slip and gradient by the factor 4, e_n by `factor`.
BOOST_AUTO_TEST_CASE(an_effect_of_restitution_is_measured_in_effects_of_the_walls) {
  const auto evidence_for = [](double factor) {
    SceneRecords records;
    add(records, {.velocity = {0.1, 0.2, 1}});
    add(records, {.restitution = 0.8, .velocity = {0.1 * factor, 0.2 * factor, 1}});
    add(records, {.wall = 0.9, .velocity = {0.4, 0.8, 1}});
    return estimate_slip_restitution(made_claim(0, {{"small_part", 0.25}}), Tier::quick, records);
  };
  const Evidence slip = evidence_for(std::pow(4, -0.2));
  BOOST_TEST(check_with(slip, "effect on slip").values[0] == -0.2, close);
  BOOST_TEST(check_with(slip, "effect on (dU/dy)/U_0").values[0] == -0.2, close);
  BOOST_TEST(all_inside(slip));
  BOOST_TEST(outside(evidence_for(std::pow(4, -0.3))).size() == 2u);
}

BOOST_AUTO_TEST_CASE(kn_and_restitution_on_the_axis_of_the_most_that_walls_do) {
  SceneRecords records;
  add(records, {.area_fraction = 0.02, .knudsen = 0.5});
  add(records, {.area_fraction = 0.02, .restitution = 0.8, .knudsen = 0.54});
  add(records, {.area_fraction = 0.02, .wall = 0.9, .knudsen = 1.5});
  add(records, {.area_fraction = 0.4, .knudsen = 0.03});
  add(records, {.area_fraction = 0.4, .restitution = 0.8, .knudsen = 0.06});
  add(records, {.area_fraction = 0.4, .restitution = 0.7, .knudsen = 0.12});
  add(records, {.area_fraction = 0.4, .wall = 0.9, .knudsen = 0.2});
  const Evidence evidence = estimate_kn_restitution(made_claim(0, {{"negligible", 0.05}}), Tier::quick, records);
  BOOST_TEST(check_with(evidence, "nu 0.02, e_n 0.8").values[0] == 0.04, close);
  BOOST_TEST(check_with(evidence, "nu 0.4, e_n 0.8").values[0] == 0.03, close);
  BOOST_TEST(outside(evidence).size() == 1u);  // nu .4, e_n .7: .09
}

BOOST_AUTO_TEST_CASE(dissipation_matters_more_to_dense_walls) {
  const auto failures = [](double dilute, double dense) {
    SceneRecords records;
    for (const double nu : {0.1, 0.4}) {
      add(records, {.area_fraction = nu, .temperature = {1, 2, 2}});
      const double change = nu < 0.2 ? dilute : dense;
      add(records, {.area_fraction = nu, .restitution = 0.8, .temperature = {1 + change, 2 + 3 * change, 2}});
    }
    return outside(estimate_temp_restitution(made_claim(0, {{"dilute_to", 0.1}, {"dense_from", 0.4}}), Tier::quick,
                                             records))
        .size();
  };
  BOOST_TEST(failures(-0.1, 0.3) == 0u);
  BOOST_TEST(failures(-0.3, 0.1) == 2u);  // T_w and its gradient
}

BOOST_AUTO_TEST_CASE(walls_change_kn_in_dilute_flow_only) {
  const auto failures = [](double dense_change) {
    SceneRecords records;
    for (const double wall : {0.1, 0.9}) {
      add(records, {.area_fraction = 0.02, .wall = wall, .knudsen = wall < 0.5 ? 1.0 : 3.0});
      add(records, {.area_fraction = 0.4, .wall = wall, .knudsen = wall < 0.5 ? 0.1 : 0.1 + dense_change});
    }
    return outside(estimate_kn_wall(made_claim(0, {{"dense_from", 0.3}, {"negligible", 0.05}}), Tier::quick, records));
  };
  BOOST_TEST(failures(0.08).empty());
  BOOST_TEST(failures(0.12).size() == 1u);  // no longer negligible
  BOOST_TEST(failures(3).size() == 2u);     // nor smaller
}

/// At nu .1 walls -.5, 0, .1, .9 with Kn .2; the curves of .1 and .9 reach over Kn .1 ... .4.
SceneRecords wall_scan(double slip_at_zero, double gradient_at_zero) {
  SceneRecords records;
  const auto run = [&](double nu, double wall, double kn, double slip, double gradient) {
    add(records, {.area_fraction = nu, .wall = wall, .knudsen = kn, .velocity = {slip, slip + gradient / 6, 1}});
  };
  run(0.1, -0.5, 0.2, 0.1, 1);
  run(0.1, 0, 0.22, slip_at_zero, gradient_at_zero);
  run(0.1, 0.1, 0.25, 0.3, 1.1);
  run(0.1, 0.9, 0.4, 0.8, 0.5);
  run(0.2, 0.1, 0.125, 0.15, 1);
  run(0.2, 0.9, 0.1, 0.2, 1);
  return records;
}

BOOST_AUTO_TEST_CASE(slip_grows_over_the_walls_and_at_equal_kn) {
  const Evidence evidence =
      estimate_slip_wall(made_claim(0, {{"gradient_from", 0.1}}), Tier::quick, wall_scan(0.2, 1.2));
  BOOST_TEST(all_inside(evidence));
  // ln slip at Kn .2 on the line through (.125, .15) and (.25, .3): slip .24; and through (.1, .2) and (.4, .8): .4.
  BOOST_TEST(check_with(evidence, "Kn 0.2: ln slip at beta_w 0.1").values[0] == std::log(0.24 / 0.1), close);
  BOOST_TEST(check_with(evidence, "Kn 0.2: ln slip at beta_w 0.9").values[0] == std::log(0.4 / 0.24), close);
  BOOST_TEST(
      outside(estimate_slip_wall(made_claim(0, {{"gradient_from", 0.1}}), Tier::quick, wall_scan(0.05, 1.2))).size() ==
      1u);
}

BOOST_AUTO_TEST_CASE(walls_are_coldest_at_the_vertex) {
  const auto evidence_for = [](double vertex) {
    SceneRecords records;
    for (const double wall : {-0.5, 0.0, 0.1, 0.3, 0.9}) {
      const double t = 1 + (wall - vertex) * (wall - vertex);
      add(records, {.wall = wall, .temperature = {t, t + 2 - wall * wall, 3}});
    }
    return estimate_temp_wall(made_claim(0.1), Tier::quick, records);
  };
  const Evidence evidence = evidence_for(0.05);
  BOOST_TEST(check_with(evidence, "beta_w of the smallest T_w").values[0] == 0.05, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(evidence_for(0.15)).size() == 1u);
  BOOST_TEST(outside(evidence_for(1)).size() == 2u);  // no minimum inside, and the vertex
}

BOOST_AUTO_TEST_CASE(kn_of_order_one_falls) {
  SceneRecords records;
  add(records, {.area_fraction = 0.02, .wall = 0.9, .knudsen = 2});
  add(records, {.area_fraction = 0.3, .wall = 0.9, .knudsen = 0.1});
  BOOST_TEST(all_inside(estimate_kn_dilute(made_claim(0), Tier::quick, records)));
  add(records, {.area_fraction = 0.01, .wall = 0.9, .knudsen = 4});
  BOOST_TEST(outside(estimate_kn_dilute(made_claim(0), Tier::quick, records)).size() == 2u);  // both definitions
}

BOOST_AUTO_TEST_CASE(flow_is_flat_below_the_edge_and_falls_above) {
  const auto evidence_for = [](double densest) {
    SceneRecords records;
    const auto run = [&](double nu, double kn, double flow) {
      add(records, {.area_fraction = nu, .knudsen = kn, .velocity = {0.1, 0.2, flow}});
    };
    run(0.5, 0.01, densest), run(0.4, 0.03, 4), run(0.2, 0.06, 3.9), run(0.1, 0.2, 2), run(0.05, 0.4, 1);
    return estimate_flow_knudsen(made_claim(0, {{"edge", 0.05}}), Tier::quick, records);
  };
  const auto failures = [&](double densest) { return outside(evidence_for(densest)).size(); };
  // U_0 at Kn .05 on the line in log-log through (.03, 4) and (.06, 3.9), at .25 through (.2, 2) and (.4, 1).
  const double at_edge = 4 * std::pow(3.9 / 4, std::log2(0.05 / 0.03)), far = 2 * 0.2 / 0.25;
  BOOST_TEST(check_with(evidence_for(3.5), "U_0: change").values[0] == std::log(4 / 3.5) / std::log(at_edge / far),
             close);
  // Q is the mean over the bins, not over the disks: (.1 + .2 + U_0)/3.
  BOOST_TEST(check_with(evidence_for(3.5), "Q: at nu 0.05").values[0] == (1.0 - 2.0) / 3, close);
  BOOST_TEST(failures(3.5) == 0u);
  BOOST_TEST(failures(1.9) == 2u);  // Q and U_0

  // A scan that does not reach as far above .05 as below has no values there, rather than those of a shorter range.
  SceneRecords short_scan;
  add(short_scan, {.area_fraction = 0.5, .knudsen = 0.01, .velocity = {0.1, 0.2, 4}});
  add(short_scan, {.area_fraction = 0.1, .knudsen = 0.2, .velocity = {0.1, 0.2, 2}});
  const Evidence too_short = estimate_flow_knudsen(made_claim(0, {{"edge", 0.05}}), Tier::quick, short_scan);
  BOOST_TEST(std::isnan(check_with(too_short, "U_0: change").values.at(0)));
}

/// Paths whose share of longer ones falls as survival(s), s in Enskog mean free paths.
template <class F>
SceneRecords path_records(F&& survival) {
  SceneRecords records;
  add(records, {.area_fraction = 0.15});
  constexpr std::size_t cells = Distributions::path_cells;
  const double octaves = std::log2(Distributions::path_most / Distributions::path_least);
  const auto longer = [&](double k) {
    return survival(Distributions::path_least * std::exp2(octaves * k / static_cast<double>(cells)));
  };
  for (Record& record : records.begin()->second)
    for (const char* name : {"free_path/lab", "free_path/peculiar"}) {
      NamedArray paths(name, {cells});
      for (std::size_t k = 0; k < cells; ++k)
        paths.values[k] = 1e6 * (longer(static_cast<double>(k)) - longer(static_cast<double>(k) + 1));
      record.arrays.push_back(std::move(paths));
    }
  return records;
}

BOOST_AUTO_TEST_CASE(exponential_paths_are_told_from_power_laws_and_gaussians) {
  const auto evidence_for = [](auto survival) {
    return estimate_kn_paths(made_claim(0, {{"judged_at", 0.15}}), Tier::standard, path_records(survival));
  };
  const Evidence exponential = evidence_for([](double s) { return std::exp(-s / 0.7); }),
                 gaussian = evidence_for([](double s) { return std::exp(-s * s / 3); }),
                 power_law = evidence_for([](double s) { return std::min(1.0, std::pow(s, -4.0)); });
  BOOST_TEST_REQUIRE(exponential.checks.size() == 1u);
  BOOST_TEST(std::abs(exponential.checks[0].values[0]) < 1e-6);
  BOOST_TEST(all_inside(exponential));
  BOOST_TEST(gaussian.checks[0].values[0] == std::log(9.0 / 4), boost::test_tools::tolerance(0.05));  // nearest edges
  BOOST_TEST(power_law.checks[0].values[0] == std::log(std::log(2.0) / 3 / (std::log(3.0) / 2)),
             boost::test_tools::tolerance(0.05));
  BOOST_TEST(outside(gaussian).size() == 1u);
  BOOST_TEST(outside(power_law).size() == 1u);
  BOOST_TEST(all_inside(evidence_for([](double s) { return std::exp(-std::pow(s, 0.6)); })));
  BOOST_TEST(outside(evidence_for([](double s) { return std::exp(-std::pow(s, 0.4)); })).size() == 1u);
  BOOST_TEST(outside(evidence_for([](double s) { return std::exp(-std::pow(s, 1.7)); })).size() == 1u);
}

BOOST_AUTO_TEST_CASE(temperature_falls_between_smooth_walls_and_peaks_between_rough_ones) {
  const auto failures = [](double dense_smooth, double dense_rough) {
    SceneRecords records;
    for (const double wall : {0.1, 0.9})
      for (const double nu : {0.1, 0.2, 0.4}) {
        const double t = wall > 0.5 ? (nu < 0.3 ? 3 - nu : dense_smooth) : nu < 0.15 ? 1 : nu < 0.3 ? 2 : dense_rough;
        add(records, {.area_fraction = nu, .wall = wall, .temperature = {t, 3 * t, t}});
      }
    return outside(estimate_temp_density(made_claim(0, {{"profiles_from", 0.95}}), Tier::quick, records)).size();
  };
  BOOST_TEST(failures(1, 1.5) == 0u);
  BOOST_TEST(failures(2.9, 1.5) == 3u);  // three bins
  BOOST_TEST(failures(1, 2.5) == 3u);    // T_w, its gradient, T at the centre
}

BOOST_AUTO_TEST_CASE(wall_temperature_is_linear_and_its_gradient_constant_at_high_kn) {
  const auto failures = [](double middle, double last_gradient) {
    SceneRecords records;
    const auto run = [&](double nu, double kn, double t, double gradient) {
      add(records, {.area_fraction = nu, .knudsen = kn, .temperature = {t, t + gradient / 6, t}});
    };
    run(0.01, 3, 2, last_gradient), run(0.02, 2, middle, -0.5), run(0.05, 1, 1, -0.3), run(0.2, 0.1, 1, 2);
    run(0.3, 0.05, 1, 4), run(0.5, 0.01, 1, 1);
    return outside(
               estimate_temp_knudsen(
                   made_claim(
                       0, {{"high_from", 0.6}, {"departure", 0.05}, {"constant_from", 1.1}, {"constant_part", 0.1}}),
                   Tier::quick, records))
        .size();
  };
  BOOST_TEST(failures(1.5, -0.6) == 0u);
  BOOST_TEST(failures(1.7, -0.6) == 1u);
  BOOST_TEST(failures(1.5, -1.5) == 1u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
