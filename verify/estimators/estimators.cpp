#include "verify/estimators/estimators.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

constexpr auto estimators = std::to_array<std::pair<std::string_view, Estimator>>(
    {{"quantities", estimate_quantities},
     {"eos_global", estimate_eos_global},
     {"eos_virial", estimate_eos_virial},
     {"two_codes", estimate_two_codes},
     {"steady", estimate_steady},
     {"overhead", estimate_overhead},
     {"cost", estimate_cost},
     {"energy", estimate_energy},
     {"cooling", estimate_cooling},
     {"wall_losses", estimate_wall_losses},
     {"bin_temperature", estimate_bin_temperature},
     {"tc", estimate_tc},
     {"lattices", estimate_lattices},
     {"limits_collapse", estimate_limits_collapse},
     {"limits_tc", estimate_limits_tc},
     {"limits_roundoff", estimate_limits_roundoff},
     {"limits_engine", estimate_limits_engine},
     {"smooth_fields", estimate_smooth_fields},
     {"kurtosis", estimate_kurtosis},
     {"kurtosis_y", estimate_kurtosis_y},
     {"rough_centre", estimate_rough_centre},
     {"rough_beta", estimate_rough_beta},
     {"moderate_asymmetry", estimate_moderate_asymmetry},
     {"shear_asymmetry", estimate_shear_asymmetry},
     {"wall_gaussian", estimate_wall_gaussian},
     {"skewness_elastic", estimate_skewness_elastic},
     {"skewness_dissipation", estimate_skewness_dissipation},
     {"skewness_density", estimate_skewness_density},
     {"plug_forms", estimate_plug_forms},
     {"plug_density", estimate_plug_density},
     {"shear_layer", estimate_shear_layer},
     {"structures", estimate_structures},
     {"structure_profiles", estimate_structure_profiles},
     {"structures_y", estimate_structures_y},
     {"plug_tails", estimate_plug_tails},
     {"dense_tails", estimate_dense_tails},
     {"same_distributions", estimate_same_distributions},
     {"rough_wall_peak", estimate_rough_wall_peak},
     {"hump", estimate_hump},
     {"cx_wall", estimate_cx_wall},
     {"kn_dilute", estimate_kn_dilute},
     {"kn_restitution", estimate_kn_restitution},
     {"kn_wall", estimate_kn_wall},
     {"kn_paths", estimate_kn_paths},
     {"kn_density", estimate_kn_density},
     {"slip_restitution", estimate_slip_restitution},
     {"slip_wall", estimate_slip_wall},
     {"slip_density", estimate_slip_density},
     {"slip_knudsen", estimate_slip_knudsen},
     {"gradient_density", estimate_gradient_density},
     {"gradient_knudsen", estimate_gradient_knudsen},
     {"flow_knudsen", estimate_flow_knudsen},
     {"temp_density", estimate_temp_density},
     {"temp_restitution", estimate_temp_restitution},
     {"temp_wall", estimate_temp_wall},
     {"temp_knudsen", estimate_temp_knudsen},
     {"momentum_balance", estimate_momentum_balance},
     {"energy_balance", estimate_energy_balance},
     {"liquid_order", estimate_liquid_order},
     {"plug_order", estimate_plug_order},
     {"dense_order", estimate_dense_order},
     {"elastic_correlations", estimate_elastic_correlations},
     {"plug_correlations", estimate_plug_correlations},
     {"dense_correlations", estimate_dense_correlations},
     {"cross_correlations", estimate_cross_correlations},
     {"vortex", estimate_vortex},
     {"autocorrelation", estimate_autocorrelation},
     {"stress_theory", estimate_stress_theory},
     {"stress_enskog", estimate_stress_enskog},
     {"stress_size", estimate_stress_size},
     {"stress_misfit", estimate_stress_misfit},
     {"stress_divergence", estimate_stress_divergence},
     {"n1_elastic", estimate_n1_elastic},
     {"n1_dissipation", estimate_n1_dissipation},
     {"n1_reversal", estimate_n1_reversal},
     {"n1_dilute", estimate_n1_dilute},
     {"n1_critical", estimate_n1_critical},
     {"n1_kinetic", estimate_n1_kinetic},
     {"n1_collisional", estimate_n1_collisional},
     {"n1_phase", estimate_n1_phase},
     {"structure_classes", estimate_structure_classes},
     {"density_waves", estimate_density_waves},
     {"density_peaks", estimate_density_peaks},
     {"phase_diagram", estimate_phase_diagram},
     {"picture_labels", estimate_picture_labels},
     {"limits_hydrodynamics", estimate_limits_hydrodynamics},
     {"limits_monte_carlo", estimate_limits_monte_carlo},
     {"monte_carlo_dilute", estimate_monte_carlo_dilute},
     {"limits_soft_stiffness", estimate_limits_soft_stiffness},
     {"limits_soft_dissipation", estimate_limits_soft_dissipation},
     {"limits_soft_step", estimate_limits_soft_step},
     {"limits_advice", estimate_limits_advice}});

}  // namespace

Estimator estimator_named(std::string_view name) {
  const auto found = std::find_if(estimators.begin(), estimators.end(), [&](const auto& e) { return e.first == name; });
  if (found != estimators.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [known, function] : estimators) names.push_back(known);
  throw InputError(fmt::format("unknown estimator '{}'", name), fmt::format("known are {}", fmt::join(names, ", ")),
                   "correct the claim file's key estimator");
}

}  // namespace gpf
