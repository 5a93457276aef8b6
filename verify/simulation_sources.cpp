#include "verify/simulation_sources.hpp"

#include "gpf_simulation_sources.hpp"  // generated at each build by simulation_sources.cmake

namespace gpf {

std::uint64_t simulation_sources() { return simulation_sources_hash; }

}  // namespace gpf
