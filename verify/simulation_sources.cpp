#include "verify/simulation_sources.hpp"

#include "gpf_judging_sources.hpp"  // generated at each build by simulation_sources.cmake
#include "gpf_simulation_sources.hpp"

namespace gpf {

std::uint64_t simulation_sources() { return simulation_sources_hash; }
std::uint64_t judging_sources() { return judging_sources_hash; }

}  // namespace gpf
