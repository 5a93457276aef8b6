// Channel hydrodynamics: the steady profiles that kinetic theory gives, in milliseconds.
#pragma once

#include <vector>

#include "gpf/scene/scene.hpp"

namespace gpf {

/// Whose constitutive relations: Jenkins & Richman's are those of elastic disks but for the dissipation, Garzo &
/// Dufty's are to all orders in 1 - e_n.
enum class Closure { jenkins_richman, garzo_dufty };

struct ChannelFlowSetting {
  int cells = 100;
  Closure closure = Closure::jenkins_richman;
};

/// Steady fields on a grid of cells that fills the centres' room d/2 < y < 1 - d/2. Units as in Scene.
struct ChannelProfile {
  std::vector<double> y;                     ///< middles of the cells
  std::vector<double> mean_velocity;         ///< U
  std::vector<double> granular_temperature;  ///< T = <u.u>/2
  std::vector<double> area_fraction;         ///< nu
  double pressure = 0;                       ///< P_yy, the same everywhere
  double slip_lower = 0, slip_upper = 0;     ///< U at the walls
  double shear_lower = 0, shear_upper = 0;   ///< friction on the walls, force per length along +x
  double heat_lower = 0, heat_upper = 0;     ///< heat into the walls, power per length, less that of friction and slip
  double mean_flow = 0;                      ///< mean of U over the disks
  int newton_steps = 0;
};

/// Solves for a channel scene
///   d P_xy/dy = n g,   P_xy = -eta dU/dy
///   d q/dy = eta (dU/dy)^2 - Gamma,   q = -kappa dT/dy - mu dn/dy
///   p(nu, T) = P,   integral of n over y = N/L
/// with a closure's pressure p, viscosity eta, conductivities kappa and mu (zero for Jenkins & Richman) and dissipation
/// Gamma (jenkins_richman.hpp and enskog.hpp, or garzo_dufty.hpp; Henderson's contact value), and walls that see a
/// Maxwellian of incoming disks: of f = P/[(1 + e_w) sqrt(pi T/2)] collisions per length and time each takes (1 - beta)
/// of the incoming tangential momentum, so that the slip is (1 + beta)(1 + e_w)/(2(1 - beta)) sqrt(pi T/2) tau/P, and
/// [(1 - beta^2)/2 + 1 - e_w^2] T of the heat; tangential restitutions must lie between -1 and 1, ends excluded, for a
/// steady state. e_n = 1: both closures are the same.
///
/// Finite volumes, second order in the cell; Newton's method on all unknowns at once, led from a uniform gas by
/// pseudo-time steps that double: some 15 of them, 15 to 60 ms for 100 cells. Where that fails, from elastic disks by
/// steps in 1 - e_n: a second or so. Strongly inelastic, wide channels need more cells.
/// Holds for small Knudsen numbers, and below freezing (nu about .7): it knows neither Knudsen layers nor crystals nor
/// clusters, and its normal stresses are equal. Against the engine at W/d 31, nu .05 to .3, beta_w .1 and .9: at e_n
/// .99 U and T are within 1 to 5 % (nu .05: 10 % in T) with either closure. At e_n .8 they are off by 13 to 22 and 36
/// to 40 % at nu .15 and .3 with Jenkins & Richman, by 8 to 21 and 22 to 35 % with Garzo & Dufty, whose plug is too
/// dense at nu .3 (nu off by 10 %, not 5 %); at nu .05 (T: 22 to 27 %) neither is better. Throws InputError for a scene
/// that is not a channel under gravity, smooth or reversing walls, less than 8 cells or more than 10000; PhysicsError when the
/// iteration does not converge, or nu exceeds .9 at the scene's e_n or on the way there.
ChannelProfile channel_flow(const Scene& scene, const ChannelFlowSetting& setting = {});

}  // namespace gpf
