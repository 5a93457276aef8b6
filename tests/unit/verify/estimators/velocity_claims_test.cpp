#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "unit/verify/estimators/made_velocities.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(velocity_claims)

Vec2 both_gaussian(Generator& g, int) { return {gaussian(g), gaussian(g)}; }

bool contains(const std::vector<std::string>& labels, std::string_view part) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](const std::string& label) { return label.find(part) != std::string::npos; });
}

BOOST_AUTO_TEST_CASE(one_peak_below_zero_passes_and_other_shapes_do_not) {
  const auto evidence_of = [](double (*ux)(Generator&)) {
    SceneRecords records;
    records["a"] = sampled_records(3, channel_scene(0.2, 0.99, 0.1), 400, [ux](Generator& g, int) {
      return Vec2{ux(g), gaussian(g)};
    });
    return estimate_rough_wall_peak(made_claim(0), Tier::standard, records);
  };
  BOOST_TEST(all_inside(evidence_of(skewed)));
  BOOST_TEST(contains(outside(evidence_of(two_humps)), "number of peaks"));
  const std::vector<std::string> turned = outside(evidence_of([](Generator& g) { return -skewed(g); }));
  BOOST_TEST(contains(turned, "position"));
  BOOST_TEST(contains(turned, "skewness"));
}

BOOST_AUTO_TEST_CASE(humps_are_wanted_with_wide_bins_only) {
  const auto evidence_of = [](bool wide, bool narrow) {
    SceneRecords records;
    const auto made = [](bool humps, int bins) {
      return sampled_records(3, channel_scene(0.2, 0.99, 0.1, bins), 600, [humps](Generator& g, int) {
        return Vec2{gaussian(g), humps ? two_humps(g) : gaussian(g)};
      });
    };
    records["wide"] = made(wide, 6), records["narrow"] = made(narrow, 10);
    return estimate_hump(made_claim(0, {{"double_humped_bins", 6}}), Tier::standard, records);
  };
  BOOST_TEST(all_inside(evidence_of(true, false)));
  BOOST_TEST(outside(evidence_of(true, true)).size() == 1u);
  BOOST_TEST(contains(outside(evidence_of(true, true)), "10 bins"));
  BOOST_TEST(contains(outside(evidence_of(false, false)), "6 bins"));
}

BOOST_AUTO_TEST_CASE(c_x_next_to_walls) {
  const auto evidence_of = [](double (*rough)(Generator&), double (*smooth)(Generator&)) {
    SceneRecords records;
    const auto made = [](double wall, double (*ux)(Generator&)) {
      return sampled_records(3, channel_scene(0.2, 0.99, wall), 1500, [ux](Generator& g, int) {
        return Vec2{ux(g), gaussian(g)};
      });
    };
    records["rough"] = made(0.1, rough), records["smooth"] = made(0.9, smooth);
    return estimate_cx_wall(made_claim(0.2, {{"low_velocity", 0.8}, {"part_of_distance", 0.25}}), Tier::standard,
                            records);
  };
  const auto normal = [](Generator& g) { return gaussian(g); };
  const Evidence evidence = evidence_of(skewed, normal);  // mode 2 and mean 3 of the gamma distribution, flow 3: 2/3
  BOOST_TEST(all_inside(evidence));
  for (const double mode : check_with(evidence, "most probable").values)
    BOOST_TEST(mode == 2.0 / 3, boost::test_tools::tolerance(0.1));
  BOOST_TEST(contains(outside(evidence_of(normal, normal)), "most probable"));
  BOOST_TEST(contains(outside(evidence_of(skewed, skewed)), "kurtosis"));
  BOOST_TEST(contains(outside(evidence_of(skewed, skewed)), "distance"));
}

BOOST_AUTO_TEST_CASE(equal_distributions_of_unequal_width_are_the_same_and_others_not) {
  const std::map<std::string, double, std::less<>> parameters{
      {"log_ratio", 0.3}, {"first_bin", 3}, {"second_bin", 1}, {"exponent", 1.5}};
  SceneRecords records;
  records["a"] = sampled_records(2, channel_scene(0.3, 0.9, 0.1), 1500, both_gaussian);
  records["b"] = sampled_records(2, channel_scene(0.3, 0.9, 0.9), 1500, [](Generator& g, int) {
    return Vec2{gaussian(g, 2), gaussian(g, 0.3)};
  });
  const Evidence same = estimate_same_distributions(made_claim(0, parameters), Tier::standard, records);
  BOOST_TEST(same.checks.size() == 2u * (2 * 12 + 3));
  for (const Check& check : same.checks)
    if (check.label.find("ln of the ratio") != std::string::npos)
      for (const double value : check.values) BOOST_TEST(check.band.contains(value), check.label);

  records["b"] = sampled_records(2, channel_scene(0.3, 0.9, 0.9), 1500, [](Generator& g, int bin) {
    return Vec2{gaussian(g), bin == 0 || bin == 5 ? two_humps(g) : gaussian(g)};
  });
  const Evidence other = estimate_same_distributions(made_claim(0, parameters), Tier::standard, records);
  for (const std::string& label : outside(other))
    if (label.find("ln of the ratio") != std::string::npos) BOOST_TEST(label.find("bin 1, u_y") != std::string::npos);
  BOOST_TEST(contains(outside(other), "bin 1, u_y, -0.5 to 0 sigma"));

  records["c"] = records["a"];
  BOOST_CHECK_THROW(estimate_same_distributions(made_claim(0, parameters), Tier::standard, records), InputError);
}

