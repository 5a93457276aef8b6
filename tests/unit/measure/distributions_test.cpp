// Histograms of states and contacts that are known.
#include "gpf/measure/distributions.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gpf/base/random.hpp"
#include "gpf/measure/measurement.hpp"
#include "support/scenes.hpp"

using namespace gpf;
namespace tt = boost::test_tools;

namespace {

const NamedArray& of(const Distributions& d, std::string_view name) { return array_named(d.arrays(), name); }

/// Moment of a row of a histogram over [-range, range].
double moment(const NamedArray& histogram, std::size_t row, int power, double range) {
  const std::size_t cells = histogram.shape.back();
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < cells; ++k) {
    const double x = -range + (static_cast<double>(k) + 0.5) * 2 * range / static_cast<double>(cells);
    sum += histogram.at(row, k) * std::pow(x, power);
    count += histogram.at(row, k);
  }
  return sum / count;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(distributions)

BOOST_AUTO_TEST_CASE(gaussian_velocities_give_gaussian_histograms_in_units_of_the_first_state) {
  const std::int32_t disks = 20000;
  const Scene scene = test::channel(disks, 0.3, 80);
  State state;
  std::vector<double> ux;
  for (std::int32_t i = 0; i < disks; ++i) {
    const Vec2 v = gaussian_pair(5, static_cast<std::uint64_t>(i));
    state.position.push_back({0, (i + 0.5) / disks});
    state.velocity.push_back({7 + 3 * v.x, 0.5 * v.y});
    ux.push_back(3 * v.x);
  }
  Distributions d(scene, 2);
  d.begin(state);
  d.sample(state, ux);
  for (const std::size_t bin : {0u, 1u}) {
    BOOST_TEST(of(d, "velocity/frame").at(bin, 0) == 7, tt::tolerance(0.02));
    BOOST_TEST(of(d, "velocity/frame").at(bin, 1) == 3, tt::tolerance(0.03));
    BOOST_TEST(of(d, "velocity/frame").at(bin, 2) == 0.5, tt::tolerance(0.03));
    for (const char* name : {"velocity/ux", "velocity/uy"}) {
      BOOST_TEST(moment(of(d, name), bin, 2, Distributions::velocity_range) == 1, tt::tolerance(0.03));
      BOOST_TEST(moment(of(d, name), bin, 4, Distributions::velocity_range) == 3, tt::tolerance(0.1));
    }
    BOOST_TEST(moment(of(d, "velocity/cx"), bin, 2, Distributions::flow_range) == 1, tt::tolerance(0.03));
  }
}

BOOST_AUTO_TEST_CASE(a_bin_that_is_almost_empty_takes_the_units_of_the_whole_flow) {
  const Scene scene = test::channel(20, 0.1, 10);
  State state;
  for (int i = 0; i < 20; ++i) {
    state.position.push_back({0, i == 0 ? 0.9 : 0.2});
    state.velocity.push_back({i % 2 == 0 ? 1.0 : -1.0, 2.0});
  }
  Distributions d(scene, 2);
  d.begin(state);
  BOOST_TEST(of(d, "velocity/frame").at(1, 1) == 1);
  BOOST_TEST(of(d, "velocity/frame").at(1, 2) == 2);
}

BOOST_AUTO_TEST_CASE(contacts_are_counted_by_angle_in_the_bin_of_their_middle) {
  const Scene scene = test::channel(40, 0.3, 10);
  Distributions d(scene, 4);
  const double r = scene.diameter();
  const auto touch = [&](double degrees, double y) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec2 r_12{r * std::cos(angle), r * std::sin(angle)};
    d.on_pair({1, 0, 1, {0, y - 0.5 * r_12.y}, r_12, {}, {}, {}, 0});
  };
  touch(47, 0.3);
  touch(227, 0.3);  // the same line
  touch(132, 0.9);
  BOOST_TEST(of(d, "contact/angle").at(1, 9) == 2);
  BOOST_TEST(of(d, "contact/angle").at(3, 26) == 1);
}

BOOST_AUTO_TEST_CASE(free_paths_of_a_run_have_the_mean_that_the_tallies_have) {
  const Scene scene = test::channel(200, 0.2, 15);
  Measurement m(scene, 3, Detail::distributions);
  const State state{std::vector<Vec2>(200, Vec2{0, 0.5}), std::vector<Vec2>(200, Vec2{1, 0})};
  m.begin(0, state);
  // Disks 0 and 1 touch at times 1, 2 and 4: two paths each.
  for (const double time : {1.0, 2.0, 4.0}) {
    m.sample(time, state);
    m.on_pair({time, 0, 1, {0, 0.5}, {scene.diameter(), 0}, {1, 0}, {1, 0}, {0, 0}, 0});
  }
  const NamedArrays arrays = m.arrays();
  const auto& lab = array_named(arrays, "free_path/lab").values;
  const double unit = array_named(arrays, "free_path/unit").values[0];
  const auto cell = [unit](double path) { return static_cast<std::size_t>(16 * (std::log2(path / unit) + 13)); };
  // Gravity, 1.7, adds g t^2/2 to a path of duration t.
  BOOST_TEST(lab[cell(1 + 0.85)] == 2);
  BOOST_TEST(lab[cell(2 + 3.4)] == 2);
  BOOST_TEST(std::accumulate(lab.begin(), lab.end(), 0.0) == 4);
}

BOOST_AUTO_TEST_SUITE_END()
