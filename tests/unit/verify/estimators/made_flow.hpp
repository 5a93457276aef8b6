// Records of a channel whose profiles and velocity moments a test sets bin by bin.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "unit/verify/estimators/made_record.hpp"

namespace gpf::test {

/// A bin: disks, mean velocity, and variances, skewness and kurtosis of both components.
struct MadeBin {
  double disks = 30, mean = 2, variance_x = 0.5, variance_y = 0.7;
  double skewness_x = 0, kurtosis_x = 3, skewness_y = 0, kurtosis_y = 3;
};

/// A scene file like channel_text, with six bins, of a flow between walls of equal roughness.
inline std::string flow_text(double area_fraction, double restitution, double roughness) {
  return "[scene]\ngeometry = \"channel\"\nparticles = 180\nwidth_over_diameter = 12\narea_fraction = " +
         std::to_string(area_fraction) + "\nnormal_restitution = " + std::to_string(restitution) +
         "\nwall_tangential_restitution = " + std::to_string(roughness) +
         "\n[run]\nstart_up = 2\nduration = 8\nbins = 6\n";
}

/// The same moments about either mean. `bin(b)` for b = 0 ... 5.
inline Record made_flow(const std::string& text, const std::function<MadeBin(int)>& bin) {
  return made_record(text, [&](const SetTally& set) {
    for (int b = 0; b < 6; ++b) {
      const MadeBin m = bin(b);
      const double n = m.disks, u = m.mean, v = m.variance_x, w = m.variance_y;
      const double x3 = m.skewness_x * std::pow(v, 1.5), x4 = m.kurtosis_x * v * v;
      set(Tally::count, b, n);
      set(Tally::freedom, b, n - 1);
      set(Tally::ux2, b, n * v);
      set(Tally::ux3, b, n * x3);
      set(Tally::ux4, b, n * x4);
      set(Tally::cx, b, n * u);
      set(Tally::cx2, b, n * (u * u + v));
      set(Tally::cx3, b, n * (u * u * u + 3 * u * v + x3));
      set(Tally::cx4, b, n * (u * u * u * u + 6 * u * u * v + 4 * u * x3 + x4));
      set(Tally::cy2, b, n * w);
      set(Tally::cy3, b, n * m.skewness_y * std::pow(w, 1.5));
      set(Tally::cy4, b, n * m.kurtosis_y * w * w);
    }
  });
}

/// Bins from the wall: 0 for bins 1 and 6, 2 for 3 and 4.
inline int from_wall(int b) { return b < 3 ? b : 5 - b; }
/// +1 on the lower side, -1 on the upper: the parity of u_y.
inline double side(int b) { return b < 3 ? 1 : -1; }

}  // namespace gpf::test
