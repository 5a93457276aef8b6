// The tails at the centre of a scene, as the claims about dense flows read them.
#pragma once

#include <string>
#include <vector>

#include "verify/estimators/velocity_tail.hpp"

namespace gpf {

struct Side {
  TailSide side;
  const char* label;
};
inline constexpr Side tail_sides[] = {
    {TailSide::both, "both tails"}, {TailSide::positive, "positive tail"}, {TailSide::negative, "negative tail"}};

/// One velocity component at the centre of one scene (its two middle bins; 9 and 10 of 18).
struct CentreTail {
  double nu, restitution, wall;
  Velocity velocity;
  std::vector<VelocityDistribution> distributions;
  std::vector<std::vector<TailFit>> fits;  ///< by side, as in tail_sides; then by window, as in tail_windows

  CentreTail(const SceneValues& scene, Velocity v);
  [[nodiscard]] std::string label() const;
  /// In every replica the histogram holds all counts up to this, in sigma.
  [[nodiscard]] double reach() const;
  /// Counts beyond three sigma, over those of a Gaussian.
  [[nodiscard]] std::vector<double> over_population() const;
};

/// By area fraction, smooth walls first, from elastic to dissipative.
std::vector<CentreTail> centre_tails(const SceneRecords& records, Velocity velocity);

/// "2-4 sigma".
std::string window_label(TailWindow window);

/// Adds what the page says of each: exponents by window, and which law the counts prefer; or that its histogram ends
/// within the windows.
void note_tails(Evidence& evidence, const std::vector<CentreTail>& tails);

/// Adds the health check that the histograms hold every count of the windows.
void check_reach(Evidence& evidence, const std::vector<CentreTail>& tails);

/// Positive tails on logarithmic axes: an empty plot, a scene in it, and a line of the given exponent through (3,
/// level).
Plot tail_plot(std::string title);
void add_tail(Plot& plot, const CentreTail& tail);
void add_power_law(Plot& plot, double exponent, double level);

/// What u is, for the page.
inline constexpr const char* tail_definitions =
    "u_x is taken about the instantaneous mean of the bin (eq. 2.10), and in the lines so called about the long-time "
    "mean, where a plug that sloshes adds its own motion; u_y is c_y, whose mean is 0. Bin 10 is seen in the mirror "
    "and "
    "added to bin 9. Units: the measured sigma.";

}  // namespace gpf
