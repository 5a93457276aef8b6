// Equations of state of elastic hard disks: Z = pA/(NT) against the area fraction nu, for infinitely many disks.
#pragma once

#include <array>
#include <numbers>

namespace gpf {

/// Area fraction of the densest packing, pi/(2 sqrt 3).
inline constexpr double close_packing = std::numbers::pi / (2 * std::numbers::sqrt3);

/// Where the fluid ends and where the hexatic begins (Bernard & Krauth, PRL 107, 155704 (2011)).
inline constexpr double freezing = 0.700, melting = 0.716;

/// Largest nu to which Kolafa and Rottner fitted: n d^2 = .88.
inline constexpr double kolafa_rottner_limit = std::numbers::pi * .88 / 4;  // .6912

struct VirialCoefficient {
  double value = 0, error = 0;
};

/// b_1 ... b_10 of Z = sum b_k nu^(k-1). The first four are exact; the others from Clisby & McCoy,
/// J. Stat. Phys. 122, 15 (2006), with their errors.
const std::array<VirialCoefficient, 10>& virial_coefficients();

/// The virial series to b_10. What is left out makes it too small, by 1e-6 relative at nu = .2, 5e-5 at .3, 7e-4 at .4.
/// @throws InputError for nu < 0.
double virial_series(double nu);

/// Z and its first two derivatives with respect to nu.
struct Derivatives {
  double value = 0, first = 0, second = 0;
};

/// Kolafa & Rottner, Mol. Phys. 104, 3435 (2006), the fit to n d^2 <= .88: sum a_i x^i with x = nu/(1 - nu).
/// Within 1e-5 relative of the true value up to nu = .67, 3e-5 at its end.
/// @throws InputError outside [0, kolafa_rottner_limit].
Derivatives kolafa_rottner_derivatives(double nu);
double kolafa_rottner(double nu);

/// Henderson's equation, (1 + nu^2/8)/(1 - nu)^2: the same as 1 + 2 nu henderson_contact_value(nu).
constexpr double henderson(double nu) { return (1 + nu * nu / 8) / ((1 - nu) * (1 - nu)); }

/// Luding's global equation of state, PRE 63, 042201 (2001), which goes over from the fluid (g4) to the crystal (free
/// volume) about nu = .70. Its error: within .075 % up to nu = .60, -.13 % from .63 to .65, -.27 % at .67, -.7 % at
/// .68, -1.6 % at .69, and between -1.8 % and +2 % in the transition, up to .72.
/// @throws InputError outside [0, close_packing).
double luding_global(double nu);

}  // namespace gpf
