// The first normal stress difference, its parts, and where they change sign, on made channels.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/normal_stress_crossing.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(normal_stress)

/// What N_1 is made of, with p = 1: its kinetic and collisional part in bins 2 to 5, and in the wall's bins their sum.
struct Parts {
  double kinetic = 0, collisional = 0, wall = 0;
};

std::string text(double area_fraction, double restitution, double beta) {
  return "[scene]\ngeometry = \"channel\"\nparticles = 180\nwidth_over_diameter = 12\narea_fraction = " +
         std::to_string(area_fraction) + "\nnormal_restitution = " + std::to_string(restitution) +
         "\nwall_tangential_restitution = " + std::to_string(beta) + "\n[run]\nstart_up = 2\nduration = 8\nbins = 6\n";
}

/// The centre bins hold one and a half times the mean number of disks. `drift`: the mean velocity of a bin changes with
/// time by so much, which adds drift^2 to the variance about the long-time mean.
Record flow(double area_fraction, Parts parts, double restitution = 0.8, double beta = 0.9, double drift = 0) {
  const std::string scene_text = text(area_fraction, restitution, beta);
  const Record empty = made_record(scene_text, [](const SetTally&) {});
  const double area = empty.scene.length() / 6;
  return made_record(scene_text, [&](const SetTally& set) {
    for (int b = 0; b < 6; ++b) {
      const bool wall = b == 0 || b == 5, centre = b == 2 || b == 3;
      const double count = centre ? 45 : 22.5, kinetic = 0.5, n = count / area;
      const double k = wall ? 0 : parts.kinetic, c = wall ? parts.wall : parts.collisional;
      set(Tally::count, b, count);
      set(Tally::freedom, b, count - 1);
      const double xx = (kinetic + k / 2) / n, yy = (kinetic - k / 2) / n;
      set(Tally::ux2, b, (count - 1) * xx);
      set(Tally::cy2, b, count * yy);
      set(Tally::cx2, b, count * (xx + drift * drift));
      set(Tally::stress_xx, b, (0.5 + c / 2) * area);
      set(Tally::stress_yy, b, (0.5 - c / 2) * area);
    }
  });
}

BOOST_AUTO_TEST_CASE(parts_add_up_and_are_positive_where_p_xx_is_larger) {
  const std::vector<Record> records{flow(0.2, {0.3, -0.1})};
  const SceneValues scene("s", records);
  const auto close = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(first_normal_stress_difference(scene, 1, StressPart::kinetic)[0] == 0.3, close);
  BOOST_TEST(first_normal_stress_difference(scene, 1, StressPart::collisional)[0] == -0.1, close);
  BOOST_TEST(first_normal_stress_difference(scene, 1, StressPart::both)[0] == 0.2, close);
}

