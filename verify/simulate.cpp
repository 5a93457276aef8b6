#include "verify/simulate.hpp"

#include "verify/simulation.hpp"

namespace gpf {

std::optional<Record> simulate(const SceneFile& file, const SimulationOptions& options) {
  return Simulation<>(file, options).run();
}

}  // namespace gpf
