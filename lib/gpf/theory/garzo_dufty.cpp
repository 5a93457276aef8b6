#include "gpf/theory/garzo_dufty.hpp"

#include <cmath>

namespace gpf {

using std::numbers::pi;

double garzo_dufty_pressure(const Gas& gas, double e) {
  return gas.number_density() * gas.granular_temperature * (1 + (1 + e) * gas.area_fraction * gas.contact_value);
}

double garzo_dufty_viscosity(const Gas& gas, double e) {
  const double g = gas.contact_value, nu = gas.area_fraction, a2 = homogeneous_cooling_a2(e);
  const double dilute = std::sqrt(gas.granular_temperature / pi) / (2 * gas.diameter);
  const double relaxation = (1 + e) * (7 - 3 * e) / 8 * (1 + 7 * a2 / 16);
  const double cooling = (1 - e * e) / 2 * (1 + 3 * a2 / 16);
  const double kinetic = dilute / g * (1 - (1 + e) * (1 - 3 * e) * nu * g / 4) / (relaxation - cooling / 2);
  const double bulk = 8 / pi * (1 + e) * nu * nu * g * dilute * (1 - a2 / 16);
  return kinetic * (1 + (1 + e) * nu * g / 2) + bulk / 2;
}

}  // namespace gpf
