// Kinetic theory: exact relations between its parts, published numbers, limits, and scaling.
#include "gpf/theory/enskog.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "gpf/base/vec2.hpp"
#include "gpf/theory/contact_value.hpp"

namespace {

using namespace gpf;
using std::numbers::pi;

/// No unit parameters, so that no power of T or d can hide.
const Gas gas{0.37, 2.3, 0.71, henderson_contact_value(0.37)};

BOOST_AUTO_TEST_SUITE(enskog)

BOOST_AUTO_TEST_CASE(number_density_is_area_fraction_over_disk_area) {
  BOOST_TEST(gas.number_density() * pi * square(gas.diameter / 2) == 0.37, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(collision_rate_and_pressure_are_one) {
  // Virial: (Z - 1) n T = half the collisions per area x diameter x mean impulse sqrt(pi T). So omega = 4 (Z - 1)
  // sqrt(T/pi)/d.
  const double z = compressibility_from_contact(gas.area_fraction, gas.contact_value);
  BOOST_TEST(collision_rate(gas) == 4 * (z - 1) * std::sqrt(2.3 / pi) / 0.71, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(free_path_is_mean_speed_over_rate) {
  BOOST_TEST(mean_free_path(gas) == std::sqrt(pi * 2.3 / 2) / collision_rate(gas), boost::test_tools::tolerance(1e-14));
  // .27768 d/(nu g), printed to five digits.
  const Gas dilute{0.01, 1, 1, 1};
  BOOST_TEST(std::abs(mean_free_path(dilute) * 0.01 - 0.27768) < 5e-6);
  // W = 31 d: lambda/W = .583 at nu .015 and .0098 at .4, with Henderson's contact value.
  const auto knudsen = [](double nu) { return mean_free_path({nu, 1, 1 / 31.0, henderson_contact_value(nu)}); };
  BOOST_TEST(std::abs(knudsen(0.015) - 0.583) < 5e-4);
  BOOST_TEST(std::abs(knudsen(0.4) - 0.0098) < 5e-5);
}

BOOST_AUTO_TEST_CASE(dissipation_is_that_of_jenkins_and_richman) {
  // (4/sqrt pi)(1 - e^2) rho_p nu^2 g T^1.5/d with rho_p = 4/(pi d^2).
  const double e = 0.83, density = 4 / (pi * 0.71 * 0.71);
  const double expected =
      4 / std::sqrt(pi) * (1 - e * e) * density * 0.37 * 0.37 * gas.contact_value * std::pow(2.3, 1.5) / 0.71;
  BOOST_TEST(dissipation_rate(gas, e) == expected, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(dissipation_rate(gas, 1) == 0.0);
}

BOOST_AUTO_TEST_CASE(haff_solves_its_energy_balance) {
  // d(n T)/dt = -dissipation, at the start and later; central difference with h = 1e-4: h^2 of relative error.
  const double e = 0.83, h = 1e-4;
  BOOST_TEST(haff_temperature(gas, e, 0) == 2.3);
  for (const double t : {0.5, 3.0, 40.0}) {
    Gas later = gas;
    later.granular_temperature = haff_temperature(gas, e, t);
    const double slope = (haff_temperature(gas, e, t + h) - haff_temperature(gas, e, t - h)) / (2 * h);
    BOOST_TEST(gas.number_density() * slope == -dissipation_rate(later, e), boost::test_tools::tolerance(1e-6));
  }
  BOOST_TEST(haff_temperature(gas, 1, 100) == 2.3);
}

BOOST_AUTO_TEST_CASE(haff_decays_as_one_over_time_squared) {
  const double t = 1e6, zeta0 = (1 - 0.83 * 0.83) * collision_rate(gas) / 2;
  BOOST_TEST(haff_temperature(gas, 0.83, t) == 2.3 / square(zeta0 * t / 2), boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(viscosity) {
  // Dilute: sqrt(T/pi)/(2 d), whatever the density (Maxwell).
  const Gas dilute{1e-9, 2.3, 0.71, 1};
  BOOST_TEST(shear_viscosity(dilute) == std::sqrt(2.3 / pi) / 1.42, boost::test_tools::tolerance(1e-8));
  // Thesis eq 4.9 with m = 1 is twice it: (nu/d) sqrt(T/pi) [8 G/pi + 1/G + 2 + G], G = nu g.
  const double g = 0.37 * gas.contact_value;
  BOOST_TEST(2 * shear_viscosity(gas) == 0.37 / 0.71 * std::sqrt(2.3 / pi) * (8 * g / pi + 1 / g + 2 + g),
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(conductivity) {
  // Dilute: four times the viscosity (Gass).
  const Gas dilute{1e-9, 2.3, 0.71, 1};
  BOOST_TEST(heat_conductivity(dilute) == 4 * shear_viscosity(dilute), boost::test_tools::tolerance(1e-8));
  const double nu = 0.37, g = gas.contact_value;
  BOOST_TEST(heat_conductivity(gas) * 0.71 / (2 * std::sqrt(2.3 / pi)) ==
                 1 / g + 3 * nu + 9 * nu * nu * g / 4 + 4 * nu * nu * g / pi,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(sonine_coefficient) {
  BOOST_TEST(homogeneous_cooling_a2(1) == 0.0);
  BOOST_TEST(std::abs(homogeneous_cooling_a2(std::numbers::sqrt2 / 2)) < 1e-15);  // changes sign at 1/sqrt 2
  BOOST_TEST(homogeneous_cooling_a2(0.9) < 0);
  BOOST_TEST(homogeneous_cooling_a2(0.5) > 0);
  // e = 0: 16/57.
  BOOST_TEST(homogeneous_cooling_a2(0) == 16.0 / 57, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(units) {
  // Length x 3, time x 2: rates /2, free path x 3, viscosity of unit mass /2, dissipation (per area and time,
  // mass/time^3) /8.
  Gas other = gas;
  other.diameter *= 3;
  other.granular_temperature *= 9.0 / 4;
  const auto close = boost::test_tools::tolerance(1e-14);
  BOOST_TEST(collision_rate(other) * 2 == collision_rate(gas), close);
  BOOST_TEST(mean_free_path(other) == 3 * mean_free_path(gas), close);
  BOOST_TEST(shear_viscosity(other) * 2 == shear_viscosity(gas), close);
  BOOST_TEST(dissipation_rate(other, 0.7) * 8 == dissipation_rate(gas, 0.7), close);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
