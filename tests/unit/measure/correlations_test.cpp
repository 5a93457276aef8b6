// Correlations of arrangements that are known, and that a stopped measurement goes on with the same sums.
#include "gpf/measure/correlations.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "gpf/base/random.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/scene/start.hpp"
#include "support/scenes.hpp"

using namespace gpf;
namespace tt = boost::test_tools;

namespace {

const std::vector<double>& of(const NamedArrays& arrays, std::string_view name) {
  return array_named(arrays, name).values;
}

/// A triangular lattice of spacing `spacing` diameters, rows along x, in a channel of one bin.
State triangular(const Scene& scene, double spacing, int columns, int rows) {
  State state;
  const double a = spacing * scene.diameter();
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      state.position.push_back({a * (column + 0.5 * (row % 2)), 0.2 + a * row * std::sqrt(0.75)});
  state.velocity.assign(state.position.size(), {0, 0});
  return state;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(correlations)

BOOST_AUTO_TEST_CASE(a_triangular_lattice_is_seen_as_one) {
  Scene scene = test::channel(200, 0.3, 40);
  scene.length_over_width = 20 * 1.12 / 40;  // the lattice closes
  const State state = triangular(scene, 1.12, 20, 10);
  Correlations c(scene, 1);
  c.begin(state);
  c.sample(state, std::vector<double>(200, 0.0));
  const auto& arrays = c.arrays();
  // The ten disks of the first and last row miss two of six neighbours each.
  BOOST_TEST(of(arrays, "order/neighbours")[0] == 200 * 6 - 2 * 20 * 2);
  BOOST_TEST(of(arrays, "order/psi6")[0] == 200, tt::tolerance(1e-12));
  BOOST_TEST(of(arrays, "pair/total")[0] == 200 * 199 / 2);
  const auto& pairs = of(arrays, "pair/count");
  BOOST_TEST(pairs[22] == (200 * 6 - 2 * 20 * 2) / 2);  // at 1.12 d
  BOOST_TEST(std::accumulate(pairs.begin(), pairs.begin() + 22, 0.0) == 0);
  BOOST_TEST(std::accumulate(pairs.begin() + 23, pairs.begin() + 38, 0.0) == 0);
  BOOST_TEST(pairs[38] > 0);  // at sqrt(3) 1.12 d
}

BOOST_AUTO_TEST_CASE(velocities_of_pairs_are_multiplied_at_their_distance) {
  Scene scene = test::channel(40, 0.3, 10);
  const double d = scene.diameter();
  const State state{{{0, 0.5}, {3.02 * d, 0.5}, {0, 0.1}}, {{2, 3}, {5, -1}, {7, 7}}};
  Correlations c(scene, 2);  // the third disk lies in the other bin
  c.begin(state);            // mean of the upper bin: 3.5
  c.sample(state, std::vector<double>{-1.5, 1.5, 0});
  const auto at = [&](const char* name) { return array_named(c.arrays(), name).at(1, 60); };
  BOOST_TEST(at("pair/count") == 1);
  BOOST_TEST(at("pair/ux") == -2.25);
  BOOST_TEST(at("pair/uy") == -3);
  BOOST_TEST(at("pair/uxy") == 0.5 * (-1.5 * -1 + 1.5 * 3));
  BOOST_TEST(at("pair/cx") == -2.25);
  BOOST_TEST(at("pair/cx_sum") == 0);
}

BOOST_AUTO_TEST_CASE(velocities_of_one_disk_are_multiplied_at_their_lag) {
  const Scene scene = test::channel(1, 0.01, 10);
  Correlations c(scene, 1);
  const auto state = [](double vy) { return State{{{0, 0.5}}, {{0, vy}}}; };
  c.begin(state(1));
  for (int k = 0; k < 40; ++k) c.sample(state(k + 1), std::vector<double>{1.0 * (k + 1)});
  const auto& sums = of(c.arrays(), "time/ux");
  const auto& count = of(c.arrays(), "time/count");
  BOOST_TEST(sums[0] == 1 + 33 * 33);  // origins: the first and the thirty-third sample
  BOOST_TEST(sums[3] == 1 * 4 + 33 * 36);
  BOOST_TEST(sums[32] == 33);
  BOOST_TEST(count[3] == 2);
  BOOST_TEST(count[32] == 1);
}

BOOST_AUTO_TEST_CASE(a_measurement_that_is_stopped_goes_on_to_the_same_arrays) {
  const Scene scene = test::channel(60, 0.4, 10);
  const auto measure = [&](bool stopped) {
    Engine<> engine(scene, start_state(scene));
    Measurement first(scene, 5, Detail::correlations), second = first;
    Measurement* m = &first;
    m->begin(0, engine.state());
    for (int k = 1; k <= 80; ++k) {
      engine.advance(k / 32.0, *m);
      m->sample(k / 32.0, engine.state());
      if (stopped && k == 37) second.restore(first.memory()), m = &second;
    }
    return m->arrays();
  };
  const NamedArrays whole = measure(false), resumed = measure(true);
  BOOST_REQUIRE(whole.size() == 26u);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    BOOST_TEST(whole[k].name == resumed[k].name);
    BOOST_TEST((whole[k].values == resumed[k].values));
  }
}

BOOST_AUTO_TEST_SUITE_END()
