// Density modes of configurations whose modes are known: a uniform gas, a slug, a winding band, a swelling one, a plug.
#include "gpf/measure/density_modes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "gpf/measure/measurement.hpp"

using namespace gpf;
namespace tt = boost::test_tools;

namespace {

constexpr double pi = std::numbers::pi, length = 3;
constexpr std::size_t even = 0, odd = 1, varicose = 2;

/// Disks on a grid that fills a band of half width `half` about the height `centre`, both functions of x; `columns` at
/// equal distances along the channel.
State band(const std::function<double(double)>& centre, const std::function<double(double)>& half, int columns = 240,
           int rows = 40) {
  State state;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const double x = (i + 0.5) / columns * length, t = 2 * (j + 0.5) / rows - 1;
      state.position.push_back({x, 0.5 + centre(x) + t * half(x)});
    }
  state.velocity.assign(state.position.size(), {});
  return state;
}

double wave(double x) { return std::cos(2 * pi * x / length); }
const auto none = [](double) { return 0.0; };

State shifted(State state, double by) {
  for (Vec2& r : state.position) r.x = std::fmod(r.x + by, length);
  return state;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(density_modes_test)

BOOST_AUTO_TEST_CASE(one_disk_is_the_middle_of_its_band) {
  const State state{{{0.7, 0.8}}, {{0, 0}}};
  const DensityModes modes = density_modes(state, length, 5);
  for (std::size_t k = 0; k < 5; ++k) {
    BOOST_TEST(modes.power[even][k] == 1.0, tt::tolerance(1e-13));
    BOOST_TEST(modes.power[odd][k] < 1e-25);
    BOOST_TEST(modes.power[varicose][k] == 2.0, tt::tolerance(1e-13));
  }
  BOOST_TEST(modes.noise[even] == 1.0);
  BOOST_TEST(modes.noise[odd] < 1e-25);
  BOOST_TEST(modes.noise[varicose] == 2.0, tt::tolerance(1e-13));
  BOOST_TEST(modes.band.x == std::cos(0.6 * pi), tt::tolerance(1e-13));
  BOOST_TEST(modes.band.y == std::sin(0.6 * pi), tt::tolerance(1e-13));
}

// Two disks at heights 1/2 +- t: phi of each about the middle.
BOOST_AUTO_TEST_CASE(powers_are_those_of_the_definition) {
  const double t = 0.1, x = 0.4;
  const State state{{{0, 0.5 - t}, {x, 0.5 + t}}, {{0, 0}, {0, 0}}};
  const DensityModes modes = density_modes(state, length, 3);
  const double s = 2 * std::pow(std::sin(2 * pi * t), 2), c = 2 * std::pow(std::cos(2 * pi * t), 2);
  for (std::size_t k = 0; k < 3; ++k) {
    const double phase = 2 * pi * static_cast<double>(k + 1) * x / length;
    BOOST_TEST(modes.power[even][k] == (1 + std::cos(phase)) / 2, tt::tolerance(1e-12));
    BOOST_TEST(modes.power[odd][k] == s * (1 - std::cos(phase)) / 2, tt::tolerance(1e-12));
    BOOST_TEST(modes.power[varicose][k] == c * (1 + std::cos(phase)) / 2, tt::tolerance(1e-12));
  }
  BOOST_TEST(modes.noise[odd] == s / 2, tt::tolerance(1e-13));
  BOOST_TEST(modes.noise[varicose] == c / 2, tt::tolerance(1e-13));
}

// Rough and smooth walls shift a structure; its parity is about its own middle.
BOOST_AUTO_TEST_CASE(a_shift_across_the_channel_changes_no_power) {
  const auto swinging = [](double x) { return 0.08 * wave(x); };
  const State here = band(swinging, [](double) { return 0.15; });
  State there = here;
  for (Vec2& r : there.position) r.y -= 0.2;
  const DensityModes middle = density_modes(here, length, 3), shifted = density_modes(there, length, 3);
  for (std::size_t s = 0; s < 3; ++s)
    for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(std::abs(middle.power[s][k] - shifted.power[s][k]) < 1e-13);
  BOOST_TEST(std::abs(std::atan2(shifted.band.y, shifted.band.x) / (2 * pi) + 0.2) < 1e-12);
}

// Independent disks: N |a_k|^2 has mean 1 and, for many disks, deviation 1. Over 2000 states a mean is known to
// 1/sqrt(2000); 4.5 such errors for 12 means are a false alarm in 12,000.
BOOST_AUTO_TEST_CASE(a_uniform_gas_has_the_noise_of_independent_disks_and_no_more) {
  constexpr int states = 2000, disks = 100;
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> x(0, length), y(0, 1);
  std::array<std::array<double, 4>, 3> power{};
  std::array<double, 3> noise{};
  for (int n = 0; n < states; ++n) {
    State state;
    for (int i = 0; i < disks; ++i) state.position.push_back({x(generator), y(generator)});
    const DensityModes modes = density_modes(state, length, 4);
    for (std::size_t s = 0; s < 3; ++s) {
      noise[s] += modes.noise[s] / states;
      for (std::size_t k = 0; k < 4; ++k) power[s][k] += modes.power[s][k] / states;
    }
  }
  const double error = 4.5 / std::sqrt(states) / disks;
  for (std::size_t s = 0; s < 3; ++s) {
    BOOST_TEST(std::abs(noise[s] - 1.0 / disks) < error);
    for (std::size_t k = 0; k < 4; ++k) BOOST_TEST(std::abs(power[s][k] - noise[s]) < error);
  }
}

BOOST_AUTO_TEST_CASE(a_plug_has_no_mode) {
  const DensityModes modes = density_modes(band(none, [](double) { return 0.2; }), length, 4);
  for (const auto& power : modes.power)
    for (const double p : power) BOOST_TEST(p < 1e-25);
}

// A slug that fills the part f of the length evenly: |a_k| = sin(pi k f)/(pi k f), and nothing odd.
BOOST_AUTO_TEST_CASE(a_slug_is_even) {
  constexpr double f = 1.0 / 3;
  State slug = band(
      none, [](double) { return 0.2; }, 480);
  for (Vec2& r : slug.position) r.x = 1.2 + f * r.x;
  const DensityModes modes = density_modes(slug, length, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = std::sin(pi * static_cast<double>(k + 1) * f) / (pi * static_cast<double>(k + 1) * f);
    BOOST_TEST(std::abs(modes.power[even][k] - a * a) < 1e-5);
    BOOST_TEST(modes.power[odd][k] < 1e-25);
    // cos 2 pi t averaged over |t| < 0.2
    BOOST_TEST(std::abs(modes.power[varicose][k] - 2 * std::pow(a * std::sin(0.4 * pi) / (0.4 * pi), 2)) < 1e-3);
  }
}

// A band displaced by D cos(2 pi x/L): at height D cos, sqrt(2) sin(2 pi D cos) has the first coefficient
// sqrt(2) J_1(2 pi D), times the mean of cos 2 pi t over the band.
BOOST_AUTO_TEST_CASE(a_winding_band_is_odd) {
  constexpr double amplitude = 0.12, half = 0.15;
  const State state = band([](double x) { return amplitude * wave(x); }, [](double) { return half; });
  const DensityModes modes = density_modes(state, length, 2);
  const double a =
      std::numbers::sqrt2 * std::cyl_bessel_j(1, 2 * pi * amplitude) * std::sin(2 * pi * half) / (2 * pi * half);
  BOOST_TEST(std::abs(modes.power[odd][0] - a * a) < 1e-3 * a * a);
  BOOST_TEST(modes.power[odd][1] < 1e-25);
  BOOST_TEST(modes.power[even][0] < 1e-25);
  BOOST_TEST(modes.power[varicose][0] < 1e-25);  // it bends away from the centre twice a period
  BOOST_TEST(modes.power[varicose][1] > 1e-3);
}

// A band of half width h + D cos(2 pi x/L) with as many disks everywhere: even in y, but no slug. To first order in D
// the coefficient is sqrt(2) (D/2) d/dh [sin(2 pi h)/(2 pi h)].
BOOST_AUTO_TEST_CASE(a_band_that_swells_is_varicose) {
  constexpr double amplitude = 0.01, h = 0.25;
  const State state = band(none, [](double x) { return h + amplitude * wave(x); });
  const DensityModes modes = density_modes(state, length, 1);
  const double slope = (std::cos(2 * pi * h) - std::sin(2 * pi * h) / (2 * pi * h)) / h;
  const double a = std::numbers::sqrt2 * amplitude / 2 * slope;
  BOOST_TEST(std::abs(modes.power[varicose][0] - a * a) < 0.01 * a * a);
  BOOST_TEST(modes.power[even][0] < 1e-25);
  BOOST_TEST(modes.power[odd][0] < 1e-25);
}

BOOST_AUTO_TEST_CASE(powers_do_not_depend_on_where_along_the_channel) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  State state;
  for (int i = 0; i < 50; ++i) state.position.push_back({length * uniform(generator), uniform(generator)});
  const DensityModes here = density_modes(state, length, 6), there = density_modes(shifted(state, 1.234), length, 6);
  for (std::size_t s = 0; s < 3; ++s)
    for (std::size_t k = 0; k < 6; ++k) BOOST_TEST(std::abs(here.power[s][k] - there.power[s][k]) < 1e-13);
}

