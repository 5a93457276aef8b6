// Enskog's equation by Monte Carlo: particles that collide with whoever is a diameter away, by chance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// How fine the simulation is.
struct MonteCarloSetting {
  int cells = 40;                ///< across the channel: the centres' room is divided evenly
  int particles_per_cell = 200;  ///< simulated, on average; each stands for (N/L)/(all of them) disks per length
  double step = 0.1;             ///< in mean free times of the start
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
/// where g.s = (c_i - c_j).s > 0, chi Henderson's contact value half way. Momentum is conserved by every collision. No
/// correlations of velocities, no layers, no crystal: the theory's assumptions are the method's limits.
class EnskogMonteCarlo {
 public:
  /// Throws InputError for less than 4 cells, 10 particles in each or a step that is not in (0, 1/2];
  /// PhysicsError as advance().
  EnskogMonteCarlo(const Scene& scene, const MonteCarloSetting& setting);

  [[nodiscard]] double time() const { return static_cast<double>(steps_) * step_; }
  /// Moves on to the step nearest to `until`. Throws PhysicsError when a cell is denser than .7, averaged over the last
  /// 20 mean free times of the start: there disks freeze and the contact value is no longer theirs.
  void advance(double until);
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
  void fly();
  void bounce(std::size_t i, double time);
  void sort_into_cells();
  void collide();
  [[nodiscard]] int cell_of(double y) const;

  Scene scene_;
  bool channel_;
  double diameter_, bottom_, room_, step_, weight_, memory_;
  int cells_;
  std::uint64_t steps_ = 0;
  double fastest_ = 0;  // bound of the rate of a candidate; raised when one exceeds it, which is then missed once
  std::vector<double> y_;
  std::vector<Vec2> velocity_;
  std::vector<std::uint32_t> order_, first_;  // particles by cell, and where each cell begins
  std::vector<double> fraction_;              // area fraction of each cell, averaged over the last mean free times
  MonteCarloSums sums_;
  double samples_ = 0;
  std::vector<double> count_, sum_x_, sum_y_, squares_;  // by cell
};

}  // namespace gpf
