// The density at which a normal stress difference at the centre of the channel changes sign.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "gpf/stats/crossing.hpp"
#include "gpf/stats/estimate.hpp"
#include "verify/estimators/stress_values.hpp"

namespace gpf {

/// Mean area fraction of the channel, or area fraction of the centre pair of bins ("nu_bin").
enum class Density { mean, local };
std::vector<double> density_of(const SceneValues& scene, Density density);
std::string name_of(Density density);  ///< "nu", "nu_bin"

/// N_1, or its share of a part, in the centre pair of bins.
std::vector<double> centre_value(const SceneValues& scene, StressPart part, MeanFlow mean = MeanFlow::instantaneous);

/// Error rate at each end of Fieller's interval in a note, and of a sign that counts as certain.
inline constexpr double crossing_alpha = 0.01;

/// Zero of the line through the means over `replicas` replicas at two points, with Fieller's interval at crossing_alpha
/// per end. Throws InputError unless the errors are above 0, the means differ and replicas >= 2.
Crossing crossing_between(double x_below, Estimate below, double x_above, Estimate above, std::size_t replicas);

/// Change of sign from plus to minus along a row: between the last scene where the value is certainly positive before one
/// where it is certainly negative, and the first such one. On the straight line of least squares through these two and
/// the scenes between them, weighted by their errors; no densities where no line goes through them (chi2, to
/// crossing_alpha).
struct SignChange {
  const SceneValues *below = nullptr, *above = nullptr;  ///< null: there is none
  std::vector<double> densities;                         ///< one per replica, replica r of both scenes together
  Crossing crossing{0, {-INFINITY, INFINITY}};           ///< of the line through both means, with Fieller's interval

  [[nodiscard]] bool found() const { return below != nullptr; }
};
SignChange sign_change(const SceneRow& row, StressPart part, Density density, MeanFlow mean = MeanFlow::instantaneous);

/// "nu 0.18 (0.16 to 0.20; between 0.15 and 0.3)", or that none of the scenes has it.
std::string text_of(const SignChange& change, Density density);

/// Where N_1 and its collisional part change sign along a row, in every reading; sentences.
std::vector<std::string> crossing_notes(const SceneRow& row);
void append(std::vector<std::string>& notes, std::vector<std::string> more);

/// The rows' values at the centre against a density: points with error bars, joined, and the line of zero.
Plot centre_plot(const std::vector<SceneRow>& rows, StressPart part, Density density);

/// What the numbers are, for the page.
inline constexpr char centre_definition[] =
    "N_1 = (P_xx - P_yy)/p in the centre pair of bins, P compressive positive; N_1^k and N_1^c are the shares of the "
    "kinetic and the collisional stress, over the same whole p. Kinetic part about the instantaneous mean of the bin.";

}  // namespace gpf
