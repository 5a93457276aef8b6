// The density at which a normal stress difference at the centre of the channel changes sign.
#pragma once

#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "gpf/stats/crossing.hpp"
#include "verify/estimators/stress_values.hpp"

namespace gpf {

/// Mean area fraction of the channel, or area fraction of the centre pair of bins ("nu_bin").
enum class Density { mean, local };
std::vector<double> density_of(const SceneValues& scene, Density density);
std::string name_of(Density density);  ///< "nu", "nu_bin"

/// N_1, or its share of a part, in the centre pair of bins.
std::vector<double> centre_value(const SceneValues& scene, StressPart part, MeanFlow mean = MeanFlow::instantaneous);

/// Change of sign from plus to minus along a row, by straight lines between the last scene before it and the first
/// after it: the last such change of the means over replicas.
struct SignChange {
  const SceneValues *below = nullptr, *above = nullptr;  ///< null: there is none
  std::vector<double> densities;                         ///< one per replica, replica r of both scenes together
  Crossing crossing;                                     ///< of the line through both means, with Fieller's interval

  [[nodiscard]] bool found() const { return below != nullptr; }
};
SignChange sign_change(const SceneRow& row, StressPart part, Density density, MeanFlow mean = MeanFlow::instantaneous);

/// "nu 0.18 (0.16 to 0.20; between 0.15 and 0.3)", or that there is none.
std::string text_of(const SignChange& change, Density density);

/// The values of a row against a density, with error bars.
Series centre_series(const SceneRow& row, StressPart part, Density density, std::string label);

}  // namespace gpf
