// The functions that turn records into evidence: one for each way of testing a claim.
#pragma once

#include "verify/evidence.hpp"

namespace gpf {

// Chapter 2: the code itself.
Evidence estimate_eos_global(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_eos_virial(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_two_codes(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_steady(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_overhead(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_cost(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_energy(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_tc(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_lattices(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 3: fields and velocity distributions.
Evidence estimate_smooth_fields(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kurtosis(const Claim& claim, Tier tier, const SceneRecords& records);

// Chapter 4: Knudsen number, slip, flow rate and temperature at the walls.
Evidence estimate_kn_dilute(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kn_restitution(const Claim& claim, Tier tier, const SceneRecords& records);
Evidence estimate_kn_wall(const Claim& claim, Tier tier, const SceneRecords& records);
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

}  // namespace gpf
