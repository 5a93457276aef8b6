// Channel hydrodynamics: the steady profiles that kinetic theory gives, in milliseconds.
#pragma once

#include <vector>

#include "gpf/scene/scene.hpp"

namespace gpf {

/// Steady fields on a grid of cells that fills the centres' room d/2 < y < 1 - d/2. Units as in Scene.
struct ChannelProfile {
  std::vector<double> y;                     ///< middles of the cells
  std::vector<double> mean_velocity;         ///< U
  std::vector<double> granular_temperature;  ///< T = <u.u>/2
  std::vector<double> area_fraction;         ///< nu
  double pressure = 0;                       ///< P_yy, the same everywhere
  double slip_lower = 0, slip_upper = 0;     ///< U at the walls
  double shear_lower = 0, shear_upper = 0;   ///< friction on the walls, force per length along +x
  double mean_flow = 0;                      ///< mean of U over the disks
  int newton_steps = 0;
};

/// Solves for a channel scene
///   d P_xy/dy = n g,   P_xy = -mu dU/dy
///   d q/dy = mu (dU/dy)^2 - Gamma,   q = -kappa dT/dy
///   p(nu, T) = P,   integral of n over y = N/L
/// with Jenkins & Richman's closures (pressure, viscosity, conductivity, dissipation of jenkins_richman.hpp and
/// enskog.hpp; Henderson's contact value) and walls that see a Maxwellian of incoming disks: of
/// f = P/[(1 + e_w) sqrt(pi T/2)] collisions per length and time each takes (1 - beta) of the incoming tangential
/// momentum, so that the slip is (1 + beta)(1 + e_w)/(2(1 - beta)) sqrt(pi T/2) tau/P, and [(1 - beta^2)/2 + 1 - e_w^2]
/// T of the heat; tangential restitutions must lie between -1 and 1, ends excluded, for a steady state.
///
/// Finite volumes, second order in the cell; Newton's method on all unknowns at once, led from a uniform gas by
/// pseudo-time steps that double: some 15 of them, 10 to 20 ms for 100 cells.
/// Holds for small Knudsen numbers, small 1 - e_n, and below freezing: it knows neither Knudsen layers nor crystals,
/// and its normal stresses are equal. Throws InputError for a scene that is not a channel under gravity, smooth or
/// reversing walls, or less than 8 cells; PhysicsError when the iteration does not converge, or nu reaches .9.
ChannelProfile channel_flow(const Scene& scene, int cells = 100);

}  // namespace gpf
