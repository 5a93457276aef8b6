// Inelastic Enskog theory of disks at any restitution: pressure, shear viscosity, heat flux, dissipation (Garzo &
// Dufty, PRE 59, 5895 (1999), for d dimensions and with the modified first Sonine approximation of Garzo, Santos &
// Montanero, Physica A 376, 94 (2007), at d = 2).
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

/// The heat flux is q = -kappa grad T - mu grad n with T = <u.u>/2 the fluctuation energy per mass and n the number
/// density; this is kappa: kappa_k [1 + 3(1 + e) nu g/4] + (2/pi)(1 + e) nu^2 g kappa0 (1 + 7 a2/16) with
/// kappa_k = (kappa0/2g) {1 + 2 a2 + (3/8)(1 + e)^2 nu g [2e - 1 + (1 + e) a2]}/(nu* - 2 zeta*),
/// nu* = (1 + e)/2 [1/2 + 15(1 - e)/8 + (730 - 546 e) a2/256], zeta* as above, kappa0 = 2 sqrt(T/pi)/d.
/// e = 1: heat_conductivity(gas).
double garzo_dufty_heat_conductivity(const Gas& gas, double e);

/// mu, the diffusive heat conductivity, in units of T^1.5 d: mu_k [1 + 3(1 + e) nu g/4] with
/// mu_k = (kappa0 T/(n g)) {(1 + s) zeta* kappa_k g/kappa0 + a2/2 + (3/8)(1 + e) nu g (1 + s/2) [e (e - 1)
/// + a2 (14 - 3e + 3e^2)/6]}/(nu* - 3 zeta*/2); s is the contact value's slope d ln g/d ln nu. e = 1: zero.
double garzo_dufty_diffusive_heat_conductivity(const Gas& gas, double e, double contact_slope);

/// Energy lost per area and time in the homogeneous cooling state: dissipation_rate(gas, e) (1 + 3 a2/16). To first
/// order in the gradients a term proportional to div U comes on top; a parallel flow has none.
double garzo_dufty_dissipation_rate(const Gas& gas, double e);

}  // namespace gpf
