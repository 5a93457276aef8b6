// What the claims about velocity correlations share: means over windows of distance, curves and the definitions.
#pragma once

#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "verify/estimators/pair_functions.hpp"

namespace gpf {

struct DistanceWindow {
  double from, to;  ///< in diameters
};
inline constexpr DistanceWindow near_window{1, 3}, far_window{10, 12};

struct VelocityCorrelation {
  Component component;
  Mean mean;
  const char* name;
};
inline constexpr VelocityCorrelation cxx{Component::xx, Mean::instantaneous, "C_xx"},
    cxx_long_time{Component::xx, Mean::long_time, "C_xx about the long-time mean"},
    cyy{Component::yy, Mean::instantaneous, "C_yy"}, cxy{Component::xy, Mean::instantaneous, "C_xy"};

/// Pair-weighted mean of a correlation in a window, one value per replica. -1/(n - 1), which eq. 2.10 forces upon C_xx
/// at every distance even where velocities are independent, is taken off.
std::vector<double> mean_in(const DistanceWindow& window, const VelocityCorrelation& correlation,
                            const std::vector<PairFunctions>& pairs);

/// "mean +- error" over the replicas.
std::string text_of(const std::vector<double>& values);

Plot correlation_plot(std::string title, std::string ylabel);
Series correlation_series(const std::string& label, const std::vector<PairFunctions>& pairs,
                          const VelocityCorrelation& correlation);

/// For the notes.
extern const char* const correlation_definitions;

}  // namespace gpf
