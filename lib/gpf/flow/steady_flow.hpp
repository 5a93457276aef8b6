// The steady flow of a scene by any method: the same quantities from all of them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/flow/method_setting.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

inline constexpr std::size_t quantities_of_a_flow = 16, profiles_of_a_flow = 8;

struct SteadyFlow {
  std::vector<Quantity> quantities;
  double cpu_seconds = 0;
  std::vector<std::string> warnings{};  ///< what lies beyond the method's range: see range.hpp
};

/// Runs `setting` on a scene for run.start_up and then measures for run.duration, sampling every run.sample_interval
/// (hydrodynamics is steady at once). Of the quantities of derive_quantities() those that mean the same for every
/// method: per bin (run.bins) area_fraction, mean_velocity, granular_temperature, pressure_xx, _yy, _xy, kurtosis_x and
/// _y; one value: mean_flow, centre_velocity, slip_velocity, wall_temperature, wall_pressure_lower, _upper,
/// wall_shear_lower, _upper. Not known to a method: NaN (hydrodynamics: normal stresses are equal, kurtoses are not
/// known).
///
/// `start`: a state to begin with instead of start_state(scene), for the methods that have disks.
/// Throws InputError when the run has no duration or sample interval (hydrodynamics needs none); what the methods
/// throw.
SteadyFlow steady_flow(const Scene& scene, const Run& run, const MethodSetting& setting, const State* start = nullptr);

/// The quantity of that name. Throws InputError.
const std::vector<double>& values_of(const std::vector<Quantity>& quantities, std::string_view name);

}  // namespace gpf
