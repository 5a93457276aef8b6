// The functions that turn records into evidence: one for each way of testing a claim.
#pragma once

#include "verify/evidence.hpp"

namespace gpf {

// Any quantity that is measured, as the claim file says.
Evidence estimate_quantities(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 2: the code itself.
Evidence estimate_eos_global(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_eos_virial(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_two_codes(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_steady(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_overhead(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_cost(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_energy(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_cooling(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_wall_losses(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_bin_temperature(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_tc(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_lattices(const Claim& claim, Tier tier, const SceneRecords& records);

// Where the engine, and the models that it needs, come to their ends.
Evidence estimate_limits_collapse(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_tc(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_roundoff(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_engine(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 3: fields and velocity distributions.
Evidence estimate_smooth_fields(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kurtosis(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kurtosis_y(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_rough_centre(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_rough_beta(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_moderate_asymmetry(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_shear_asymmetry(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_wall_gaussian(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_skewness_elastic(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_skewness_dissipation(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_skewness_density(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_plug_forms(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_plug_density(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_shear_layer(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_structures(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_structure_profiles(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_structures_y(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 3: order and correlations.
Evidence estimate_liquid_order(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_plug_order(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_dense_order(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_elastic_correlations(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_plug_correlations(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_dense_correlations(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_cross_correlations(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_vortex(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_autocorrelation(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 4: stresses and the first normal stress difference.
Evidence estimate_stress_theory(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_stress_enskog(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_stress_size(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_stress_misfit(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_stress_divergence(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_elastic(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_dissipation(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_reversal(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_dilute(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_critical(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_kinetic(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_collisional(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_n1_phase(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 5: structures; tails of chapter 3.
Evidence estimate_structure_classes(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_density_waves(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_density_peaks(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_phase_diagram(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_picture_labels(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_plug_tails(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_dense_tails(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_same_distributions(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_rough_wall_peak(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_hump(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_cx_wall(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 4: Knudsen number, slip, flow rate and temperature at the walls.
Evidence estimate_kn_dilute(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kn_restitution(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kn_wall(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kn_paths(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kn_density(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_slip_restitution(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_slip_wall(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_slip_density(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_slip_knudsen(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_gradient_density(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_gradient_knudsen(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_flow_knudsen(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_temp_density(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_temp_restitution(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_temp_wall(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_temp_knudsen(const Claim& claim, Tier tier, const SceneRecords& records);

// Balances that hold in every steady channel.
Evidence estimate_momentum_balance(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_energy_balance(const Claim& claim, Tier tier, const SceneRecords& records);

// Where methods other than the engine end.
Evidence estimate_limits_hydrodynamics(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_monte_carlo(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_monte_carlo_dilute(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_soft_stiffness(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_soft_dissipation(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_soft_step(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_limits_advice(const Claim& claim, Tier tier, const SceneRecords& records);

}  // namespace gpf
