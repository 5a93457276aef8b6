// How far a method is from a reference, split into what more runs would not cure and what they would.
#pragma once

#include <vector>

namespace gpf {

/// Sizes over the bins (one for a number), as root mean squares, relative to that of the reference; `absolute`
/// observables, which may vanish, are not divided.
struct Misfit {
  double bias = 0;        ///< of the mean over replicas, its expected noise taken off; 0 where that is all there is
  double resolution = 0;  ///< standard error of the difference: a bias below it is not seen
  double noise = 0;       ///< standard deviation of a single run

  /// The bias may be as large.
  [[nodiscard]] double bias_at_most() const;
  /// Error to expect of a single run.
  [[nodiscard]] double total() const;
};

/// runs, reference: one vector for each replica, one value a bin; at least one of each. A single one has no
/// noise: of a method without chance, or where the plain difference of two runs is wanted. Bins where anything is not
/// finite are left out; none left: all NaN.
Misfit misfit_of(const std::vector<std::vector<double>>& runs, const std::vector<std::vector<double>>& reference,
                 bool absolute);

}  // namespace gpf
