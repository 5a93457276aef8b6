#include "gpf/measure/quantities.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "gpf/base/random.hpp"
#include "gpf/measure/measurement.hpp"

using namespace gpf;
namespace tt = boost::test_tools;

namespace {

std::map<std::string, std::vector<double>> by_name(const Scene& scene, const Measurement& m) {
  std::vector<double> totals(m.layout().size(), 0);
  for (std::size_t b = 0; b < m.series().blocks(); ++b)
    for (std::size_t k = 0; k < totals.size(); ++k) totals[k] += m.series().sums()[b * totals.size() + k];
  std::map<std::string, std::vector<double>> values;
  for (const Quantity& q : derive_quantities(scene, m.layout(), totals)) values[q.name] = q.values;
  return values;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(quantities)

/// A Gaussian gas with a prescribed shear: every profile is known. 200 samples of 2000 disks, 4 bins: 10^5 velocities
/// per bin, so kurtosis has sigma sqrt(24/10^5) = .0155, variance sqrt(2/10^5) = .0045 relative; bounds at 4.5 sigma
/// (false alarm 7e-6 each).
BOOST_AUTO_TEST_CASE(a_known_gas_gives_its_parameters_back) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = 2000;
  scene.width_over_diameter = 50;
  scene.length_over_width = 3;
  scene.gravity = 1;
  Measurement m(scene, 4);
  const double sigma_x = 1.3, sigma_y = 0.8, correlation = 0.25, shear = 2;
  std::uint64_t index = 0;
  for (int sample = 0; sample <= 200; ++sample) {
    State state;
    for (std::int32_t i = 0; i < scene.particles; ++i) {
      const double y = (i + 0.5) / scene.particles;
      const Vec2 g = gaussian_pair(7, index++);
      const double mean = 5 + shear * std::floor(4 * y);  // constant within a bin
      state.position.push_back({0, y});
      state.velocity.push_back(
          {mean + sigma_x * g.x, sigma_y * (correlation * g.x + std::sqrt(1 - correlation * correlation) * g.y)});
    }
    if (sample == 0)
      m.begin(0, state);
    else
      m.sample(0.5 * sample, state);
  }
  const auto q = by_name(scene, m);
  const double density = scene.particles / scene.length();
  for (std::size_t b = 0; b < 4; ++b) {
    BOOST_TEST(q.at("area_fraction")[b] == scene.area_fraction(), tt::tolerance(1e-12));
    BOOST_TEST(q.at("mean_velocity")[b] == 5 + shear * static_cast<double>(b), tt::tolerance(0.004));
    BOOST_TEST(q.at("velocity_variance_x")[b] == sigma_x * sigma_x, tt::tolerance(0.0203));
    BOOST_TEST(q.at("velocity_variance_y")[b] == sigma_y * sigma_y, tt::tolerance(0.0203));
    BOOST_TEST(q.at("granular_temperature_long_time")[b] == q.at("granular_temperature")[b], tt::tolerance(0.01));
    BOOST_TEST(q.at("kinetic_stress_xy")[b] == density * correlation * sigma_x * sigma_y, tt::tolerance(0.06));
    BOOST_TEST(q.at("kurtosis_x")[b] == 3, tt::tolerance(0.07 / 3));
    BOOST_TEST(q.at("kurtosis_y")[b] == 3, tt::tolerance(0.07 / 3));
    BOOST_TEST(std::abs(q.at("skewness_x")[b]) < 4.5 * std::sqrt(6e-5));
    BOOST_TEST(q.at("pressure_yy")[b] == q.at("kinetic_stress_yy")[b]);
  }
  BOOST_TEST(q.at("mean_flow")[0] == 8, tt::tolerance(0.002));
  BOOST_TEST(q.at("slip_velocity_lower")[0] == 5 / 8.0, tt::tolerance(0.006));
}

/// n - 1 in the variance: with two disks per bin the naive one would be low by half.
BOOST_AUTO_TEST_CASE(the_variance_has_no_bias_of_few_disks) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = 2;
  scene.width_over_diameter = 20;
  scene.length_over_width = 1;
  scene.gravity = 1;
  Measurement m(scene, 1);
  for (std::uint64_t k = 0; k <= 40000; ++k) {
    const Vec2 a = gaussian_pair(3, 2 * k), b = gaussian_pair(3, 2 * k + 1);
    const State state{{{0, 0.4}, {0.5, 0.6}}, {{9 + a.x, a.y}, {9 + b.x, b.y}}};
    if (k == 0)
      m.begin(0, state);
    else
      m.sample(static_cast<double>(k), state);
  }
  // sigma of the variance: sqrt(2/40000) = .0071; 4.5 sigma.
  BOOST_TEST(by_name(scene, m).at("velocity_variance_x")[0] == 1, tt::tolerance(0.032));
}

