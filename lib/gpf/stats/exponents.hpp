// Exponents of a possible power law, replica by replica, over several fit windows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gpf {

/// A range of the points and the exponent there, mean over the replicas.
struct FitWindow {
  double lowest_x = 0, highest_x = 0;
  double exponent = 0;
};

/// Slopes of ln y against ln x; vectors have one value per replica. Every point has the same weight, so that the
/// exponent of a curve which is no power law does not depend on how well each of its points is known.
struct Exponents {
  std::vector<double> exponent;           ///< all points
  std::vector<double> low_end, high_end;  ///< the third of the points with the smallest and with the largest x
  std::vector<FitWindow> windows;         ///< all points; without the quarter of largest x; without that of smallest x

  [[nodiscard]] double half_spread() const;        ///< of the windows' exponents, (largest - smallest)/2
  [[nodiscard]] std::vector<double> bend() const;  ///< high_end - low_end: zero for a power law
  [[nodiscard]] double lowest_x() const { return windows.front().lowest_x; }
  [[nodiscard]] double highest_x() const { return windows.front().highest_x; }
};

/// Difference of the slopes at the two ends (the middles of whose thirds are 2/3 of the range apart) of a curve that
/// bends evenly and departs by the factor 1 +- `departure` from its best straight line in log-log over
/// highest_x/lowest_x. A parabola in ln x whose slope changes by b over the range L departs by +-b L/16.
double bend_of_departure(double departure, double lowest_x, double highest_x);

/// x[k][r], y[k][r]: point k in replica r, in any order of the points; they are sorted by the mean of x.
/// @throws InputError unless there are at least four points, all with equally many values (at least one), all finite
/// and above 0.
Exponents fit_exponents(std::span<const std::vector<double>> x, std::span<const std::vector<double>> y);

}  // namespace gpf