const std::map<std::string, double, std::less<>> tail_parameters{
    {"alpha_x", 7}, {"alpha_y", 5.5}, {"over_population", 1.5}, {"constant_from_restitution", 0.85}};

std::vector<Record> with_tails(double nu, double restitution, double wall, double alpha_x, double alpha_y) {
  return sampled_records(2, channel_scene(nu, restitution, wall), 3000, [=](Generator& g, int) {
    return Vec2{power_tail(g, alpha_x), power_tail(g, alpha_y)};
  });
}

BOOST_AUTO_TEST_CASE(tails_in_the_plug) {
  SceneRecords records;
  records["a"] = sampled_records(2, channel_scene(0.56, 0.99, 0.9), 3000, both_gaussian);
  records["b"] = with_tails(0.56, 0.85, 0.9, 7, 5.5);
  records["c"] = with_tails(0.56, 0.80, 0.9, 7, 5.5);
  const Claim claim = made_claim(2.5, tail_parameters);
  const Evidence evidence = estimate_plug_tails(claim, Tier::standard, records);
  BOOST_TEST(evidence.checks.size() == 2u * (1 + 2 * (1 + 9) + 3));
  BOOST_TEST(all_inside(evidence));
  for (const HealthCheck& health : evidence.health) BOOST_TEST(health.passed, health.detail);

  records["a"] = with_tails(0.56, 0.99, 0.9, 5.5, 5.5);
  records["b"] = sampled_records(2, channel_scene(0.56, 0.85, 0.9), 3000, both_gaussian);
  const std::vector<std::string> wrong = outside(estimate_plug_tails(claim, Tier::standard, records));
  BOOST_TEST(contains(wrong, "u_x, nu 0.56, e_n 0.99, beta_w 0.9: counts beyond 3 sigma"));
  BOOST_TEST(contains(wrong, "u_x, nu 0.56, e_n 0.85, beta_w 0.9: over-populated"));
  BOOST_TEST(contains(wrong, "exponent of both tails, 3-6 sigma"));
}

BOOST_AUTO_TEST_CASE(order_of_the_tails_of_dense_flows) {
  SceneRecords records;
  const auto add = [&](double nu, double wall, double at_99, double at_90, double at_80) {
    const std::string name = std::to_string(nu) + std::to_string(wall);
    records[name + "99"] = with_tails(nu, 0.99, wall, at_99, at_99);
    records[name + "90"] = with_tails(nu, 0.90, wall, at_90, at_90);
    records[name + "80"] = with_tails(nu, 0.80, wall, at_80, at_80);
  };
  add(0.56, 0.9, 13, 6, 4.2);
  add(0.85, 0.9, 11, 7.5, 5);
  add(0.85, 0.1, 11, 7.5, 5);
  const Claim claim = made_claim(4);
  const Evidence evidence = estimate_dense_tails(claim, Tier::standard, records);
  BOOST_TEST(evidence.checks.size() == 2u * 3 * 7);
  const auto mean_inside = [](const Check& check) { return check.band.contains(over_replicas(check.values).mean); };
  BOOST_TEST(std::all_of(evidence.checks.begin(), evidence.checks.begin() + 7, mean_inside));  // u_x, 2-4 sigma

  add(0.85, 0.9, 5, 7.5, 11);
  BOOST_TEST(contains(outside(estimate_dense_tails(claim, Tier::standard, records)),
                      "u_x, 2-4 sigma: fall of the exponent from e_n 0.99 to 0.90"));
  // Where a flow begins so quietly that its histograms end within the windows, what they show is not judged.
  int calls = 0;
  const double quiet = 0.1;
  for (auto& [name, replicas] : records)
    if (name == std::to_string(0.85) + std::to_string(0.1) + "80")
      replicas = sampled_records(2, channel_scene(0.85, 0.80, 0.1), 3000, [&](Generator& g, int) {
        const double scale = calls++ < 1000 ? quiet : 1;
        return scale * Vec2{power_tail(g, 5), power_tail(g, 5)};
      });
  const Evidence partial = estimate_dense_tails(claim, Tier::standard, records);
  BOOST_TEST(partial.checks.size() == 2u * 3 * 6);
  BOOST_TEST(!std::any_of(partial.checks.begin(), partial.checks.end(), [](const Check& check) {
    return check.label.find("e_n 0.80, rough less smooth") != std::string::npos;
  }));
  BOOST_TEST(partial.health.back().passed);

  records.erase(records.begin());
  BOOST_CHECK_THROW(estimate_dense_tails(claim, Tier::standard, records), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
