// What a queue tells of its work to those who count it (claim algo.cost).
#pragma once

namespace gpf {

/// Counts nothing and costs nothing. Another meter's step() is called for each entry or day that a queue looks at.
struct NoMeter {
  static void step() {}
};

}  // namespace gpf
