// Velocity distributions in a bin, from the histograms of records: on one grid, in units of the measured sigma.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "gpf/io/record.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {

/// Which velocity. ux: c_x less the instantaneous mean of its bin (thesis eq. 2.10). uy: c_y; its long-time mean is 0.
/// cx: c_x, hence, about its mean over the whole run, u_x by the other definition.
enum class Velocity { ux, uy, cx };

/// "u_x", "u_y" or "u_x about the long-time mean".
const char* name_of(Velocity velocity);

/// Counts of u/sigma on a grid of cells of .1 from -12 to 12, where sigma = <u^2>^(1/2) is measured with the same
/// counts (thesis sec. 3.1). A cell of a record's histogram, which is in units of its own, is shared out evenly.
struct VelocityDistribution {
  static constexpr double cell = 0.1, range = 12;
  static constexpr std::size_t cells = 240;

  double mean = 0;      ///< subtracted from cx; 0 for the others. Units (g W)^(1/2)
  double sigma = 0;     ///< the same units
  double skewness = 0;  ///< <u^3>/sigma^3
  double kurtosis = 0;  ///< <u^4>/sigma^4; 3 for a Gaussian
  double reach = 0;     ///< |u|/sigma up to which all counts are on the grid
  double total = 0;     ///< counts, those beyond included
  std::vector<double> counts = std::vector<double>(cells, 0.0);

  /// u/sigma at the middle of a cell.
  static double centre(std::size_t i) { return (static_cast<double>(i) + 0.5) * cell - range; }
  /// Counts with from < u/sigma < to; both on edges of cells.
  [[nodiscard]] double between(double from, double to) const;
  /// P(u) with P(0) = 1, by cell; P(0) is the mean of the four cells about 0.
  [[nodiscard]] std::vector<double> density() const;
  /// Share of the counts with |u| > x sigma, beyond the grid included.
  [[nodiscard]] double beyond(double x) const { return 1 - between(-x, x) / total; }
};

/// Of bin `bin` (from 0) and its mirror image, seen in the mirror, together: u_y changes sign there.
/// Throws InputError when the record has no histograms or the bin was empty.
VelocityDistribution velocity_distribution(const Record& record, Velocity velocity, int bin);

/// The same for each replica.
std::vector<VelocityDistribution> velocity_distributions(const SceneValues& scene, Velocity velocity, int bin);

/// Points of P(u), mean and error over the replicas, one for `step` cells, where at least one count was made.
Series density_series(std::string label, const std::vector<VelocityDistribution>& replicas, std::size_t step = 2);

/// exp(-x^2/2) as a line.
Series gaussian_series();

/// A plot of P(u/sigma) with P(0) = 1 on a logarithmic axis, down to `least`.
Plot density_plot(std::string title, double least);

/// max |F(u) - Phi(u)|: distance of the distribution from a Gaussian of the same mean and sigma.
double distance_from_gaussian(const VelocityDistribution& distribution);

/// Variance of counts over the replicas, over what independent counts would have; at least 1.
double dispersion(const std::vector<VelocityDistribution>& replicas);

struct Peak {
  double position = 0;  ///< u/sigma
  double height = 0;    ///< P(0) = 1
};

/// The peaks of P(u), from low u to high: maxima of the counts summed over three cells (.3 sigma) that stand out, on
/// either side, by 2 % of the highest peak and by four standard errors. `dispersion` as above.
std::vector<Peak> find_peaks(const VelocityDistribution& distribution, double dispersion);

/// 1 - P(|u| < .1 sigma)/P(.4 sigma < |u| < .6 sigma): above 0 for two humps about a dip at 0; -.13 for a Gaussian.
double dip_at_zero(const VelocityDistribution& distribution);

}  // namespace gpf
