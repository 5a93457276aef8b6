// Jenkins & Richman's constitutive relations of nearly elastic, nearly smooth disks, as the thesis uses them.
#pragma once

#include "gpf/theory/contact_value.hpp"
#include "gpf/theory/enskog.hpp"

namespace gpf {

/// The gas that the relations are about: contact value by eq 4.11 (Henderson).
constexpr Gas jenkins_richman_gas(double area_fraction, double granular_temperature, double diameter) {
  return {area_fraction, granular_temperature, diameter, henderson_contact_value(area_fraction)};
}

/// Pressure, a force per length: rho T (1 + 2 G), G = nu g, rho = n for unit mass (thesis eq 4.8; Jenkins & Richman,
/// Phys. Fluids 28, 3485 (1985)). To first order in 1 - e: Enskog's with restitution has (1 + e) G instead of 2 G.
double jenkins_richman_pressure(const Gas& gas);

/// P_xy = -mu dU/dy, the flux of x momentum along +y. mu is shear_viscosity(gas), half the right side of eq 4.9;
/// eq 4.12 as printed lacks the shear rate.
double jenkins_richman_shear_stress(const Gas& gas, double shear_rate);

}  // namespace gpf
