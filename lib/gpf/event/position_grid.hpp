// Fixed-point positions: every coordinate is a multiple of one quantum.
#pragma once

#include <algorithm>
#include <cmath>

namespace gpf {

/// Coordinates are kept on a grid of spacing q = 2^-52 times the power of two at or above the longest side. Differences
/// of coordinates and shifts by a period are then exact (up to twice the longest side), so that the image in which a
/// pair is looked at, the size of the cells and a reflection of the channel cannot change a bit of a trajectory.
class PositionGrid {
 public:
  PositionGrid(double length, double width) {
    const double side = std::max(length, width);
    const int exponent = std::ilogb(side);
    const int above = std::ldexp(1.0, exponent) == side ? exponent : exponent + 1;
    quantum_ = std::ldexp(1.0, above - 52);
    inverse_ = std::ldexp(1.0, 52 - above);
  }

  /// Nearest multiple of the quantum, halves to even: symmetric under a change of sign.
  [[nodiscard]] double round(double a) const { return std::nearbyint(a * inverse_) * quantum_; }
  [[nodiscard]] double quantum() const { return quantum_; }

 private:
  double quantum_, inverse_;
};

}  // namespace gpf
