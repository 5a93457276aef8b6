// From a few hundred disks in a periodic box to infinitely many, and back.
#pragma once

#include <cstdint>

#include "gpf/theory/equation_of_state.hpp"

namespace gpf {

/// Largest nu at which the density-fluctuation term is used. Against Li et al. (2022), N = 870: it leaves 2e-5 of Z up
/// to nu = .674, 2e-4 at .684; from .688 on it overshoots by as much as it mends, and more.
inline constexpr double finite_size_limit = 0.685;

/// Z_N - Z of N disks at fixed N in a periodic box, to order 1/N: -(nu/2N) d ln(Z + nu Z')/dnu, from the Z of the
/// infinite system and its derivatives at nu. The term of the density fluctuations that a box of fixed N lacks
/// (Lebowitz & Percus, Phys. Rev. 124, 1673 (1961)); exact for hard rods on a ring.
constexpr double density_fluctuation_term(Derivatives z, double nu, std::int64_t disks) {
  return -nu / (2 * static_cast<double>(disks)) * (2 * z.first + nu * z.second) / (z.value + nu * z.first);
}

/// Z_N of the canonical ensemble, from Kolafa & Rottner.
/// @throws InputError outside [0, finite_size_limit], and for fewer than two disks.
double finite_size_compressibility(double nu, std::int64_t disks);

/// Z of the infinite system from an event-driven run: `measured` = pA/(NT) of N disks in a periodic box with zero total
/// momentum, T = kinetic energy/(N - 1).
///
/// - nu <= finite_size_limit: measured + 1/N - density_fluctuation_term. The 1/N is exact: total momentum zero takes
///   1/N from the kinetic part of the pressure, while the collisional part is that of the canonical ensemble.
/// - nu >= melting: measured N/(N - 1), the free-volume form of a crystal without defects, exact on approach to close
///   packing (Salsburg & Wood, J. Chem. Phys. 37, 798 (1962)): there ln Q grows with 2(N - 1) degrees of freedom.
///   Event-driven runs of a perfect crystal: what it leaves at N = 36 is 3e-4 of Z at nu = .85 and 2e-3 at .76, and
///   nothing measurable at N = 144 (2e-4).
/// - between: measured + 1/N only. The rest is governed by the shape of the box and by the interface between the phases
///   (0.4 % at N = 870, nu = .698; up to 2 % at .71), and no formula is known.
/// @throws InputError outside [0, close_packing), and for fewer than two disks.
double infinite_system_compressibility(double measured, double nu, std::int64_t disks);

/// Collision rate of N disks at zero total momentum over that of infinitely many at the same T = kinetic
/// energy/(N - 1) and contact value: <|v|>/sqrt(<v^2>) of a point on a sphere in 2(N - 1) dimensions against a
/// Gaussian, sqrt(z) Gamma(z)/Gamma(z + 1/2) with z = N - 1, as its series 1 + 1/(8z) + 1/(128 z^2) - 5/(1024 z^3).
/// @throws InputError for fewer than two disks.
double finite_size_rate_factor(std::int64_t disks);

}  // namespace gpf
