// Claims about velocity correlations, on velocities that are functions of place.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/sampled_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {
namespace {

using Velocity = std::function<Vec2(Vec2 place, std::size_t disk)>;

std::vector<Record> replicas_of(const std::string& text, const std::function<Velocity(std::uint64_t seed)>& velocity) {
  const Scene scene = made_record(text, [](const SetTally&) {}).scene;
  std::vector<Record> records;
  for (std::uint64_t r = 0; r < 2; ++r) {
    std::vector<State> states;
    for (std::uint64_t s = 1; s <= 12; ++s) states.push_back(random_state(scene, 100 * r + s, velocity(100 * r + s)));
    records.push_back(sampled_record(text, states));
  }
  return records;
}

Velocity independent(std::uint64_t seed) {
  return [seed](Vec2, std::size_t disk) { return gaussian_pair(seed, disk); };
}

/// One wave along the channel in u_x and u_y where `inside(y)`, independent velocities elsewhere.
std::function<Velocity(std::uint64_t)> wave(const std::function<bool(double y)>& inside) {
  return [inside](std::uint64_t seed) -> Velocity {
    return [seed, inside](Vec2 place, std::size_t disk) {
      const double phase = 2 * std::numbers::pi * place.x;
      return inside(place.y) ? Vec2{std::cos(phase), std::sin(phase)} : gaussian_pair(seed, disk);
    };
  };
}

bool in_plug(double y) { return std::abs(y - 0.5) < 0.2; }
bool everywhere(double) { return true; }

}  // namespace

BOOST_AUTO_TEST_SUITE(velocity_correlations)

BOOST_AUTO_TEST_CASE(independent_velocities_are_seen_as_such_and_a_wave_is_not) {
  SceneRecords calm, wavy;
  calm["a"] = replicas_of(long_channel(900, 41), independent);
  wavy["a"] = replicas_of(long_channel(900, 41), wave(everywhere));
  // 9 bins, 3 functions, 4 windows. The fewest pairs are those nearer than 1.5 d: about 600 in a bin, error .04.
  const Evidence evidence = estimate_elastic_correlations(made_claim(0.18), Tier::quick, calm);
  BOOST_TEST(evidence.checks.size() == 108u);
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(outside(estimate_elastic_correlations(made_claim(0.18), Tier::quick, wavy)).size() > 50u);
}

BOOST_AUTO_TEST_CASE(a_wave_in_the_plug_alone_is_what_the_claim_states) {
  SceneRecords plug, all;
  plug["a"] = replicas_of(long_channel(900, 41), wave(in_plug));
  all["a"] = replicas_of(long_channel(900, 41), wave(everywhere));
  const Claim claim = made_claim(0);
  BOOST_TEST(all_inside(estimate_plug_correlations(claim, Tier::quick, plug)));
  BOOST_TEST(!all_inside(estimate_plug_correlations(claim, Tier::quick, all)));
}

/// cos(2 pi r/L) is negative at 11 d for L = 41 d and positive for L = 164 d.
BOOST_AUTO_TEST_CASE(a_reversal_that_moves_out_with_the_box_is_noticed) {
  SceneRecords both, one;
  both["short"] = one["short"] = replicas_of(long_channel(900, 41), wave(everywhere));
  both["very-long"] = replicas_of(long_channel(3600, 164), wave(everywhere));
  BOOST_TEST(all_inside(estimate_vortex(made_claim(0), Tier::quick, one)));
  const std::vector<std::string> wrong = outside(estimate_vortex(made_claim(0), Tier::quick, both));
  BOOST_REQUIRE(wrong.size() == 1u);
  BOOST_TEST(wrong[0].find("N 3600, L/d 164") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(dissipation_has_to_make_the_correlations) {
  SceneRecords as_stated, the_other_way;
  as_stated["a"] = replicas_of(long_channel(900, 41, 0.99), independent);
  as_stated["b"] = replicas_of(long_channel(900, 41, 0.8), wave(everywhere));
  the_other_way["a"] = replicas_of(long_channel(900, 41, 0.8), independent);
  the_other_way["b"] = replicas_of(long_channel(900, 41, 0.99), wave(everywhere));
  BOOST_TEST(all_inside(estimate_dense_correlations(made_claim(0.1), Tier::quick, as_stated)));
  BOOST_TEST(outside(estimate_dense_correlations(made_claim(0.1), Tier::quick, the_other_way)).size() == 8u);
}

/// u_x = c_y is a cross correlation.
BOOST_AUTO_TEST_CASE(the_cross_correlation_is_compared_between_bins_and_flows) {
  const auto aligned = [](const std::function<bool(double)>& inside) {
    return [inside](std::uint64_t seed) -> Velocity {
      return [seed, inside](Vec2 place, std::size_t disk) {
        const double u = std::cos(2 * std::numbers::pi * place.x);
        return inside(place.y) ? Vec2{u, place.y < 0.5 ? u : -u} : gaussian_pair(seed, disk);
      };
    };
  };
  SceneRecords plug, layers;
  plug["a"] = replicas_of(long_channel(900, 41, 0.8), aligned(in_plug));
  layers["a"] = replicas_of(long_channel(900, 41, 0.8), aligned([](double y) { return !in_plug(y); }));
  plug["b"] = layers["b"] = replicas_of(long_channel(900, 41, 0.99), independent);
  BOOST_TEST(all_inside(estimate_cross_correlations(made_claim(0), Tier::quick, plug)));
  BOOST_TEST(outside(estimate_cross_correlations(made_claim(0), Tier::quick, layers)).size() >= 2u);
}

BOOST_AUTO_TEST_CASE(an_autocorrelation_that_lasts_is_noticed) {
  const auto record = [](double centre) {
    Record r = sampled_record(
        long_channel(900, 41),
        {random_state(made_record(long_channel(900, 41), [](const SetTally&) {}).scene, 1, independent(1))});
    for (NamedArray& a : r.arrays)
      if (a.name.starts_with("time/") && a.name != "time/origin")
        for (std::size_t b = 0; b < 18; ++b)
          for (std::size_t lag = 0; lag < Correlations::lags; ++lag)
            a.at(b, lag) = a.name == "time/count" ? 50 : lag == 0 ? 100 : b == 8 || b == 9 ? 100 * centre : 4;
    return r;
  };
  const Claim claim = made_claim(0.1, {{"decayed_after", 0.125}, {"very_dense", 0.7}});
  SceneRecords short_memory, long_memory;
  short_memory["a"] = {record(0.05), record(-0.05)};
  long_memory["a"] = {record(0.3), record(0.3)};
  const Evidence evidence = estimate_autocorrelation(claim, Tier::quick, short_memory);
  BOOST_TEST(evidence.checks.size() == 6u);  // two bins, three windows
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(check_with(evidence, "bin 9: C_x from t 0.25 to 0.5").values[1] == -0.05,
             boost::test_tools::tolerance(1e-12));
  for (const std::string& label : outside(estimate_autocorrelation(claim, Tier::quick, long_memory)))
    BOOST_TEST(label.find("bin 9") != std::string::npos);
  BOOST_TEST(outside(estimate_autocorrelation(claim, Tier::quick, long_memory)).size() == 3u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
