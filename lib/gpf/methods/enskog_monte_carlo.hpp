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
};

/// Time averages in the cells.
struct MonteCarloProfile {
  std::vector<double> y;  ///< middles of the cells
  std::vector<double> mean_velocity, granular_temperature, area_fraction;
};

/// What collisions, walls and gravity have done since the start, per length of channel. Impulses to a wall are positive
/// outward and along +x.
struct MonteCarloSums {
  std::uint64_t collisions = 0;  ///< of simulated pairs
  double pair_loss = 0, gravity_work = 0;
  std::array<double, 2> wall_loss{}, wall_normal{}, wall_tangential{};
};

/// Montanero & Santos, Phys. Rev. E 54, 438 (1996), for inelastic disks in a channel (or a periodic gas) that is
/// uniform along x: free flight under gravity with the scene's walls, then collisions of each particle i, with a
/// direction s at random, and a particle j that is at random in the cell at y_i + d s_y, at the rate 2 pi d chi n (g.s)
/// where g.s = (c_i - c_j).s > 0, chi Henderson's contact value for the part of the
/// slab y +- d/2 about the point half way that disks cover. Half a flight before the collisions of a step
/// and half after them: seen between steps, the split is of second order. Momentum is conserved by every collision. No
/// correlations of velocities, no layers, no crystal: the theory's assumptions are the method's limits.
class EnskogMonteCarlo {
 public:
  /// Throws InputError for less than 4 cells, 10 particles in each or a step that is not in (0, 1/2];
  /// PhysicsError as advance().
  EnskogMonteCarlo(const Scene& scene, const MonteCarloSetting& setting);

  [[nodiscard]] double time() const { return time_; }
  /// Moves on to `until`. Throws PhysicsError when such a slab is denser than .7, averaged over the
  /// last 20 mean free times: there disks freeze and the contact value is no longer theirs.
  void advance(double until);
  /// Shows every collision from now on, as one of the simulated particles at x = 0, at a time within the step; not
  /// owned, must outlive this or be replaced. Null: nobody.
  void watch(ContactWatcher* watcher) { watcher_ = watcher; }
  /// Lab frame at time(); all x are 0.
  [[nodiscard]] State state() const;

  /// Adds the present state to the averages.
  void sample();

  /// NaN in cells where nothing has been sampled.
  [[nodiscard]] MonteCarloProfile profile() const;
  [[nodiscard]] const MonteCarloSums& sums() const { return sums_; }
  /// Kinetic energy per length.
  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] std::size_t particles() const { return y_.size(); }
  [[nodiscard]] const std::vector<Vec2>& velocities() const { return velocity_; }

 private:
  [[nodiscard]] double rate() const;
  void take_steps(int steps);
  void fly(double time);
  void bounce(std::size_t i, double time);
  void sort_into_cells();
  void average_coverage();
  void collide();
  [[nodiscard]] std::vector<double> crowds() const;
  [[nodiscard]] int cell_of(double y) const;

  Scene scene_;
  bool channel_;
  double diameter_, bottom_, room_, setting_step_, step_, weight_, memory_;
  double time_ = 0;
  int cells_;
  std::uint64_t steps_ = 0;
  double fastest_ = 0;             // speed of approach for which candidates are drawn
  double missed_ = 0, taken_ = 0;  // collisions too fast for it, and all, of the last hundred steps
  std::vector<double> y_;
  std::vector<Vec2> velocity_;
  std::vector<std::uint32_t> order_, first_;  // particles by cell, and where each cell begins
  std::vector<double> fraction_;  // of centres, as area fraction, by cell; averaged over the last mean free times
  std::vector<double> kernel_, coverage_;  // weights of cells k apart; fraction_ averaged with them
  MonteCarloSums sums_;
  ContactWatcher* watcher_ = nullptr;
  double samples_ = 0;
  std::vector<double> count_, sum_x_, sum_y_, squares_;  // by cell
};

}  // namespace gpf
