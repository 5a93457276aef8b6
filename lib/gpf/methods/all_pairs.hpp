// The oracle: plain event-driven hard disks that examine every pair; no cells, no queue, no clock per disk.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "gpf/methods/contact_watcher.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// One executed contact. a is a disk; b is a disk with b > a, or one of the walls below.
struct AllPairsEvent {
  static constexpr std::int32_t lower_wall = -1, upper_wall = -2;
  double time = 0;
  std::int32_t a = 0, b = 0;
  friend bool operator==(const AllPairsEvent&, const AllPairsEvent&) = default;
};

/// What all contacts with one wall have done since the start.
struct AllPairsWall {
  std::int64_t contacts = 0;
  double loss = 0;                ///< kinetic energy lost, m (1 - beta^2) u_x^2/2 + m (1 - e_w^2) u_y^2/2
  double normal_impulse = 0;      ///< given to the wall, positive when it is pushed outwards
  double tangential_impulse = 0;  ///< given to the wall along +x (the drag of the flow on it)
};

/// What all contacts have done since the start.
struct AllPairsSums {
  std::int64_t pair_contacts = 0;
  double pair_loss = 0;  ///< kinetic energy lost in pairs, m (1 - e^2) (u12.n)^2/4 each
  double virial = 0;     ///< sum of r12 . J, r12 from disk 1 to 2, J the impulse given to 2: positive
  std::array<AllPairsWall, 2> wall;
};

/// Moves all disks of a scene from contact to contact as the code that the thesis compares with does (sec. 2.6; Allen &
/// Tildesley): every disk keeps the time left until its earliest contact, found by examining all others; the next
/// event is found by linear search; all disks then flow to it. O(N) per event. Units as in Scene.
///
/// Flow (eq. 2.8): x += u_x t + g t^2/2, u_x += g t, y += u_y t. Pairs: eqs. 2.3 to 2.6; walls: eq. 2.9, in the lab
/// frame. TC model: with tc_time > 0 a contact is elastic in its normal (e_n or e_w = 1; beta always acts) when either
/// partner's last contact, with a disk or a wall, was at most tc_time ago. Ties: the lowest disk goes first.
///
/// Real is float, double or long double: finer ones show how fast round-off grows in coarser ones.
template <class Real>
class AllPairs {
 public:
  /// `start`: lab frame; any x, and y between the walls (periodic scenes: any y).
  /// Throws InputError when `start` does not fit the scene or a period is not longer than two diameters (the nearest
  /// image must be unique); PhysicsError when disks overlap each other or a wall by more than round-off.
  AllPairs(const Scene& scene, const State& start);

  [[nodiscard]] double time() const { return static_cast<double>(clock_); }

  /// Executes the next contact. Throws PhysicsError when there is none to come, when disks overlap by more than
  /// round-off, and on inelastic collapse (one disk in ever more contacts while time stands still).
  AllPairsEvent step();

  /// Executes every contact up to and including time `until`, then flows to it. Throws as step() does (but for want of
  /// contacts), and InputError when `until` is past or not finite.
  void advance(double until);

  /// Shows every contact from now on; not owned, must outlive this or be replaced. Null: nobody.
  void watch(ContactWatcher* watcher) { watcher_ = watcher; }

  /// Turns all velocities round and forgets the last contacts, as if the film ran backwards.
  void reverse();

  /// Lab frame at time(); x in [0, L).
  [[nodiscard]] State state() const;
  [[nodiscard]] const AllPairsSums& sums() const { return sums_; }
  /// Kinetic energy.
  [[nodiscard]] double energy() const;
  /// Work done by gravity since the start: m g times the sum of the unwrapped displacements along x.
  [[nodiscard]] double gravity_work() const;

 private:
  struct Disk {
    Real x, y, ux, uy;
    Real start_x;  // unwrapped displacement = x + turns L - start_x
    std::int64_t turns;
    long double last_contact;   // time of it; minus infinity before the first
    std::int64_t contacts_now;  // since the clock last moved
  };
  struct Next {
    Real in;               // time left
    std::int32_t partner;  // a disk, a wall, or look_again
  };
  struct Offset {
    Real x, y;
  };
  struct Approach {
    Real ux, uy;        // of b past a
    Real square, gap;   // of the distance; what it has more than the square of a diameter
    Real rate;          // half the rate at which the square grows
    Real discriminant;  // negative when the disks do not meet
  };
  static constexpr std::int32_t look_again = -3;

  [[nodiscard]] Offset nearest_image(const Disk& a, const Disk& b) const;
  [[nodiscard]] Approach approach(const Disk& a, const Disk& b) const;
  [[nodiscard]] Next wall_contact(std::int32_t i) const;
  [[nodiscard]] Real pair_contact(std::int32_t i, std::int32_t j) const;
  [[nodiscard]] Next prediction(std::int32_t i) const;
  [[nodiscard]] bool recent(const Disk& a) const;
  std::optional<AllPairsEvent> execute_next(long double until);
  void predict_all();
  void flow(Real dt);
  void wrap(Disk& a) const;
  void collide_pair(Disk& a, Disk& b);
  void collide_wall(Disk& a, Wall wall);
  void stamp(Disk& a, bool elastic);

  [[nodiscard]] Disk& disk(std::int32_t i) { return disks_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::int32_t number(const Disk& a) const { return static_cast<std::int32_t>(&a - disks_.data()); }
  [[nodiscard]] const Disk& disk(std::int32_t i) const { return disks_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(disks_.size()); }

  Scene scene_;
  bool periodic_y_;
  Real diameter_, length_, gravity_, tolerance_, closest_square_;
  std::vector<Disk> disks_;
  std::vector<Next> next_;                        // of disk i; the partner's own entry may hold the same contact
  mutable std::vector<std::int32_t> candidates_;  // those that a prediction cannot rule out
  long double clock_ = 0;                         // only for reporting and the TC rule: no prediction depends on it
  AllPairsSums sums_;
  ContactWatcher* watcher_ = nullptr;
};

extern template class AllPairs<float>;
extern template class AllPairs<double>;
extern template class AllPairs<long double>;

}  // namespace gpf
