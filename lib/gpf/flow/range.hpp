// Where each method was found to hold, said before it is trusted.
#pragma once

#include <string>
#include <vector>

#include "gpf/flow/method_setting.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// Measured limits. Of hydrodynamics and Monte Carlo: within them U, T and nu are within 5 % of the engine's (root mean
/// square over the bins), beyond them not in every scene that was tried; the claims limits.* read these numbers and
/// hold them against the engine, and those of soft disks. Of the engine: what the claims named here found.
namespace range {

// limits.tc, limits.collapse: the engine and its oracle
inline constexpr double tc_rate = 0.01;              ///< t_c times the collision rate of a disk
inline constexpr double tc_restitution = 0.3;        ///< e_n at and below which the flow depends on t_c, however short
inline constexpr double collapse_restitution = 0.8;  ///< without the TC model runs collapsed up to this e_n

// limits.hydrodynamics.knudsen, .restitution, .density
inline constexpr double hydrodynamics_knudsen = 0.085;      ///< Enskog's mean free path over W, at the mean nu
inline constexpr double hydrodynamics_inelasticity = 0.02;  ///< 1 - e_n
inline constexpr double hydrodynamics_density = 0.35;       ///< mean nu

// limits.monte-carlo, .density
inline constexpr double monte_carlo_cell = 1;                   ///< height of a cell over Enskog's mean free path
inline constexpr double monte_carlo_inelasticity = 0.1;         ///< 1 - e_n
inline constexpr double monte_carlo_dense = 0.3;                ///< mean nu above which dissipation makes a plug
inline constexpr double monte_carlo_dense_inelasticity = 0.01;  ///< 1 - e_n, above that nu
inline constexpr double monte_carlo_density = 0.5;              ///< mean nu

// limits.soft-disks.stiffness, .step: the pressure
inline constexpr double soft_disks_contact = 0.05;  ///< in mean free times
inline constexpr int soft_disks_steps = 8;          ///< in a contact

}  // namespace range

/// Enskog's mean free path over W, at the mean area fraction.
double knudsen_number(const Scene& scene);

/// What of the scene or the setting lies beyond its method's range: a sentence each, with the limit and the claim that
/// it is from; none when all is within.
std::vector<std::string> range_warnings(const Scene& scene, const MethodSetting& setting);

}  // namespace gpf
