// Inelastic Enskog theory of disks: pressure and shear viscosity at any restitution (Garzo & Dufty, PRE 59, 5895
// (1999), for d dimensions and with the modified first Sonine approximation of Garzo, Santos & Montanero, Physica A
// 376, 94 (2007), at d = 2).
#pragma once

#include "gpf/theory/enskog.hpp"

namespace gpf {

/// e is the normal restitution.
/// Pressure n T [1 + (1 + e) nu g], a force per length.
double garzo_dufty_pressure(const Gas& gas, double e);

/// Shear viscosity to first order in the gradients, first Sonine approximation, for a gas whose temperature cools as
/// that of the homogeneous state: eta_k [1 + (1 + e) nu g/2] + gamma/2 with
/// eta_k = (eta0/g) [1 - (1 + e)(1 - 3e) nu g/4]/(nu* - zeta*/2), nu* = (1 + e)(7 - 3e)/8 (1 + 7 a2/16),
/// zeta* = (1 - e^2)/2 (1 + 3 a2/16), gamma = (8/pi)(1 + e) nu^2 g eta0 (1 - a2/16), eta0 = sqrt(T/pi)/(2d).
/// e = 1: shear_viscosity(gas).
double garzo_dufty_viscosity(const Gas& gas, double e);

}  // namespace gpf
