// limits.hydrodynamics.*: where the theory's profiles are those of the engine, and where they no longer are.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/flow/range.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/profile_misfit.hpp"

namespace gpf {
namespace {

struct Axis {
  const char* label;
  double (*of)(const Scene&);
};

/// What the claim scans: parameter `axis` 1, 2 or 3.
Axis axis_of(const Claim& claim) {
  const int number = static_cast<int>(claim.parameter("axis"));
  if (number == 1) return {"Knudsen number", knudsen_number};
  if (number == 2) return {"1 - e_n", [](const Scene& s) { return 1 - s.normal_restitution; }};
  if (number == 3) return {"mean nu", [](const Scene& s) { return s.area_fraction(); }};
  throw InputError(fmt::format("axis = {}", number), "1 is the Knudsen number, 2 is 1 - e_n, 3 is nu", "choose one");
}

}  // namespace

Evidence estimate_limits_hydrodynamics(const Claim& claim, Tier, const SceneRecords& records) {
  const Axis axis = axis_of(claim);
  const double tolerance = claim.tolerance_total();
  Evidence evidence;
  evidence.plot = {.title = "Largest misfit of U, T and nu",
                   .xlabel = axis.label,
                   .ylabel = "root mean square over the bins, relative",
                   .logx = true,
                   .logy = true};
  RangeScan scan{tolerance};
  Series dissipative{.label = "Garzo & Dufty"};
  const double before = process_cpu_seconds();
  for (const SceneValues& scene : by_area_fraction(records)) {
    const Run& run = scene.records().front().run;
    const MethodSetting setting = parse_method("hydrodynamics");
    const std::vector<SteadyFlow> flow{steady_flow(scene.scene(), run, setting)};
    const double x = axis.of(scene.scene());
    scan.add(scene, flow, flow.front().warnings, x, evidence);
    try {
      const std::vector<SteadyFlow> other{
          steady_flow(scene.scene(), run, parse_method("hydrodynamics closure=garzo_dufty"))};
      add_point(dissipative, x, largest_misfits(scene, other));
    } catch (const PhysicsError& error) {
      evidence.notes.push_back(fmt::format("{}, Garzo & Dufty: {}.", scene.name(), error.problem()));
    }
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  scan.draw(evidence.plot);
  if (!dissipative.x.empty()) evidence.plot.series.push_back(std::move(dissipative));
  double lowest = INFINITY, highest = 0;
  for (const Series& series : evidence.plot.series)
    for (const double x : series.x) lowest = std::min(lowest, x), highest = std::max(highest, x);
  evidence.plot.series.push_back({.label = "what is called right",
                                  .style = SeriesStyle::line,
                                  .x = {lowest, highest},
                                  .y = {tolerance, tolerance}});
  evidence.notes.emplace_back(
      "Closure of Jenkins & Richman, 100 cells; that of Garzo & Dufty is drawn beside it and not judged.");
  return evidence;
}

}  // namespace gpf
