// Enskog's equation by Monte Carlo: particles that collide with whoever is a diameter away, by chance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/methods/contact_watcher.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// How fine the simulation is.
struct MonteCarloSetting {
  int cells = 40;                ///< across the channel: the centres' room is divided evenly
  int particles_per_cell = 200;  ///< simulated, on average; each stands for (N/L)/(all of them) disks per length
  double step = 0.1;             ///< at most, in mean free times of the present
  int cells_along = 1;           ///< along the channel, over its period L; 1: uniform along it, no x
};

/// What collisions, walls and gravity have done since the start, per length of channel. Impulses to a wall are positive
/// outward and along +x.
struct MonteCarloSums {
  std::uint64_t collisions = 0;  ///< of simulated pairs
  double pair_loss = 0, gravity_work = 0;
  std::array<double, 2> wall_loss{}, wall_normal{}, wall_tangential{};
};

/// Montanero & Santos, Phys. Rev. E 54, 438 (1996), for inelastic disks in a channel (or a periodic gas): free flight
/// under gravity with the scene's walls, then collisions of each particle i, with a direction s at random, and a
/// particle j that is at random in the cell at r_i + d s, at the rate pi d chi n (g.s) where
/// g.s = (c_i - c_j).s > 0, chi Henderson's contact value for the part of the slab y +- d/2 about the point half way
/// that disks cover. Half a flight before the collisions of a step and half after them: seen between steps, the split
/// is of second order. Momentum is conserved by every collision. No correlations of velocities, no layers, no crystal:
/// the theory's assumptions are the method's limits.
///
/// With one cell along the channel the flow is uniform along x, no particle has an x, and coverages are averaged over
/// the last 20 mean free times. With more, particles move along x too, with period L. Then the coverage is that of the
/// present, since waves that the flow carries past would be smeared by an average over time; instead it is averaged
/// along x over +- 3 d, with weights that fall linearly, so that cells may be shorter than a diameter. Few particles
/// still make the rate of collisions too large, since chi is largest when the partners are many: with 20 in a cell at
/// nu = .5 by .5 % in cells of a diameter, by 9 % in cells that are three long. A partner is anywhere in its cell, so
/// long cells carry momentum too far and damp waves: at nu .31, e_n .85, beta_w .6, W/d 31, L/W 4 a slug that the start
/// has grows slowly in cells of a diameter and only keeps its strength in cells two long (one run of each).
class EnskogMonteCarlo {
 public:
  /// At rest on average, at random places. Throws InputError for less than 4 cells across, 1 along or 10 particles in
  /// each, for more than 2^31 - 1 particles or a step that is not in [1e-4, 1/2]; PhysicsError as advance().
  EnskogMonteCarlo(const Scene& scene, const MonteCarloSetting& setting);
  /// Begins with a state of as many particles as the setting has; its x count with more than one cell along only.
  /// Throws InputError besides when the number is another one or a particle is out of the channel.
  EnskogMonteCarlo(const Scene& scene, const MonteCarloSetting& setting, const State& start);

  [[nodiscard]] double time() const { return time_; }
  /// Moves on to `until`. Throws PhysicsError when such a slab is denser than .7, averaged over the last 20 mean free
  /// times: there disks freeze and the contact value is no longer theirs. With more than one cell along: when, averaged
  /// so, more than 1 % of the particles are in such slabs, since now and then one is by chance.
  void advance(double until);
  /// Shows every collision from now on, as one of the simulated particles, at time() before the steps that advance()
  /// takes together; not owned, must outlive this or be replaced. Null: nobody.
  void watch(ContactWatcher* watcher) { watcher_ = watcher; }
  /// Lab frame at time(), of the simulated particles; with one cell along all x are 0.
  [[nodiscard]] State state() const;

  [[nodiscard]] const MonteCarloSums& sums() const { return sums_; }
  /// Kinetic energy per length.
  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] std::size_t particles() const { return position_.size(); }
  [[nodiscard]] const std::vector<Vec2>& velocities() const { return velocity_; }

 private:
  [[nodiscard]] double rate() const;
  void take_steps(int steps);
  void fly(double time);
  void bounce(std::size_t i, double time);
  void go_along(std::size_t i, double distance);
  void sort_into_cells();
  void average_coverage();
  void refuse_frozen();
  void collide();
  [[nodiscard]] std::vector<double> crowds() const;
  [[nodiscard]] int row_of(double y) const;
  [[nodiscard]] std::size_t cell_of(Vec2 r) const;
  [[nodiscard]] std::size_t cell_at(int row, int column) const;

  Scene scene_;
  bool channel_;
  double diameter_, bottom_, room_, length_, setting_step_, step_, weight_;
  double memory_, renewal_;  // part that each step has in the averages over time; in those of fraction_
  double time_ = 0;
  int cells_, along_;  // rows, and columns of cells; cells of a column follow one another
  std::uint64_t steps_ = 0;
  double fastest_ = 0;             // speed of approach for which candidates are drawn
  double missed_ = 0, taken_ = 0;  // collisions too fast for it, and all, of the last hundred steps
  std::vector<Vec2> position_, velocity_;
  std::vector<std::uint32_t> order_, first_;  // particles by cell, and where each cell begins
  std::vector<double> fraction_;  // of centres, as area fraction, by cell; of a uniform flow averaged over time
  std::vector<double> kernel_, kernel_along_, coverage_;  // weights of cells k apart; fraction_ averaged with them
  double frozen_ = 0;  // part of the particles where it is frozen, averaged over time
  MonteCarloSums sums_;
  ContactWatcher* watcher_ = nullptr;
};

}  // namespace gpf
