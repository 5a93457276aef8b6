#include "verify/estimators/profile_misfit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/vec2.hpp"

namespace gpf {

std::vector<double> profile_misfits(const SceneValues& scene, std::span<const SteadyFlow> methods,
                                    std::string_view quantity) {
  std::vector<double> difference(scene.replicas(), 0.0), size(scene.replicas(), 0.0);
  for (int bin = 0; bin < scene.bins(); ++bin) {
    const std::vector<double> engine = scene.of(quantity, bin);
    for (std::size_t r = 0; r < engine.size(); ++r) {
      const std::size_t flow = methods.size() == 1 ? 0 : r;
      const double found = values_of(methods[flow].quantities, quantity)[static_cast<std::size_t>(bin)];
      difference[r] += square(found - engine[r]);
      size[r] += square(engine[r]);
    }
  }
  return per_replica(scene.replicas(), [&](std::size_t r) { return std::sqrt(difference[r] / size[r]); });
}

std::vector<double> largest_misfits(const SceneValues& scene, std::span<const SteadyFlow> methods) {
  std::vector<double> largest(scene.replicas(), 0.0);
  for (const ComparedProfile& profile : compared_profiles) {
    const std::vector<double> misfits = profile_misfits(scene, methods, profile.quantity);
    for (std::size_t r = 0; r < misfits.size(); ++r) largest[r] = std::max(largest[r], misfits[r]);
  }
  return largest;
}

void RangeScan::add(const SceneValues& scene, std::span<const SteadyFlow> methods,
                    const std::vector<std::string>& warnings, double x, Evidence& evidence) {
  const std::vector<double> largest = largest_misfits(scene, methods);
  add_point(warnings.empty() ? within : beyond, x, largest);
  if (!warnings.empty()) {
    evidence.checks.push_back({.label = fmt::format("the largest misfit of {}, beyond the range", scene.name()),
                               .values = largest,
                               .band = {tolerance, INFINITY},
                               .x = x});
    evidence.notes.push_back(fmt::format("{}: {}.", scene.name(), fmt::join(warnings, "; ")));
    return;
  }
  for (const ComparedProfile& profile : compared_profiles)
    evidence.checks.push_back({.label = fmt::format("{} of {}, within the range", profile.title, scene.name()),
                               .values = profile_misfits(scene, methods, profile.quantity),
                               .band = {-INFINITY, tolerance},  // none is negative, however the interval lies
                               .x = x});
}

void RangeScan::draw(Plot& plot) {
  for (Series* series : {&within, &beyond})
    if (!series->x.empty()) plot.series.push_back(std::move(*series));
}

Run part_of(const Run& run, double part) {
  Run shorter = run;
  shorter.duration = std::max(run.duration * part, run.sample_interval);
  shorter.detail = Detail::profiles;
  shorter.density_modes = 0;
  shorter.snapshots.clear();
  return shorter;
}

}  // namespace gpf
