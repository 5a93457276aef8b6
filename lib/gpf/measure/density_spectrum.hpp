// The two-dimensional power spectrum of the density field of one state, as chapter 5 of the thesis shows it.
#pragma once

#include <cstddef>
#include <vector>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// Values on a mesh of `along` x `across` cells that fills 0 < x < L, 0 < y < W.
struct DensityField {
  int along = 0, across = 0;
  std::vector<double> value;  ///< along x across, row-major

  [[nodiscard]] double& at(int i, int j) { return value[place(i, j)]; }
  [[nodiscard]] double at(int i, int j) const { return value[place(i, j)]; }

 private:
  [[nodiscard]] std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(across) + static_cast<std::size_t>(j);
  }
};

/// Area fraction of each cell, a disk counted where its centre lies. Throws InputError unless both numbers are
/// positive.
DensityField density_field(const Scene& scene, const State& state, int along, int across);

/// P = 2 |X|^2/(N1 N2)^2 (thesis ch. 5), X the discrete Fourier transform of the field, N1 x N2 its mesh: half the
/// square of the amplitude of cos 2 pi (kx x/L + ky y/W), whatever the mesh; for (0, 0) twice the square of the mean.
class DensitySpectrum {
 public:
  explicit DensitySpectrum(const DensityField& field);

  [[nodiscard]] int along() const { return along_; }
  [[nodiscard]] int across() const { return across_; }
  /// For |kx| <= N1/2, |ky| <= N2/2; P(-kx, -ky) = P(kx, ky).
  [[nodiscard]] double power(int kx, int ky) const;

 private:
  int along_, across_;
  std::vector<double> power_;  ///< along x (across/2 + 1)
};

/// Mean power at (kx, ky) != (0, 0) of N disks that lie anywhere, independently: 2 nu^2/N. Every mesh has it.
double noise_of_spectrum(const Scene& scene);

}  // namespace gpf
