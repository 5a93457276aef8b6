// What is simulated (Scene) and for how long it is measured (Run): immutable values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace gpf {

enum class Geometry { channel, periodic };
/// What a run measures: profiles; distributions of velocities, free paths and contact angles besides; correlations
/// between disks and in time besides.
enum class Detail { profiles, distributions, correlations };
enum class Lattice { automatic, square, triangular };
enum Wall : int { lower = 0, upper = 1 };

/// Units: the channel's width W (periodic scenes: the period across, along y) and the mass of a disk are one.
/// x is streamwise and always periodic with period length(); y is wall-normal. In a channel the centres move in
/// [d/2, 1 - d/2]; gravity points along +x.
struct Scene {
  Geometry geometry = Geometry::channel;
  std::int32_t particles = 0;
  double width_over_diameter = 0;                           ///< W/d
  double length_over_width = 0;                             ///< L/W
  double normal_restitution = 1;                            ///< e_n, pairs (eq. 2.3)
  double wall_normal_restitution = 1;                       ///< e_w (eq. 2.9)
  std::array<double, 2> wall_tangential_restitution{1, 1};  ///< beta_w of the lower and the upper wall (eq. 2.9)
  double tc_time = 0;  ///< TC model: a contact sooner than this after either partner's last one is elastic; 0: off
  double gravity = 0;  ///< g, acceleration along +x
  Lattice lattice = Lattice::automatic;
  std::uint64_t seed = 1;

  [[nodiscard]] double diameter() const { return 1 / width_over_diameter; }
  [[nodiscard]] double length() const { return length_over_width; }
  /// nu = pi N d^2/(4 L W): eq. 2.7 as it must read (the printed form multiplies by L/W and W/d; errata).
  [[nodiscard]] double area_fraction() const;
  /// Scale of the start velocities: sqrt(g W), or 1 without gravity.
  [[nodiscard]] double velocity_scale() const;
  /// Enskog's collision rate per disk for a uniform elastic gas at T = velocity_scale()^2:
  /// omega = 2 sqrt(pi) n d g0 sqrt(T), g0 Henderson's contact value (eq. 4.11).
  [[nodiscard]] double reference_collision_rate() const;
};

/// How a scene is run and measured. Times are in the scene's unit: sqrt(W/g) for g = 1; sqrt(W/g)/2 for g = 4; without
/// gravity the time in which a disk at the start's thermal velocity crosses W. A run ends when all given targets are
/// met.
struct Run {
  double start_up = 0;                 ///< discarded before measurement begins
  double duration = 0;                 ///< least measured time (0: not set)
  double collisions_per_particle = 0;  ///< least number of pair collisions per disk, 2 N_c/N (0: not set)
  double sample_interval = 0;          ///< time between samples of the fields
  std::int32_t bins = 18;              ///< bins across the width
  Detail detail = Detail::profiles;
  std::int32_t density_modes = 0;   ///< streamwise wavenumbers k = 1, 2, ... whose density modes are measured; 0: none
  std::vector<double> snapshots{};  ///< ascending times; the state at the sample nearest to each is kept
};

}  // namespace gpf
