#include "verify/estimators/correlation_windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gpf {

std::vector<double> mean_in(const DistanceWindow& window, const VelocityCorrelation& correlation,
                            const std::vector<PairFunctions>& pairs) {
  const bool forced = correlation.component == Component::xx && correlation.mean == Mean::instantaneous;
  return per_replica(pairs.size(), [&](std::size_t r) {
    return pairs[r].mean_correlation(correlation.component, window.from, window.to, correlation.mean) -
           (forced ? pairs[r].forced_offset() : 0);
  });
}

std::string text_of(const std::vector<double>& values) {
  const Estimate e = over_replicas(values);
  return fmt::format("{:.3f} +- {:.3f}", e.mean, e.error);
}

Plot correlation_plot(std::string title, std::string ylabel) {
  return {.title = std::move(title), .xlabel = "r/d", .ylabel = std::move(ylabel), .xrange = {{0.9, 12}}};
}

Series correlation_series(const std::string& label, const std::vector<PairFunctions>& pairs,
                          const VelocityCorrelation& correlation) {
  return curve_of(label, pairs, [correlation](const PairFunctions& p) {
    return p.velocity_correlation(correlation.component, correlation.mean);
  });
}

const char* const correlation_definitions =
    "C_ab(r) = <u_a u_b'>/<u_a u_b> over pairs at distance r (eq. 3.4, read as a mean over pairs), from the pairs of "
    "one bin, y and W - y together; u_x about the instantaneous mean of the bin (eq. 2.10), unless the long-time mean "
    "is named. Curves are as measured; from the numbers of C_xx the mean over all pairs that eq. 2.10 forces, "
    "-1/(n - 1), is taken off.";

}  // namespace gpf
