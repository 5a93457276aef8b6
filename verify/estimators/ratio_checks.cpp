#include "verify/estimators/ratio_checks.hpp"

#include "verify/estimators/scene_values.hpp"

namespace gpf {

RatioChecks::RatioChecks(const Claim& claim) : band_(band_about(1, claim.tolerance_total())) {}

void RatioChecks::add(std::string label, std::vector<double> values) {
  checks_.push_back({.label = std::move(label), .values = std::move(values), .band = band_, .reference = 1});
}

Evidence RatioChecks::evidence(std::string title, std::string ylabel) const {
  Evidence evidence;
  evidence.checks = checks_;
  Series points{.label = "each run"};
  for (const Check& check : checks_)
    for (const double value : check.values) {
      points.x.push_back(static_cast<double>(points.x.size() + 1));
      points.y.push_back(value);
    }
  const std::vector<double> ends{0, static_cast<double>(points.x.size() + 1)};
  evidence.plot = {.title = std::move(title),
                   .xlabel = "run",
                   .ylabel = std::move(ylabel),
                   .xrange = {{ends[0], ends[1]}},
                   .series = {{.label = "allowed",
                               .style = SeriesStyle::band,
                               .x = ends,
                               .lower = {band_.lo, band_.lo},
                               .upper = {band_.hi, band_.hi}},
                              points}};
  return evidence;
}

}  // namespace gpf
