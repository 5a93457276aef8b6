// What a contact does to velocities: smooth inelastic disks and flat walls, both with the TC model.
#pragma once

#include <array>

#include "gpf/base/vec2.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// TC model (Luding & McNamara, Granular Matter 1, 113 (1998)): a contact dissipates only when more than tc_time has
/// passed since the last contact of either partner, else its normal restitution is one.
class ContactMemory {
 public:
  explicit ContactMemory(double tc_time) : tc_time_(tc_time > 0 ? tc_time : -1) {}  // off: contacts at one time too
  [[nodiscard]] double restitution(double e, double time_since_last_contact) const {
    return time_since_last_contact > tc_time_ ? e : 1;
  }

 private:
  double tc_time_;
};

/// Outcome of a pair contact: the impulse that disk 2 receives from disk 1 (disk 1 the opposite), along the normal.
struct PairOutcome {
  Vec2 impulse;        ///< m (1 + e)/2 (u_12.n) n (eq. 2.5), n from 1 to 2
  double energy_loss;  ///< m (1 - e^2)/4 (u_12.n)^2
};

/// Smooth inelastic disks of unit mass (eqs. 2.3-2.5).
class SmoothDisks {
 public:
  explicit SmoothDisks(const Scene& scene) : restitution_(scene.normal_restitution), memory_(scene.tc_time) {}

  /// r_12 from disk 1 to disk 2 at contact, u_12 = u_1 - u_2 before it.
  /// The normal is taken as r_12/|r_12|, not r_12/d, so that e = 1 conserves energy to round-off.
  PairOutcome operator()(Vec2 r_12, Vec2 u_12, double time_since_last_contact) const {
    const double e = memory_.restitution(restitution_, time_since_last_contact);
    const double approach = dot(u_12, r_12), r2 = dot(r_12, r_12);
    return {(0.5 * (1 + e) * approach / r2) * r_12, 0.25 * (1 - e * e) * approach * approach / r2};
  }

 private:
  double restitution_;
  ContactMemory memory_;
};

/// Flat walls: u_x -> beta_w u_x, u_y -> -e_w u_y (eq. 2.9), velocities in the frame of the wall.
class FlatWalls {
 public:
  explicit FlatWalls(const Scene& scene)
      : normal_(scene.wall_normal_restitution),
        tangential_(scene.wall_tangential_restitution),
        memory_(scene.tc_time) {}

  /// The velocity after the contact.
  Vec2 operator()(Vec2 velocity, Wall wall, double time_since_last_contact) const {
    const double e = memory_.restitution(normal_, time_since_last_contact);
    return {tangential_[static_cast<std::size_t>(wall)] * velocity.x, -e * velocity.y};
  }

 private:
  double normal_;
  std::array<double, 2> tangential_;
  ContactMemory memory_;
};

/// The physics of a scene: one rule for pairs, one for walls.
struct GranularPhysics {
  explicit GranularPhysics(const Scene& scene) : pair(scene), wall(scene) {}
  SmoothDisks pair;
  FlatWalls wall;
};

}  // namespace gpf
