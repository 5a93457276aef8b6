// Enskog's kinetic theory of disks of unit mass: collision rate, free path, viscosity, dissipation, cooling.
#pragma once

#include <numbers>

namespace gpf {

/// Uniform gas of disks of unit mass. Area fraction nu > 0, T = <u.u>/2 >= 0 in units of velocity squared, diameter d >
/// 0, contact value g(d+) (see contact_value.hpp), all in one system of units.
struct Gas {
  double area_fraction = 0, granular_temperature = 0, diameter = 1, contact_value = 1;

  /// Disks per area, n = 4 nu/(pi d^2).
  [[nodiscard]] constexpr double number_density() const {
    return 4 * area_fraction / (std::numbers::pi * diameter * diameter);
  }
};

/// Collisions per disk and time, omega = 2 sqrt(pi) n d g sqrt(T). N disks make N omega/2 collisions per time.
double collision_rate(const Gas& gas);

/// Mean speed over collision rate: pi d/(8 sqrt(2) nu g).
constexpr double mean_free_path(const Gas& gas) {
  return std::numbers::pi * gas.diameter / (8 * std::numbers::sqrt2 * gas.area_fraction * gas.contact_value);
}

/// Shear viscosity of elastic disks in the first Sonine approximation (Gass, J. Chem. Phys. 54, 1898 (1971)):
/// eta0 [1/g + 2 nu + (1 + 8/pi) nu^2 g], eta0 = sqrt(T/pi)/(2d). Half the right side of thesis eq 4.9 with its m = 1.
double shear_viscosity(const Gas& gas);

/// Heat conductivity of the same in the same approximation (Gass 1971), for q = -kappa grad T with T = <u.u>/2 the
/// fluctuation energy per mass: 4 eta0 [1/g + 3 nu + (9/4 + 4/pi) nu^2 g].
double heat_conductivity(const Gas& gas);

/// Energy lost per area and time at normal restitution e, Gaussian velocities assumed: n (omega/2) (1 - e^2) T, which
/// for disks of density rho_p = 4/(pi d^2) is (4/sqrt pi)(1 - e^2) rho_p nu^2 g T^1.5/d (Jenkins & Richman 1985).
double dissipation_rate(const Gas& gas, double normal_restitution);

/// Haff's law, J. Fluid Mech. 134, 401 (1983): T at `time` in a homogeneous gas without gravity that starts as `gas`,
/// T0/(1 + zeta0 time/2)^2 with zeta0 = (1 - e^2) omega0/2. Holds while the gas stays homogeneous; the velocities are
/// taken as Gaussian (see homogeneous_cooling_a2 for what that neglects: a factor 1 + 3 a2/16 on zeta0).
double haff_temperature(const Gas& gas, double normal_restitution, double time);

/// Second Sonine coefficient of the homogeneous cooling state in two dimensions, kurtosis of u_x = 3(1 + a2) (van Noije
/// & Ernst, Granul. Matter 1, 57 (1998)). Linear theory: 10-20 % off the converged value.
constexpr double homogeneous_cooling_a2(double e) {
  return 16 * (1 - e) * (1 - 2 * e * e) / (57 - 25 * e + 30 * e * e * (1 - e));
}

}  // namespace gpf
