// Density modes: how the disks of a channel are arranged along it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gpf/base/vec2.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// How a mode varies across the channel, phi(y) with y in units of W and c the height of the band's middle. The three
/// are orthonormal over 0 < y < 1.
enum class ModeShape : std::size_t {
  even,     ///< 1: slugs and clumps, the disks per length of channel
  odd,      ///< sqrt(2) sin 2 pi (y - c): a band that winds to and fro (sinuous wave)
  varicose  ///< sqrt(2) cos 2 pi (y - c): a band that swells and shrinks; a slug of finite height has it too
};
inline constexpr std::array mode_shapes{ModeShape::even, ModeShape::odd, ModeShape::varicose};

/// Amplitudes a_k of one state and their powers for k = 1 ... count, with
///   a_k = (1/N) sum_j exp(2 pi i k x_j/L) phi(y_j):
/// thesis ch. 5, the Fourier coefficients of the density field, with the disks' places instead of a mesh, and resolved
/// by parity across the channel instead of k_y, since a slug and a wave both have the coefficient (1, 1). The parity is
/// that about the middle of the band, c = 1/2 + arg(band)/(2 pi): walls of different roughness shift the band, and a
/// slug off the centre plane would be odd about that. No units; |a_k| <= 1 for `even`, sqrt(2) for the others. Phases
/// drift with the flow: only powers can be averaged over time.
struct DensityModes {
  std::array<std::vector<Vec2>, 3> amplitude;  ///< a_k, real and imaginary part, [shape][k - 1]
  std::array<std::vector<double>, 3> power;    ///< |a_k|^2, [shape][k - 1]
  /// What the power is on average when the disks of these heights lie anywhere along the channel, independently:
  /// (1/N^2) sum_j phi(y_j)^2, which is 1/N for `even`. Disks exclude one another and so have less.
  std::array<double, 3> noise{};  ///< [shape]
  /// Mean over the disks of exp(2 pi i (y - 1/2)), the thesis' coefficient (0, 1) of a plug: 0 for a uniform gas, its
  /// argument the shift of the band's middle toward the upper wall in units of W/(2 pi).
  Vec2 band;
};

/// @param length L, in units of W like the positions; @param count number of wavenumbers, at least 1.
/// Costs two pairs of sine and cosine a disk, and a rotation for each wavenumber: 80 ns a disk for four.
DensityModes density_modes(const State& state, double length, int count);

}  // namespace gpf
