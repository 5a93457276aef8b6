// Scenes that differ in one number: what is plotted against an area fraction, a restitution or a wall.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "verify/estimators/scene_values.hpp"

namespace gpf {

/// A number of a scene by which scenes are grouped or put in order.
using SceneNumber = double (*)(const Scene&);
double area_fraction(const Scene& scene);
double normal_restitution(const Scene& scene);
double wall_restitution(const Scene& scene);  ///< of the lower wall

/// The scenes of equal `group`, by that number, each group in order of `order`; those for which `keep` does not hold
/// are left out.
using Scans = std::map<double, std::vector<SceneValues>>;
using SceneFilter = bool (*)(const Scene&);
bool any_scene(const Scene& scene);
bool rough_walls(const Scene& scene);   ///< beta_w below one half, at the lower wall
bool smooth_walls(const Scene& scene);  ///< the others
Scans scans_by(SceneNumber group, SceneNumber order, const SceneRecords& records, SceneFilter keep);

/// The scene of a scan whose `number` is `value`, within round-off of a scene file; nullptr when there is none.
const SceneValues* find_scene(const std::vector<SceneValues>& scan, SceneNumber number, double value);

/// A quantity of each scene of a scan: [scene][replica].
std::vector<double> numbers_of(const std::vector<SceneValues>& scan, SceneNumber number);
std::vector<std::vector<double>> values_of(const std::vector<SceneValues>& scan, std::string_view quantity);

/// The Knudsen number of the thesis, mean over the replicas.
double mean_knudsen(const SceneValues& scene);
/// The scenes of a scan with lowest < Kn < highest, in the order of the scan.
std::vector<const SceneValues*> between_knudsen(const std::vector<SceneValues>& scan, double lowest, double highest);

/// f(a, b) replica by replica, as far as both go.
template <class F>
std::vector<double> combined(const std::vector<double>& a, const std::vector<double>& b, F&& f) {
  return per_replica(std::min(a.size(), b.size()), [&](std::size_t r) { return f(a[r], b[r]); });
}
std::vector<double> log_ratio(const std::vector<double>& a, const std::vector<double>& b);  ///< ln(a/b)

/// ln y where x = at, on the straight pieces in log-log through the points x[k], y[k] of a scan ([point][replica]), in
/// each replica; NaN where no piece reaches.
std::vector<double> log_interpolated(const std::vector<std::vector<double>>& x,
                                     const std::vector<std::vector<double>>& y, double at);

/// Appends two checks that a curve over a scan rises (falls) and falls (rises) again: its value at the interior point
/// with the largest (smallest) mean against those at the first and the last point.
enum class Extremum { maximum, minimum };
void add_extremum(Evidence& evidence, const std::string& label, const std::vector<double>& x,
                  const std::vector<std::vector<double>>& values, Extremum extremum);

/// "0.123 +- 0.004"
std::string with_error(const std::vector<double>& values);

/// Points of a quantity over a number of the scenes.
Series points_of(std::string label, const std::vector<SceneValues>& scan, SceneNumber x, std::string_view y);
/// Points of a quantity over the Knudsen number.
Series over_knudsen(std::string label, const std::vector<SceneValues>& scan, std::string_view quantity);

}  // namespace gpf
