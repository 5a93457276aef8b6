// Spectra of fields whose Fourier series is known, and of disks thrown at random.
#include "gpf/measure/density_spectrum.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"
#include "gpf/base/random.hpp"

using namespace gpf;
namespace tt = boost::test_tools;

namespace {

constexpr double turn = 2 * std::numbers::pi;

Scene channel(int disks) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.particles = disks;
  scene.width_over_diameter = 31;
  scene.length_over_width = 2;
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(density_spectrum_test)

BOOST_AUTO_TEST_CASE(an_amplitude_gives_half_its_square_on_every_mesh) {
  for (const auto& [along, across] : {std::pair{16, 8}, {32, 18}, {15, 9}}) {
    DensityField field{along, across, std::vector<double>(static_cast<std::size_t>(along * across))};
    for (int i = 0; i < along; ++i)
      for (int j = 0; j < across; ++j) {
        const double x = (i + 0.5) / along, y = (j + 0.5) / across;
        field.at(i, j) = 0.3 + 0.2 * std::cos(turn * (x + y)) + 0.1 * std::sin(turn * (2 * x - 3 * y));
      }
    const DensitySpectrum spectrum(field);
    BOOST_TEST(spectrum.power(0, 0) == 2 * 0.09, tt::tolerance(1e-12));
    BOOST_TEST(spectrum.power(1, 1) == 0.02, tt::tolerance(1e-12));
    BOOST_TEST(spectrum.power(-1, -1) == 0.02, tt::tolerance(1e-12));
    BOOST_TEST(spectrum.power(2, -3) == 0.005, tt::tolerance(1e-12));
    BOOST_TEST(spectrum.power(-2, 3) == 0.005, tt::tolerance(1e-12));
    BOOST_TEST(spectrum.power(1, -1) < 1e-28);
    BOOST_TEST(spectrum.power(1, 0) < 1e-28);
  }
}

BOOST_AUTO_TEST_CASE(the_field_is_the_area_fraction_where_the_centres_lie) {
  const Scene scene = channel(3);
  const State state{{{0.1, 0.1}, {0.2, 0.2}, {1.999999, 0.9999}}, {{0, 0}, {0, 0}, {0, 0}}};
  const DensityField field = density_field(scene, state, 4, 2);
  const double disk = std::numbers::pi / 4 / (31 * 31), cell = 2.0 / 8;
  BOOST_TEST(field.at(0, 0) == 2 * disk / cell, tt::tolerance(1e-12));
  BOOST_TEST(field.at(3, 1) == disk / cell, tt::tolerance(1e-12));
  double sum = 0;
  for (const double v : field.value) sum += v / 8;
  BOOST_TEST(sum == scene.area_fraction(), tt::tolerance(1e-12));
  BOOST_CHECK_THROW(density_field(scene, state, 0, 2), InputError);
}

// Exponentially distributed powers: the mean of 400 of them is known to 5 %; 4.5 such errors.
BOOST_AUTO_TEST_CASE(independent_disks_have_the_noise_that_is_stated) {
  const Scene scene = channel(500);
  double sum = 0;
  constexpr int states = 100;
  for (std::uint64_t n = 0; n < states; ++n) {
    State state;
    for (std::uint64_t i = 0; i < 500; ++i) {
      const auto words = random_words(n, 0, i);
      state.position.push_back({2 * std::ldexp(words[0], -32), std::ldexp(words[1], -32)});
    }
    const DensitySpectrum spectrum(density_field(scene, state, 32, 16));
    for (const auto& [kx, ky] : {std::pair{1, 0}, {0, 1}, {3, -2}, {5, 4}}) sum += spectrum.power(kx, ky);
  }
  BOOST_TEST(std::abs(sum / (4 * states) / noise_of_spectrum(scene) - 1) < 4.5 * 0.05);
}

// A plug at (0, 1), a winding band at (1, 1), a slug at (1, 0): the peaks of the thesis.
BOOST_AUTO_TEST_CASE(structures_have_the_peaks_of_the_thesis) {
  const Scene scene = channel(2400);
  const auto spectrum_of = [&](auto place) {
    State state;
    for (int i = 0; i < 60; ++i)
      for (int j = 0; j < 40; ++j) state.position.push_back(place((i + 0.5) / 60, (j + 0.5) / 40));
    return DensitySpectrum(density_field(scene, state, 32, 32));
  };
  const auto plug = spectrum_of([](double a, double b) { return Vec2{2 * a, 0.3 + 0.4 * b}; });
  const auto wave = spectrum_of([](double a, double b) {
    return Vec2{2 * a, 0.3 + 0.12 * std::cos(turn * a) + 0.4 * b};
  });
  const auto slug = spectrum_of([](double a, double b) { return Vec2{0.8 + 0.8 * a, 0.3 + 0.4 * b}; });
  BOOST_TEST(plug.power(0, 1) > 100 * std::max(plug.power(1, 0), plug.power(1, 1)));
  BOOST_TEST(wave.power(1, 1) > 100 * wave.power(1, 0));
  BOOST_TEST(slug.power(1, 0) > 0.1 * slug.power(0, 1));
  BOOST_TEST(slug.power(1, 1) > 100 * plug.power(1, 1));  // which is why (1, 1) alone tells no wave from a slug
}

BOOST_AUTO_TEST_SUITE_END()
