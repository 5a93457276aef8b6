#include "gpf/theory/jenkins_richman.hpp"

namespace gpf {

double jenkins_richman_pressure(const Gas& gas) {
  return gas.number_density() * gas.granular_temperature *
         compressibility_from_contact(gas.area_fraction, gas.contact_value);
}

double jenkins_richman_shear_stress(const Gas& gas, double shear_rate) { return -shear_viscosity(gas) * shear_rate; }

}  // namespace gpf
