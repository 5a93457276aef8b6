// P(u) of one bin from the histograms of a record: where it peaks, and whether it has one peak.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gpf/io/plot.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {

/// Counts in equal cells of a velocity in units of its standard deviation (see gpf/measure/distributions.hpp).
class VelocityHistogram {
 public:
  /// `centres` and `counts` have the same length; `smoothing` cells on each side are averaged for peak() and
  /// second_rise().
  VelocityHistogram(std::vector<double> centres, std::vector<double> counts, int smoothing = 2);

  [[nodiscard]] const std::vector<double>& centres() const { return centres_; }
  [[nodiscard]] const std::vector<double>& counts() const { return counts_; }
  /// Vertex of the parabola through the highest cell and its neighbours; NaN without counts.
  [[nodiscard]] double peak() const;
  /// Greatest rise of P on the way down from its peak, either side, over its maximum: 0 with a single peak, the depth
  /// of the valley before a second one. Noise adds about two standard errors of a smoothed cell.
  [[nodiscard]] double second_rise() const;

 private:
  [[nodiscard]] std::size_t highest() const;

  std::vector<double> centres_, counts_, smooth_;
};

/// The histogram `array` ("velocity/ux" or "velocity/uy") of `bin` and its mirror image together, one per replica; a
/// histogram of u_y is turned round in the mirror. Throws InputError when a record does not have it.
std::vector<VelocityHistogram> velocity_histograms(const SceneValues& scene, std::string_view array, int bin,
                                                   Parity parity = Parity::even);

/// All replicas together as P/max P, cells without counts left out.
Series histogram_series(const std::vector<VelocityHistogram>& histograms, std::string label);

}  // namespace gpf
