// Soft disks: the same scene with contacts that last a while, moved in time steps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "gpf/methods/contact_watcher.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// How soft the disks are and how fine the steps.
struct SoftContact {
  double duration = 0;         ///< of a pair contact, in the scene's unit of time
  int steps_per_contact = 50;  ///< the time step is duration/steps_per_contact
};

/// What all contacts and gravity have done since the start. Energies in m g W.
struct SoftSums {
  double pair_loss = 0;                     ///< in the dashpots of pairs
  double virial = 0;                        ///< integral of r_12 . F over time
  double gravity_work = 0;                  ///< m g times the displacements along x
  std::array<double, 2> wall_loss{};        ///< dashpots and tangential restitution
  std::array<double, 2> wall_normal{};      ///< impulse given to the wall, positive outward
  std::array<double, 2> wall_tangential{};  ///< impulse given to the wall along +x
};

/// Linear spring and dashpot (Cundall & Strack, Geotechnique 29, 47 (1979); Luding, Granular Matter 10, 235 (2008)),
/// without a cut-off of the attraction at the end of a contact, so that a lone contact has exactly the scene's
/// restitution and lasts exactly `duration`: with the reduced mass m, eta = -ln e/duration and omega = pi/duration the
/// spring is m (omega^2 + eta^2) and the dashpot 2 m eta. Walls are springs of the same duration, e_w and infinite
/// mass; beta_w is applied at once when a disk turns round. The TC model is not: contacts that last need none.
///
/// Velocity Verlet, with the velocity at the end of the step extrapolated for the dashpots; cells and a list of
/// neighbours with a skin. Second order in the step for e = 1; first order else, as a dashpot's force begins and ends
/// with a jump.
class SoftDisks {
 public:
  /// Throws InputError when the start does not fit the scene, a restitution is 0 (no linear dashpot has it), or the
  /// contact has no positive duration or less than 2 steps.
  SoftDisks(const Scene& scene, const SoftContact& contact, const State& start);

  [[nodiscard]] double time() const { return static_cast<double>(steps_) * step_; }
  [[nodiscard]] double step() const { return step_; }
  /// Moves on to the time step nearest to `until`. Throws PhysicsError when disks overlap by half a diameter or leave
  /// the channel: too soft, or steps too large.
  void advance(double until);

  /// Shows every step of every contact from now on; not owned, must outlive this or be replaced. Null: nobody.
  void watch(ContactWatcher* watcher) { watcher_ = watcher; }

  /// Lab frame at time(); x in [0, L).
  [[nodiscard]] State state() const;
  [[nodiscard]] double kinetic_energy() const;
  /// In the springs of pairs and walls.
  [[nodiscard]] double contact_energy() const { return contact_energy_; }
  [[nodiscard]] const SoftSums& sums() const { return sums_; }
  /// Of pairs, in diameters, since the start: how far this is from hard disks.
  [[nodiscard]] double deepest_overlap() const { return deepest_overlap_ / diameter_; }

 private:
  struct Spring {
    double stiffness, damping;
  };
  [[nodiscard]] static Spring spring_of(double restitution, double duration, double mass);
  void take_step();
  void compute_forces();
  void pair_forces();
  void wall_forces();
  void turn_at_walls();
  void build_neighbours();
  [[nodiscard]] bool neighbours_are_stale() const;
  [[nodiscard]] Vec2 nearest(Vec2 r) const;

  Scene scene_;
  bool channel_;
  double diameter_, length_, step_;
  Spring pair_, wall_;
  std::uint64_t steps_ = 0;
  std::vector<Vec2> position_, velocity_, expected_velocity_, force_;  // x unwrapped
  std::vector<Vec2> listed_at_;                                        // positions when the list was made
  std::vector<std::uint8_t> turned_;                                   // beta_w has been applied in this wall contact
  std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours_;
  double contact_energy_ = 0, deepest_overlap_ = 0;
  SoftSums sums_;
  ContactWatcher* watcher_ = nullptr;
};

}  // namespace gpf
