// What the colour of a disk shows.
#pragma once

#include <vector>

#include "gpf/scene/state.hpp"

namespace gpf {

enum class Colouring {
  speed,        ///< |v|
  fluctuation,  ///< distance of the velocity from the mean of its bin
  one           ///< nothing
};

/// The number that the colour shows, for each disk; zeros for Colouring::one.
std::vector<double> shown_values(const State& state, Colouring colouring, int bins);

}  // namespace gpf
