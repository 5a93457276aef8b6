// The few numbers of a run that show whether it is steady, block by block.
#pragma once

#include <string>
#include <vector>

#include "gpf/io/record.hpp"

namespace gpf {

/// One value per block of the record.
struct BlockedField {
  std::string name;
  std::vector<double> blocks;
};

/// Whether the scene can be steady: driven by gravity with a wall that takes up momentum (one |beta_w| < 1), or without
/// gravity and elastic. An inelastic gas without gravity cools, a channel without wall friction accelerates for ever.
bool has_steady_state(const Scene& scene);

/// Under gravity the mean flow, the kinetic energy and the granular temperature; without gravity, where energy and
/// momentum are constant, the virial per time and the collision rate. Empty when the scene has no steady state.
std::vector<BlockedField> main_fields(const Record& record);

}  // namespace gpf