BOOST_AUTO_TEST_CASE(compressibility_of_a_gas_without_contacts_is_that_of_an_ideal_gas) {
  Scene scene;
  scene.geometry = Geometry::periodic;
  scene.particles = 10;
  scene.width_over_diameter = 100;
  scene.length_over_width = 1;
  Measurement m(scene, 3);
  State state;
  for (int i = 0; i < 10; ++i) {
    state.position.push_back({0.1 * i, 0.1 * i});
    state.velocity.push_back({i % 2 == 0 ? 1.0 : -1.0, 0.5});
  }
  m.begin(0, state);
  m.sample(1, state);
  const auto q = by_name(scene, m);
  BOOST_TEST(q.at("compressibility_finite")[0] == 0.9, tt::tolerance(1e-14));  // (N - 1)/N
  BOOST_TEST(q.at("temperature")[0] == 10 * 0.625 / 9, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_bin_without_disks_is_not_measured) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = 1;
  scene.width_over_diameter = 10;
  scene.length_over_width = 1;
  scene.gravity = 1;
  Measurement m(scene, 2);
  const State state{{{0, 0.2}}, {{1, 0}}};
  m.begin(0, state);
  m.sample(1, state);
  const auto q = by_name(scene, m);
  BOOST_TEST(std::isnan(q.at("mean_velocity")[1]));
  BOOST_TEST(q.at("area_fraction")[1] == 0);
  BOOST_TEST(std::isnan(q.at("velocity_variance_x")[0]));  // one disk has no variance
}

/// U = 2 + 7 y - 3 y^2 and T = 1 + 4 y - 5 y^2 from each wall: what stands at the walls follows by hand.
BOOST_AUTO_TEST_CASE(gradients_at_the_walls) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = 100;
  scene.width_over_diameter = 20;
  scene.length_over_width = 1;
  scene.gravity = 1;
  const auto derived = [&](int bins) {
    const TallyLayout layout(bins);
    std::vector<double> totals(layout.size(), 0);
    const auto set = [&](Tally t, int k, double value) { totals[layout.at(t, k)] = value; };
    set(Tally::measured_time, 0, 2);
    set(Tally::samples, 0, 4);
    set(Tally::speed, 0, 4 * 100 * 3.0);
    set(Tally::pair_contacts, 0, 500);
    set(Tally::wall_contacts, lower, 150);
    set(Tally::wall_contacts, upper, 50);
    for (int b = 0; b < bins; ++b) {
      const int from_wall = std::min(b, bins - 1 - b);
      const double y = (from_wall + 0.5) / bins, temperature = 1 + 4 * y - 5 * y * y;
      set(Tally::count, b, 10);
      set(Tally::freedom, b, 8);
      set(Tally::cx, b, 10 * (2 + 7 * y - 3 * y * y));
      set(Tally::ux2, b, 8 * temperature);
      set(Tally::cy2, b, 10 * temperature);
    }
    std::map<std::string, double> values;
    for (const Quantity& q : derive_quantities(scene, layout, totals)) values[q.name] = q.values[0];
    return values;
  };
  const auto close = tt::tolerance(1e-12);
  const auto q = derived(10);
  const double centre = 2 + 7 * 0.45 - 3 * 0.45 * 0.45;
  BOOST_TEST(q.at("wall_gradient") == 7 - 3 * 0.2, close);       // between y = .05 and .15
  BOOST_TEST(q.at("wall_gradient_extrapolated") == 7.0, close);  // exact for a parabola
  BOOST_TEST(q.at("wall_gradient_relative") == (7 - 3 * 0.2) / centre, close);
  BOOST_TEST(q.at("wall_gradient_relative_extrapolated") == 7 / centre, close);
  BOOST_TEST(q.at("wall_temperature") == 1 + 4 * 0.05 - 5 * 0.0025, close);
  BOOST_TEST(q.at("wall_temperature_gradient") == 4 - 5 * 0.2, close);
  BOOST_TEST(q.at("wall_temperature_gradient_extrapolated") == 4.0, close);
  BOOST_TEST(q.at("knudsen_number_any_contact") == 100 * 3.0 * 2 / 1200, close);  // 1200 flights of 100 disks
  BOOST_TEST(std::isnan(derived(2).at("wall_gradient_extrapolated")));
  BOOST_TEST(std::isnan(derived(1).at("wall_gradient")));
}

BOOST_AUTO_TEST_SUITE_END()
