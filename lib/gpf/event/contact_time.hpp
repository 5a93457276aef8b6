// When two disks in free flight touch (eq. 2.6).
#pragma once

#include <algorithm>
#include <cmath>

#include "gpf/event/disk.hpp"
#include "gpf/event/lane.hpp"

namespace gpf {

/// Two disks at the later of their times; r from a to b, u = u_b - u_a.
template <class Real>
struct Encounter {
  Real gap;           ///< r^2 - d^2
  Real approach;      ///< r.u, negative while they approach
  Real discriminant;  ///< u^2 d^2 - (r x u)^2, positive when they meet: this form stays accurate for far pairs

  /// Whether they will touch. A grazing pass (discriminant zero) is no contact.
  [[nodiscard]] auto meet() const { return (approach < 0) & (discriminant > 0); }
};

/// Finds the next contact of two disks. The answer is a function of the two states alone - not of the time at which
/// one asks, nor of who is named first - so trajectories do not depend on cells, queues or the order of work.
class ContactTime {
 public:
  explicit ContactTime(double diameter) : d2_(diameter * diameter) {}

  /// b (one disk, or a lane of them) is taken in the image displaced by (shift_x, shift_y). Where `a_is_latest` is
  /// promised (no b has a later time) its own flight, which has no length, is left out.
  template <bool a_is_latest = false, class Real>
  [[nodiscard]] Encounter<Real> encounter(const Flight& a, const FlightOf<Real>& b, auto shift_x, auto shift_y) const {
    Real rx = b.x - a.x + shift_x, ry = b.y - a.y + shift_y;
    if constexpr (a_is_latest) {
      const Real flight_b = a.time - b.time;
      rx += b.vx * flight_b;
      ry += b.vy * flight_b;
    } else {
      const Real flight_b = positive_part(a.time - b.time), flight_a = positive_part(b.time - a.time);
      rx += b.vx * flight_b - a.vx * flight_a;
      ry += b.vy * flight_b - a.vy * flight_a;
    }
    const Real ux = b.vx - a.vx, uy = b.vy - a.vy;
    const Real moment = rx * uy - ry * ux;
    return {rx * rx + ry * ry - d2_, rx * ux + ry * uy, (ux * ux + uy * uy) * d2_ - moment * moment};
  }

  /// When the disks of an encounter that meet touch. The root as gap/(sqrt(disc) - r.u), which stays accurate for near
  /// pairs; a pair inside each other touches at once.
  template <bool a_is_latest = false, class Real>
  [[nodiscard]] Real contact(const Encounter<Real>& e, double time_a, Real time_b) const {
    const Real flight = positive_part(e.gap / (square_root(e.discriminant) - e.approach));
    return (a_is_latest ? Real{} + time_a : later(time_a, time_b)) + flight;
  }

 private:
  double d2_;
};

}  // namespace gpf
