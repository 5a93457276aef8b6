#include "gpf/theory/enskog.hpp"

#include <cmath>

namespace gpf {

using std::numbers::pi;

double collision_rate(const Gas& gas) {
  return 2 * std::sqrt(pi * gas.granular_temperature) * gas.number_density() * gas.diameter * gas.contact_value;
}

double shear_viscosity(const Gas& gas) {
  const double nu = gas.area_fraction, g = gas.contact_value;
  const double dilute = std::sqrt(gas.granular_temperature / pi) / (2 * gas.diameter);
  return dilute * (1 / g + 2 * nu + (1 + 8 / pi) * nu * nu * g);
}

double heat_conductivity(const Gas& gas) {
  const double nu = gas.area_fraction, g = gas.contact_value;
  const double dilute = 2 * std::sqrt(gas.granular_temperature / pi) / gas.diameter;
  return dilute * (1 / g + 3 * nu + (9.0 / 4 + 4 / pi) * nu * nu * g);
}

double dissipation_rate(const Gas& gas, double normal_restitution) {
  return gas.number_density() * collision_rate(gas) / 2 * (1 - normal_restitution * normal_restitution) *
         gas.granular_temperature;
}

double haff_temperature(const Gas& gas, double normal_restitution, double time) {
  const double cooling_rate = (1 - normal_restitution * normal_restitution) * collision_rate(gas) / 2;
  const double slowing = 1 + cooling_rate * time / 2;
  return gas.granular_temperature / (slowing * slowing);
}

}  // namespace gpf
