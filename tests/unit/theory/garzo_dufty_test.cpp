// Inelastic Enskog theory: its elastic limit, its dilute limit by hand, and the virial.
#include "gpf/theory/garzo_dufty.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/theory/contact_value.hpp"
#include "gpf/theory/jenkins_richman.hpp"

namespace {

using namespace gpf;
using std::numbers::pi;

const Gas gas{0.37, 2.3, 0.71, henderson_contact_value(0.37)};

BOOST_AUTO_TEST_SUITE(garzo_dufty)

BOOST_AUTO_TEST_CASE(elastic_disks_are_those_of_enskog) {
  const auto close = boost::test_tools::tolerance(1e-14);
  for (const double nu : {1e-6, 0.05, 0.3, 0.6}) {
    const Gas elastic{nu, 2.3, 0.71, henderson_contact_value(nu)};
    BOOST_TEST(garzo_dufty_viscosity(elastic, 1) == shear_viscosity(elastic), close);
    BOOST_TEST(garzo_dufty_pressure(elastic, 1) == jenkins_richman_pressure(elastic), close);
    BOOST_TEST(garzo_dufty_heat_conductivity(elastic, 1) == heat_conductivity(elastic), close);
    BOOST_TEST(garzo_dufty_diffusive_heat_conductivity(elastic, 1, henderson_contact_slope(nu)) == 0);
    BOOST_TEST(garzo_dufty_dissipation_rate(elastic, 1) == 0);
  }
}

BOOST_AUTO_TEST_CASE(dilute_gas_by_hand) {
  // e = 0: a2 = 16/57, nu* = 7/8 (1 + 7/57) = 56/57, zeta* = (1 + 3/57)/2 = 10/19; eta/eta0 = 1/(56/57 - 5/19) = 57/41.
  const Gas dilute{1e-12, 2.3, 0.71, 1};
  const double eta0 = std::sqrt(2.3 / pi) / 1.42;
  const auto close = boost::test_tools::tolerance(1e-10);
  BOOST_TEST(garzo_dufty_viscosity(dilute, 0) / eta0 == 57.0 / 41, close);
  // e = .8: a2 = -.0219393, nu* = 1.0250656, zeta* = .1792595: 1/(.9354359) = 1.069021.
  BOOST_TEST(garzo_dufty_viscosity(dilute, 0.8) / eta0 == 1.069021, boost::test_tools::tolerance(1e-6));
}

// Rates of a Boltzmann gas in units of n T/eta0, kappa0 = 2 sqrt(T/pi)/d (Brey, Dufty, Kim & Santos, PRE 58, 4638
// (1998); d = 2: Brey & Cubero 2001): kappa = (1 + 2 a2)/(2 (nu* - 2 zeta*)), n mu/T = (zeta* kappa + a2/2)/(nu* -
// 3 zeta*/2). They take the standard Sonine correction (14 - 6 e)/512 of nu* for our (730 - 546 e)/256.
BOOST_AUTO_TEST_CASE(heat_flux_of_a_dilute_gas_by_hand) {
  // e = 0: a2 = 16/57, zeta* = 10/19, nu* = (19/8 + (365/128)(16/57))/2 = 1448/912 = 181/114: kappa = (89/57)/(2
  // (61/114)) = 89/61; n mu/T = (890/1159 + 8/57)/(91/114).
  const Gas dilute{1e-12, 2.3, 0.71, 1};
  const double kappa0 = 2 * std::sqrt(2.3 / pi) / 0.71, mu0 = kappa0 * 2.3 / dilute.number_density();
  const auto close = boost::test_tools::tolerance(1e-10);
  BOOST_TEST(garzo_dufty_heat_conductivity(dilute, 0) / kappa0 == 89.0 / 61, close);
  BOOST_TEST(garzo_dufty_diffusive_heat_conductivity(dilute, 0, 0) / mu0 == (890.0 / 1159 + 8.0 / 57) * 114 / 91,
             close);
  // The difference is (1 + e)(361 - 271.5 e)/256 a2 of nu*, at e = .8 or more less than 1.04 a2 of .43 (kappa) and .52
  // (mu).
  for (const double e : {0.8, 0.9, 0.99}) {
    const double a2 = homogeneous_cooling_a2(e), zeta = (1 - e * e) / 2 * (1 + 3 * a2 / 16),
                 rate = (1 + e) / 2 * (0.5 + 15 * (1 - e) / 8 + (14 - 6 * e) / 512 * a2);
    const double kappa = (1 + 2 * a2) / (2 * (rate - 2 * zeta)), mu = (zeta * kappa + a2 / 2) / (rate - 3 * zeta / 2);
    BOOST_TEST(std::abs(garzo_dufty_heat_conductivity(dilute, e) / kappa0 / kappa - 1) < 6 * std::abs(a2));
    BOOST_TEST(std::abs(garzo_dufty_diffusive_heat_conductivity(dilute, e, 0) / mu0 / mu - 1) < 6 * std::abs(a2));
  }
}

// Near e = 1 a2 = -(1 - e)/2, zeta* = 1 - e, nu* = 1/2, kappa = 1 in these units: n mu/T = (zeta* + a2/2)/(1/2).
BOOST_AUTO_TEST_CASE(diffusive_conductivity_near_elastic_disks) {
  const Gas dilute{1e-12, 2.3, 0.71, 1};
  const double mu0 = 2 * std::sqrt(2.3 / pi) / 0.71 * 2.3 / dilute.number_density();
  BOOST_TEST(garzo_dufty_diffusive_heat_conductivity(dilute, 1 - 1e-7, 0) / mu0 / 1e-7 == 1.5,
             boost::test_tools::tolerance(1e-5));
}

// The collisional integrals were checked by quadrature of the Enskog operator over Gaussians with the a2 correction; nu
// g = 1, e = 1/2 are enough to tell every term: a2 = 4/48.25.
BOOST_AUTO_TEST_CASE(density_enters_the_heat_flux_as_in_the_formula) {
  const Gas dense{0.5, 2.3, 0.71, 2};
  const double a2 = 4 / 48.25, kappa0 = 2 * std::sqrt(2.3 / pi) / 0.71, slope = 0.7;
  const double zeta = 0.375 * (1 + 3 * a2 / 16), rate = 0.75 * (0.5 + 15.0 / 16 + 457.0 / 256 * a2);
  const double kinetic = 0.5 * (1 + 2 * a2 + 27.0 / 32 * 1.5 * a2) / (rate - 2 * zeta);
  const double contacts = 1 + 9.0 / 8;
  const auto close = boost::test_tools::tolerance(1e-14);
  BOOST_TEST(garzo_dufty_heat_conductivity(dense, 0.5) ==
                 kappa0 * (kinetic / 2 * contacts + 2 / pi * 1.5 * 0.5 * (1 + 7 * a2 / 16)),
             close);
  const double diffusive =
      (1.7 * zeta * kinetic + a2 / 2 + 9.0 / 16 * 1.35 * (-0.25 + a2 * 13.25 / 6)) / (rate - 1.5 * zeta);
  BOOST_TEST(garzo_dufty_diffusive_heat_conductivity(dense, 0.5, slope) ==
                 kappa0 * 2.3 / (2 * dense.number_density()) * diffusive * contacts,
             close);
}

// At constant pressure dn/dT = -(n/T) (1 + f)/(1 + f (2 + s)), f = (1 + e) nu g: heat must flow from hot to cold.
BOOST_AUTO_TEST_CASE(heat_flows_downhill_at_constant_pressure) {
  for (double e = 0; e < 1.001; e += 0.05)
    for (double nu = 0.001; nu < 0.85; nu += 0.02) {
      const Gas here{nu, 1, 1, henderson_contact_value(nu)};
      const double slope = henderson_contact_slope(nu), f = (1 + e) * nu * here.contact_value;
      const double kappa = garzo_dufty_heat_conductivity(here, e),
                   mu = garzo_dufty_diffusive_heat_conductivity(here, e, slope);
      BOOST_TEST(kappa > 0);
      BOOST_TEST(kappa > mu * here.number_density() * (1 + f) / (1 + f * (2 + slope)));
      if (e >= 0.5 && e < 0.999) BOOST_TEST(mu > 0);
    }
}

BOOST_AUTO_TEST_CASE(dissipation_is_that_of_the_cooling_state) {
  BOOST_TEST(garzo_dufty_dissipation_rate(gas, 0) == dissipation_rate(gas, 0) * (1 + 3.0 / 57),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(garzo_dufty_dissipation_rate(gas, 0.9) < dissipation_rate(gas, 0.9));  // a2 < 0 above sqrt(1/2)
}

BOOST_AUTO_TEST_CASE(density_enters_as_in_the_formula) {
  // e = 1/3 makes the bracket of the kinetic part 1: eta_k is dilute/g. nu g = 1, nu = 1/2: eta = eta_k (5/3) + gamma/2
  // with gamma = (8/pi)(4/3)(1/2) eta0 (1 - a2/16).
  const Gas dense{0.5, 2.3, 0.71, 2};
  const double e = 1.0 / 3, a2 = homogeneous_cooling_a2(e), eta0 = std::sqrt(2.3 / pi) / 1.42;
  const double relaxation = (4.0 / 3) * 6 / 8 * (1 + 7 * a2 / 16), cooling = (8.0 / 9) / 2 * (1 + 3 * a2 / 16);
  const double expected =
      eta0 / 2 / (relaxation - cooling / 2) * (5.0 / 3) + 0.5 * 16 / (3 * pi) * eta0 * (1 - a2 / 16);
  BOOST_TEST(garzo_dufty_viscosity(dense, e) == expected, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(pressure_of_contacts_falls_with_restitution) {
  const double kinetic = gas.number_density() * 2.3;
  const double contacts = jenkins_richman_pressure(gas) - kinetic;
  BOOST_TEST(garzo_dufty_pressure(gas, 0.8) == kinetic + 0.9 * contacts, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(units) {
  Gas other = gas;  // length x 3, time x 2; unit mass: pressure (mass/time^2) /4, viscosity (mass/time) /2
  other.diameter *= 3;
  other.granular_temperature *= 9.0 / 4;
  const auto close = boost::test_tools::tolerance(1e-14);
  BOOST_TEST(garzo_dufty_pressure(other, 0.7) * 4 == garzo_dufty_pressure(gas, 0.7), close);
  BOOST_TEST(garzo_dufty_viscosity(other, 0.7) * 2 == garzo_dufty_viscosity(gas, 0.7), close);
  BOOST_TEST(garzo_dufty_heat_conductivity(other, 0.7) * 2 == garzo_dufty_heat_conductivity(gas, 0.7), close);
  // q = -mu grad n: velocity^3 length, 3^4/2^3
  BOOST_TEST(garzo_dufty_diffusive_heat_conductivity(other, 0.7, 0.4) * 8 / 81 ==
                 garzo_dufty_diffusive_heat_conductivity(gas, 0.7, 0.4),
             close);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
