// Frames as a page keeps them: small, and with what is plotted beside them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// Collects frame after frame. All texts hold raw bytes, little-endian.
class PackedFrames {
 public:
  static constexpr int most_kx = 8, most_ky = 4;  ///< of the density spectrum
  static constexpr double spectrum_decades = 4;   ///< of power over the noise, from 0 to 255

  /// `modes`: streamwise wavenumbers whose density modes are kept; 0: none.
  PackedFrames(const Scene& scene, int bins, int modes) : scene_(scene), bins_(bins), modes_(modes) {}

  void add(const State& state);

  /// Of each frame: x/L of all disks in units of 2^-16, then y/W.
  std::string positions;
  /// Of each frame: v_x of all disks from least to greatest in 255 steps, then v_y.
  std::string velocities;
  /// Of each frame, as float: least and greatest v_x, least and greatest v_y.
  std::string velocity_ranges;
  /// Of each frame, as float: mean velocity of the bins, then granular temperature, then area fraction. NaN: no disk.
  std::string profiles;
  /// Of each frame: log10(power/noise) of the density at 0 <= kx <= most_kx, for each of these |ky| <= most_ky, from 0
  /// to spectrum_decades in 256 steps.
  std::string spectra;
  /// Of each frame, as float: power/noise of the even density modes k = 1, 2, ..., then odd, then varicose.
  std::string density_modes;
  std::vector<double> energy, temperature;  ///< of each frame, per disk

 private:
  void add_velocities(const State& state, double Vec2::*component);
  void add_profiles(const State& state);
  void add_spectrum(const State& state);
  void add_modes(const State& state);

  Scene scene_;
  int bins_, modes_;
};

/// Bytes of a frame on a page, as base64.
double bytes_per_frame(const Scene& scene, int bins);

}  // namespace gpf
