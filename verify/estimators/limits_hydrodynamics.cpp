// limits.hydrodynamics.*: where the theory's profiles are those of the engine, and where they no longer are.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gpf/base/error.hpp"
#include "gpf/flow/range.hpp"
#include "gpf/theory/contact_value.hpp"
#include "gpf/theory/enskog.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/profile_misfit.hpp"

namespace gpf {
namespace {

struct Axis {
  const char* label;
  double (*of)(const Scene&);
};

double knudsen_of(const Scene& scene) {
  const double nu = scene.area_fraction();
  return mean_free_path({nu, 1, scene.diameter(), henderson_contact_value(nu)});
}

/// What the claim scans: parameter `axis` 1, 2 or 3.
Axis axis_of(const Claim& claim) {
  const int number = static_cast<int>(claim.parameter("axis"));
  if (number == 1) return {"Knudsen number", knudsen_of};
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
  Series within{.label = "within the range"}, beyond{.label = "beyond it"}, dissipative{.label = "Garzo & Dufty"};
  const double before = process_cpu_seconds();
  for (const SceneValues& scene : by_area_fraction(records)) {
    const Run& run = scene.records().front().run;
    const MethodSetting setting = parse_method("hydrodynamics");
    const std::vector<SteadyFlow> flow{steady_flow(scene.scene(), run, setting)};
    const std::vector<double> largest = largest_misfits(scene, flow);
    const double x = axis.of(scene.scene());
    const std::vector<std::string> warnings = range_warnings(scene.scene(), setting);
    if (warnings.empty()) {
      for (const ComparedProfile& profile : compared_profiles)
        evidence.checks.push_back({.label = fmt::format("{} of {}, within the range", profile.title, scene.name()),
                                   .values = profile_misfits(scene, flow, profile.quantity),
                                   .band = {0, tolerance},
                                   .x = x});
    } else {
      evidence.checks.push_back({.label = fmt::format("the largest misfit of {}, beyond the range", scene.name()),
                                 .values = largest,
                                 .band = {tolerance, std::numeric_limits<double>::infinity()},
                                 .x = x});
      evidence.notes.push_back(fmt::format("{}: {}.", scene.name(), fmt::join(warnings, "; ")));
    }
    add_point(warnings.empty() ? within : beyond, x, largest);
    try {
      const std::vector<SteadyFlow> other{
          steady_flow(scene.scene(), run, parse_method("hydrodynamics closure=garzo_dufty"))};
      add_point(dissipative, x, largest_misfits(scene, other));
    } catch (const PhysicsError& error) {
      evidence.notes.push_back(fmt::format("{}, Garzo & Dufty: {}.", scene.name(), error.problem()));
    }
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  for (Series* series : {&within, &beyond, &dissipative})
    if (!series->x.empty()) evidence.plot.series.push_back(std::move(*series));
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
