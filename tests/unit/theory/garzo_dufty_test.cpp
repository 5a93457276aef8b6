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
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