// High wavenumbers come by rotation: still those of the definition.
BOOST_AUTO_TEST_CASE(the_recurrence_keeps_its_accuracy) {
  const State state{{{0.3, 0.5}, {1.9, 0.5}}, {{0, 0}, {0, 0}}};
  const DensityModes modes = density_modes(state, length, 400);
  for (const int k : {1, 7, 400})
    BOOST_TEST(std::abs(modes.power[even][static_cast<std::size_t>(k - 1)] -
                        std::pow(std::cos(pi * k * 1.6 / length), 2)) < 1e-11);
}

BOOST_AUTO_TEST_CASE(a_run_sums_them_over_its_samples_where_it_is_asked_to) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = 2;
  scene.width_over_diameter = 10;
  scene.length_over_width = length;
  scene.gravity = 1;
  Run run{.sample_interval = 1, .bins = 2, .density_modes = 3};
  const State first{{{0.3, 0.4}, {1.9, 0.7}}, {{0, 0}, {0, 0}}}, second = {{{0.1, 0.2}, {1.0, 0.6}}, {{0, 0}, {0, 0}}};
  Measurement m(scene, run);
  m.begin(0, first);
  m.sample(1, first);
  m.sample(2, second);
  const DensityModes one = density_modes(first, length, 3), two = density_modes(second, length, 3);
  const std::size_t row = m.layout().size();
  BOOST_TEST(row == TallyLayout(2).size() + 3 * 3 + 5);
  const auto at = [&](std::size_t block, Tally tally, int k = 0) {
    return m.series().sums()[block * row + m.layout().at(tally, k)];
  };
  for (int k = 0; k < 3; ++k) {
    BOOST_TEST(at(0, Tally::mode_even, k) == one.power[even][static_cast<std::size_t>(k)]);
    BOOST_TEST(at(1, Tally::mode_odd, k) == two.power[odd][static_cast<std::size_t>(k)]);
    BOOST_TEST(at(1, Tally::mode_varicose, k) == two.power[varicose][static_cast<std::size_t>(k)]);
  }
  BOOST_TEST(at(0, Tally::mode_noise_even) == 0.5);
  BOOST_TEST(at(1, Tally::mode_noise_odd) == two.noise[odd]);
  BOOST_TEST(at(0, Tally::band_cos) == one.band.x);
  BOOST_TEST(at(1, Tally::band_sin) == two.band.y);

  run.density_modes = 0;
  BOOST_TEST(Measurement(scene, run).layout().size() == TallyLayout(2).size());
}

BOOST_AUTO_TEST_SUITE_END()
