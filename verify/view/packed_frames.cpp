#include "verify/view/packed_frames.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "gpf/measure/bins.hpp"
#include "gpf/measure/density_modes.hpp"
#include "gpf/measure/density_spectrum.hpp"
#include "gpf/measure/history.hpp"

namespace gpf {
namespace {

constexpr int most_cells = 512;  // along and across, of the density's mesh

void append(std::string& bytes, std::uint32_t value, int size) {
  for (int k = 0; k < size; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
}

void append_float(std::string& bytes, double value) {
  append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}

/// Which of `steps` equal parts of [0, 1] holds the value; what lies outside belongs to the outermost.
std::uint32_t part_of(double value, int steps) {
  return static_cast<std::uint32_t>(std::clamp(std::floor(value * steps), 0.0, steps - 1.0));
}

}  // namespace

void PackedFrames::add(const State& state) {
  for (const Vec2 r : state.position) append(positions, part_of(r.x / scene_.length(), 1 << 16), 2);
  for (const Vec2 r : state.position) append(positions, part_of(r.y, 1 << 16), 2);
  add_velocities(state, &Vec2::x);
  add_velocities(state, &Vec2::y);
  add_profiles(state);
  add_spectrum(state);
  if (modes_ > 0) add_modes(state);
  const Moment moment = moment_of(state, bins_);
  energy.push_back(moment.energy);
  temperature.push_back(moment.temperature);
}

void PackedFrames::add_velocities(const State& state, double Vec2::*component) {
  const auto [least, greatest] = std::minmax_element(state.velocity.begin(), state.velocity.end(),
                                                     [=](Vec2 a, Vec2 b) { return a.*component < b.*component; });
  const double low = (*least).*component, span = (*greatest).*component - low;
  for (const Vec2 v : state.velocity)
    velocities += static_cast<char>(span > 0 ? std::lround((v.*component - low) / span * 255) : 0);
  append_float(velocity_ranges, low);
  append_float(velocity_ranges, low + span);
}

void PackedFrames::add_profiles(const State& state) {
  struct Sums {
    double number = 0, velocity = 0, square_x = 0, square_y = 0;
  };
  const Bins bins(bins_);
  std::vector<Sums> sums(static_cast<std::size_t>(bins_));
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const Vec2 v = state.velocity[i];
    Sums& s = sums[static_cast<std::size_t>(bins.at(state.position[i].y))];
    s.number += 1, s.velocity += v.x, s.square_x += square(v.x), s.square_y += square(v.y);
  }
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const Sums& s : sums) append_float(profiles, s.number > 0 ? s.velocity / s.number : nothing);
  for (const Sums& s : sums)
    append_float(profiles,
                 s.number > 0 ? 0.5 * ((s.square_x + s.square_y) / s.number - square(s.velocity / s.number)) : nothing);
  const double share = std::numbers::pi / 4 * square(scene_.diameter()) / (scene_.length() * bins.width());
  for (const Sums& s : sums) append_float(profiles, share * s.number);
}

void PackedFrames::add_spectrum(const State& state) {
  // Cells of about a diameter; finer ones add nothing to wavenumbers as low as these.
  const auto cells = [](double diameters) { return std::clamp(static_cast<int>(diameters), 4 * most_kx, most_cells); };
  const DensitySpectrum spectrum(density_field(
      scene_, state, cells(scene_.length_over_width * scene_.width_over_diameter), cells(scene_.width_over_diameter)));
  const double noise = noise_of_spectrum(scene_);
  for (int kx = 0; kx <= most_kx; ++kx)
    for (int ky = -most_ky; ky <= most_ky; ++ky) {
      const double level = std::log10(spectrum.power(kx, ky) / noise) / spectrum_decades;
      spectra += static_cast<char>(part_of(std::isnan(level) ? 0 : level, 256));
    }
}

void PackedFrames::add_modes(const State& state) {
  const DensityModes modes = gpf::density_modes(state, scene_.length(), modes_);
  for (std::size_t shape = 0; shape < mode_shapes.size(); ++shape)
    for (const double power : modes.power[shape]) append_float(density_modes, power / modes.noise[shape]);
}

double bytes_per_frame(const Scene& scene, int bins) {
  return 4.0 / 3 *
         (6.0 * scene.particles + 12.0 * bins + (PackedFrames::most_kx + 1) * (2 * PackedFrames::most_ky + 1));
}

}  // namespace gpf
