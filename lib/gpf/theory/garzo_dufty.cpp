#include "gpf/theory/garzo_dufty.hpp"

#include <cmath>

namespace gpf {

using std::numbers::pi;

namespace {

/// Rates over n T/eta0 and g, and the conductivity of elastic disks at low density.
struct HeatFlux {
  double a2, cooling, relaxation, dilute;
  HeatFlux(const Gas& gas, double e)
      : a2(homogeneous_cooling_a2(e)),
        cooling((1 - e * e) / 2 * (1 + 3 * a2 / 16)),
        relaxation((1 + e) / 2 * (0.5 + 15 * (1 - e) / 8 + (730 - 546 * e) / 256 * a2)),
        dilute(2 * std::sqrt(gas.granular_temperature / pi) / gas.diameter) {}

  /// kappa_k g/kappa0.
  [[nodiscard]] double kinetic(double nu_g, double e) const {
    return (1 + 2 * a2 + 3 * (1 + e) * (1 + e) * nu_g / 8 * (2 * e - 1 + (1 + e) * a2)) /
           (2 * (relaxation - 2 * cooling));
  }
};

}  // namespace

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

double garzo_dufty_heat_conductivity(const Gas& gas, double e) {
  const HeatFlux flux(gas, e);
  const double g = gas.contact_value, nu = gas.area_fraction;
  return flux.dilute * (flux.kinetic(nu * g, e) / g * (1 + 3 * (1 + e) * nu * g / 4) +
                        2 / pi * (1 + e) * nu * nu * g * (1 + 7 * flux.a2 / 16));
}

double garzo_dufty_diffusive_heat_conductivity(const Gas& gas, double e, double contact_slope) {
  const HeatFlux flux(gas, e);
  const double g = gas.contact_value, nu_g = gas.area_fraction * g;
  const double contacts =
      3 * (1 + e) * nu_g / 8 * (1 + contact_slope / 2) * (e * (e - 1) + flux.a2 * (14 - 3 * e + 3 * e * e) / 6);
  const double kinetic = ((1 + contact_slope) * flux.cooling * flux.kinetic(nu_g, e) + flux.a2 / 2 + contacts) /
                         (flux.relaxation - 3 * flux.cooling / 2);
  return flux.dilute * gas.granular_temperature / (gas.number_density() * g) * kinetic * (1 + 3 * (1 + e) * nu_g / 4);
}

double garzo_dufty_dissipation_rate(const Gas& gas, double e) {
  return dissipation_rate(gas, e) * (1 + 3 * homogeneous_cooling_a2(e) / 16);
}

}  // namespace gpf
