// A method's profiles against the replicas of the engine's.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/flow/steady_flow.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {

struct ComparedProfile {
  std::string_view quantity, title;
};
/// What decides whether a method holds in a scene.
inline constexpr std::array<ComparedProfile, 3> compared_profiles{
    {{"mean_velocity", "U"}, {"granular_temperature", "T"}, {"area_fraction", "nu"}}};

/// Root mean square over the bins of method - engine, over that of the engine: one value per replica of the scene. The
/// engine's own noise is in it, so that it is never too small. methods: one flow for all replicas, or one for each.
std::vector<double> profile_misfits(const SceneValues& scene, std::span<const SteadyFlow> methods,
                                    std::string_view quantity);

/// The largest of the three profiles' misfits, replica by replica.
std::vector<double> largest_misfits(const SceneValues& scene, std::span<const SteadyFlow> methods);

/// A scan of scenes, each within the range of a method or beyond it.
struct RangeScan {
  double tolerance;
  Series within{.label = "within the range"}, beyond{.label = "beyond it"};

  /// Adds the checks and the point of a scene at abscissa x: all three profiles within the tolerance where there are no
  /// `warnings`, the largest misfit outside it where there are.
  void add(const SceneValues& scene, std::span<const SteadyFlow> methods, const std::vector<std::string>& warnings,
           double x, Evidence& evidence);
  /// Those of the two series that have points.
  void draw(Plot& plot);
};

/// The run of a scene's records, for a method that is to be measured for `part` of its time.
Run part_of(const Run& run, double part);

}  // namespace gpf