BOOST_AUTO_TEST_CASE(a_drifting_bin_counts_about_the_long_time_mean_only) {
  const double drift = 0.01;
  const std::vector<Record> records{flow(0.2, {0.3, -0.1}, 0.8, 0.9, drift)};
  const SceneValues scene("s", records);
  const double added = 45 / (scene.scene().length() / 6) * drift * drift;  // to P_xx, whence half of it to p
  BOOST_TEST(centre_value(scene, StressPart::both)[0] == 0.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(centre_value(scene, StressPart::both, MeanFlow::long_time)[0] == (0.2 + added) / (1 + added / 2),
             boost::test_tools::tolerance(1e-9));
}

SceneRecords row(double restitution, std::initializer_list<std::pair<double, Parts>> scenes, double beta = 0.9) {
  SceneRecords records;
  for (const auto& [nu, parts] : scenes)
    records[text(nu, restitution, beta)] = {flow(nu, parts, restitution, beta), flow(nu, parts, restitution, beta)};
  return records;
}
SceneRecords both(SceneRecords a, const SceneRecords& b) {
  a.insert(b.begin(), b.end());
  return a;
}

BOOST_AUTO_TEST_CASE(the_density_of_a_change_of_sign) {
  SceneRecords records = row(0.8, {{0.1, {0.4, 0.1}}, {0.2, {0.2, -0.1}}, {0.4, {-0.1, -0.2}}});
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const SceneRow found = rows_of(scenes).front();
  const auto close = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(sign_change(found, StressPart::both, Density::mean).densities[1] == 0.2 + 0.2 * 0.1 / 0.4, close);
  BOOST_TEST(sign_change(found, StressPart::both, Density::local).densities[1] == 1.5 * 0.25, close);
  BOOST_TEST(sign_change(found, StressPart::collisional, Density::mean).densities[0] == 0.15, close);
  SceneRecords negative = row(0.8, {{0.1, {-0.4, 0.1}}, {0.2, {-0.2, 0.1}}});
  const std::vector<SceneValues> none = by_area_fraction(negative);
  BOOST_TEST(!sign_change(rows_of(none).front(), StressPart::both, Density::mean).found());
}

/// N_1 of mean `value` that scatters by +-.01 between four replicas.
std::vector<Record> scattered(double nu, double value) {
  std::vector<Record> records;
  for (const double sign : {-1.0, 1.0, -1.0, 1.0}) records.push_back(flow(nu, {value + 0.01 * sign, 0}));
  return records;
}

BOOST_AUTO_TEST_CASE(fieller_comes_from_the_scatter_of_the_replicas) {
  SceneRecords records;
  records["a"] = scattered(0.2, 0.2);
  records["b"] = scattered(0.4, -0.2);
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const SignChange change = sign_change(rows_of(scenes).front(), StressPart::both, Density::mean);
  BOOST_TEST(change.crossing.at == 0.3, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(change.crossing.bounded());
  // Error e at either end, t_{.99, 6} = q, slope -2 with error s: half width q (e/sqrt 2)/2 over sqrt(1 - (q s/2)^2).
  const double q = 3.142668, e = 0.01 / std::sqrt(3.0), s = e * std::sqrt(2.0) / 0.2;
  const double half = q * e / std::sqrt(2.0) / 2 / std::sqrt(1 - std::pow(q * s / 2, 2));
  BOOST_TEST(std::abs(change.crossing.interval.width() - 2 * half) < 1e-5);
}

BOOST_AUTO_TEST_CASE(only_a_certain_sign_is_a_side_of_the_change) {
  SceneRecords records;
  records["a"] = scattered(0.1, 0.2);
  records["b"] = scattered(0.2, 0.01);  // t_{.99, 3} = 4.5 errors of .0058 are more
  records["c"] = scattered(0.3, -0.2);
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const SignChange change = sign_change(rows_of(scenes).front(), StressPart::both, Density::mean);
  BOOST_TEST_REQUIRE(change.found());
  BOOST_TEST(change.below->scene().area_fraction() == 0.1, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(change.above->scene().area_fraction() == 0.3, boost::test_tools::tolerance(1e-9));
  // The line through (.1, .2), (.2, .01), (.3, -.2): slope -2, and .01/3 at .2; in a replica .01 higher or lower.
  BOOST_TEST(change.densities.at(0) == 0.2 + (0.01 / 3 - 0.01) / 2, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(change.crossing.at == 0.2 + 0.01 / 6, boost::test_tools::tolerance(1e-9));
  records["c"] = scattered(0.3, -0.5);  // no line goes through these
  const std::vector<SceneValues> bent = by_area_fraction(records);
  BOOST_TEST(sign_change(rows_of(bent).front(), StressPart::both, Density::mean).found());
  BOOST_TEST(sign_change(rows_of(bent).front(), StressPart::both, Density::mean).densities.empty());
  records["c"] = scattered(0.3, -0.02);
  const std::vector<SceneValues> uncertain = by_area_fraction(records);
  BOOST_TEST(!sign_change(rows_of(uncertain).front(), StressPart::both, Density::mean).found());
}

BOOST_AUTO_TEST_CASE(reversal) {
  const Claim claim = made_claim(0, {{"positive_to", 0.15}, {"negative_from", 0.4}});
  const SceneRecords reverses = row(0.8, {{0.1, {0.4, 0.1}}, {0.3, {0.2, -0.1}}, {0.5, {0, -0.2}}});
  const SceneRecords stays = row(0.8, {{0.1, {0.4, 0.1}}, {0.3, {0.2, -0.1}}, {0.5, {0.3, -0.2}}});
  BOOST_TEST(estimate_n1_reversal(claim, Tier::standard, reverses).checks.size() == 2u);
  BOOST_TEST(all_inside(estimate_n1_reversal(claim, Tier::standard, reverses)));
  BOOST_TEST(outside(estimate_n1_reversal(claim, Tier::standard, stays)).size() == 1u);
}

BOOST_AUTO_TEST_CASE(critical_density_rises_with_dissipation) {
  const Claim claim = made_claim(0);
  const SceneRecords early = row(0.9, {{0.1, {0.1, 0}}, {0.2, {-0.1, 0}}, {0.3, {-0.3, 0}}}),
                     late = row(0.8, {{0.1, {0.5, 0}}, {0.2, {0.3, 0}}, {0.3, {-0.1, 0}}}),
                     earlier = row(0.8, {{0.05, {0.1, 0}}, {0.09, {-0.3, 0}}, {0.3, {-0.3, 0}}}),
                     alike = row(0.8, {{0.1, {0.05, 0}}, {0.2, {-0.3, 0}}, {0.3, {-0.3, 0}}}),
                     never = row(0.8, {{0.1, {0.05, 0}}, {0.3, {0.3, 0}}});
  const Evidence evidence = estimate_n1_critical(claim, Tier::standard, both(early, late));
  BOOST_TEST(evidence.checks.size() == 2u);
  BOOST_TEST(check_with(evidence, ": nu where").values[0] == 0.2 - 0.2);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(estimate_n1_critical(claim, Tier::standard, both(early, earlier))).size() == 2u);
  for (const SceneRecords& undecided : {alike, never})
    for (const Check& check : estimate_n1_critical(claim, Tier::standard, both(early, undecided)).checks)
      BOOST_TEST(check.values.empty());  // which the judge calls inconclusive
}

BOOST_AUTO_TEST_CASE(kinetic_part_vanishes) {
  const Claim claim = made_claim(0.02, {{"dense", 0.5}, {"moderate", 0.15}});
  const SceneRecords vanishes = row(0.8, {{0.1, {0.4, 0}}, {0.3, {-0.1, 0}}, {0.5, {0.01, 0.3}}}),
                     remains = row(0.8, {{0.1, {0.4, 0}}, {0.5, {0.1, 0.3}}});
  BOOST_TEST(all_inside(estimate_n1_kinetic(claim, Tier::standard, vanishes)));
  BOOST_TEST(outside(estimate_n1_kinetic(claim, Tier::standard, remains)).size() == 1u);
}

BOOST_AUTO_TEST_CASE(collisional_part) {
  const Claim claim = made_claim(0, {{"inelastic", 0.85},
                                     {"positive_to", 0.15},
                                     {"negative_from", 0.3},
                                     {"dense", 0.5},
                                     {"weak_from", 0.3},
                                     {"weak_to", 0.5},
                                     {"weak_size", 0.05}});
  const SceneRecords strong = row(0.8, {{0.1, {0.4, 0.1}}, {0.3, {0.2, -0.1}}, {0.5, {0.05, -0.2}}}),
                     weak = row(0.9, {{0.3, {0, -0.02}}, {0.5, {0, -0.03}}, {0.6, {0, -0.2}}}),
                     kinetic = row(0.8, {{0.1, {0.4, 0.1}}, {0.3, {0.2, -0.1}}, {0.5, {0.3, -0.2}}}),
                     too_weak = row(0.9, {{0.3, {0, -0.02}}, {0.5, {0, -0.03}}, {0.6, {0, -0.025}}});
  const Evidence evidence = estimate_n1_collisional(claim, Tier::standard, both(strong, weak));
  BOOST_TEST(evidence.checks.size() == 3u + 1 + 4);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(estimate_n1_collisional(claim, Tier::standard, kinetic)).size() == 1u);
  BOOST_TEST(outside(estimate_n1_collisional(claim, Tier::standard, too_weak)).size() == 1u);
}

BOOST_AUTO_TEST_CASE(zero_lines) {
  const Claim claim = made_claim(0, {{"elastic", 0.85}, {"coincidence", 0.05}});
  // N_1^c is zero at nu .15, N_1 at .25.
  const SceneRecords apart = row(0.9, {{0.1, {0.2, 0.1}}, {0.2, {0.2, -0.1}}, {0.3, {0, -0.1}}}),
                     swapped = row(0.9, {{0.1, {0, 0.1}}, {0.2, {-0.2, 0.1}}, {0.3, {0, -0.1}}});
  const Evidence evidence = estimate_n1_phase(claim, Tier::standard, apart);
  BOOST_TEST(check_with(evidence, ": nu of").values[0] == 0.1, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(check_with(evidence, ": nu_bin of").values[0] == 0.15, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(estimate_n1_phase(claim, Tier::standard, swapped)).size() == 2u);
}

BOOST_AUTO_TEST_CASE(zero_lines_coincide_only_where_the_scenes_resolve_it) {
  const Claim claim = made_claim(0, {{"elastic", 0.85}, {"coincidence", 0.05}});
  const SceneRecords coarse = row(0.8, {{0.1, {0.1, 0.1}}, {0.3, {-0.1, -0.1}}}),
                     fine = row(0.8, {{0.1, {0.1, 0.1}}, {0.13, {-0.1, -0.1}}}),
                     apart = row(0.8, {{0.1, {0.2, 0.1}}, {0.2, {0.2, -0.1}}, {0.3, {0, -0.1}}});
  for (const Check& check : estimate_n1_phase(claim, Tier::standard, coarse).checks)
    BOOST_TEST(check.values.empty());  // which the judge calls inconclusive
  const Evidence resolved = estimate_n1_phase(claim, Tier::standard, fine);
  BOOST_TEST(check_with(resolved, ": nu of").values.size() == 2u);
  BOOST_TEST(all_inside(resolved));
  BOOST_TEST(outside(estimate_n1_phase(claim, Tier::standard, apart)).size() == 2u);
}

Claim elastic_claim() { return made_claim(0.1, {{"dilute", 0.05}, {"dense", 0.5}, {"centre_margin", 0.01}}); }

SceneRecords walls(Parts dilute_smooth, Parts dilute_rough, Parts dense_smooth, Parts dense_rough) {
  return both(row(0.99, {{0.05, dilute_smooth}, {0.5, dense_smooth}}, 0.9),
              row(0.99, {{0.05, dilute_rough}, {0.5, dense_rough}}, 0.1));
}

BOOST_AUTO_TEST_CASE(nearly_elastic_disks) {
  const SceneRecords as_claimed = walls({0.03, 0, -0.3}, {0, 0, -0.5}, {0, 0.001, -0.2}, {0, 0.002, -0.4}),
                     large = walls({0.03, 0.2, -0.3}, {0, 0.2, -0.5}, {0, 0.001, -0.2}, {0, 0.002, -0.4}),
                     felt = walls({0.03, 0, -0.3}, {0, 0, -0.5}, {0, 0.01, -0.2}, {0, 0.06, -0.4});
  const Evidence evidence = estimate_n1_elastic(elastic_claim(), Tier::standard, as_claimed);
  BOOST_TEST(evidence.checks.size() == 4u * 2 + 3);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(estimate_n1_elastic(elastic_claim(), Tier::standard, large)).size() == 4u);
  BOOST_TEST(outside(estimate_n1_elastic(elastic_claim(), Tier::standard, felt)).size() == 2u);
}

BOOST_AUTO_TEST_CASE(dissipation) {
  const Claim claim = made_claim(0, {{"bin", 2}, {"low", 0.05}, {"middle", 0.15}, {"high", 0.5}});
  const SceneRecords elastic = row(0.99, {{0.05, {0.01, 0}}, {0.15, {0.02, 0}}, {0.5, {0.01, 0}}}),
                     peaked = row(0.8, {{0.05, {0.2, 0}}, {0.15, {0.6, 0}}, {0.5, {0.1, 0}}}),
                     falling = row(0.8, {{0.05, {0.7, 0}}, {0.15, {0.6, 0}}, {0.5, {0, 0}}});
  const Evidence evidence = estimate_n1_dissipation(claim, Tier::standard, both(elastic, peaked));
  BOOST_TEST(evidence.checks.size() == 5u);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(estimate_n1_dissipation(claim, Tier::standard, both(elastic, falling))).size() == 2u);
}

BOOST_AUTO_TEST_CASE(rise_from_the_dilute_limit) {
  const Claim claim = made_claim(0, {{"maximum", 0.15}});
  const SceneRecords rises = row(0.8, {{0.01, {0.05, 0}}, {0.05, {0.2, 0}}, {0.15, {0.6, 0}}, {0.5, {0.1, 0}}}),
                     dips = row(0.8, {{0.01, {0.5, 0}}, {0.05, {0.2, 0}}, {0.15, {0.6, 0}}, {0.5, {0.1, 0}}});
  const Evidence evidence = estimate_n1_dilute(claim, Tier::standard, rises);
  BOOST_TEST(evidence.checks.size() == 3u);  // two rises and the beginning; the fall beyond is not of this claim
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(estimate_n1_dilute(claim, Tier::standard, dips)).size() == 2u);  // a fall, and not from zero
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
