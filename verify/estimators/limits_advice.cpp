// limits.advice: on scenes that the advice has not seen its errors stay within what it promises.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/base/error.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/profile_misfit.hpp"
#include "verify/methods/advice.hpp"
#include "verify/methods/advice_table.hpp"

namespace gpf {
namespace {

constexpr std::array tolerances{0.03, 0.05, 0.1, 0.2};
constexpr double engine_tolerance = 0.05;
constexpr std::array<std::string_view, 5> asked{"mean_velocity", "granular_temperature", "area_fraction",
                                                "slip_velocity", "pressure_yy"};

/// An answer that is not the engine, and how far it was off.
struct Case {
  const SceneValues* scene;
  std::string_view observable;
  double tolerance;
  Candidate advised;
  double engine_seconds;
  double error = NAN;
};

std::vector<std::vector<double>> engine_values(const SceneValues& scene, const Observable& observable) {
  std::vector<std::vector<double>> replicas;
  for (const Record& record : scene.records())
    replicas.push_back(
        observed(observable, derive_quantities(record.scene, TallyLayout(record.run), totals_of(record))));
  return replicas;
}

double error_of(const Case& c) {
  const Record& record = c.scene->records().front();
  Scene scene = record.scene;
  scene.seed ^= 0x5eed;
  Run run = part_of(record.run, 1);
  if (c.advised.duration > 0) run.duration = std::max(c.advised.duration, run.sample_interval);
  const SteadyFlow flow = steady_flow(scene, run, parse_method(c.advised.method));
  const Observable& observable = observable_named(c.observable);
  // Against the mean of all replicas: what the reference does not resolve is taken off.
  return misfit_of({observed(observable, flow.quantities)}, engine_values(*c.scene, observable), observable.absolute)
      .bias;
}

}  // namespace

Evidence estimate_limits_advice(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<ChartPoint> points = advice_table();
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  std::vector<Case> cases;
  int engine = 0;
  for (const SceneValues& scene : scenes)
    for (const ChartPoint& p : points)
      if (p.scene == scene.name())
        throw InputError(fmt::format("the advice has seen '{}'", p.scene), "its table holds the scene",
                         "take another scene in the claim, or hold this one back in reference/methods.toml");
  for (const SceneValues& scene : scenes)
    for (const std::string_view name : asked)
      for (const double tolerance : tolerances) {
        const Advice advice =
            advise(points, scene.scene(), scene.records().front().run, observable_named(name), tolerance);
        const bool by_engine = advice.best().method == "event_driven";
        if (by_engine) ++engine;
        // The engine's own answers are tried at one tolerance, and only where their length rests on evidence.
        if (by_engine && (tolerance != engine_tolerance || !std::isfinite(advice.best().cpu_seconds))) continue;
        const auto own = std::find_if(advice.candidates.begin(), advice.candidates.end(),
                                      [](const Candidate& c) { return c.method == "event_driven"; });
        cases.push_back({&scene, name, tolerance, advice.best(), own->cpu_seconds});
      }
  const double before = process_cpu_seconds();
  for_each_in_parallel(cases.size(), [&](std::size_t k) { cases[k].error = error_of(cases[k]); });
  Evidence evidence;
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  double kept = 0, kept_engine = 0, by_engine = 0, cheapest = 0;
  Series errors{.label = "answers"};
  for (const Case& c : cases) {
    if (c.advised.method == "event_driven") {
      by_engine += 1;
      kept_engine += c.error <= c.tolerance ? 1 : 0;
      continue;
    }
    kept += c.error <= c.tolerance ? 1 : 0;
    errors.x.push_back(c.advised.error_at_most());
    errors.y.push_back(std::max(c.error, 1e-4));
    if (c.error > c.tolerance)
      evidence.notes.push_back(fmt::format("{}, {} within {}: {} was off by {:.3g}.", c.scene->name(), c.observable,
                                           c.tolerance, c.advised.method, c.error));
    if (c.scene->scene().area_fraction() <= claim.parameter("dilute") && std::isfinite(c.engine_seconds))
      cheapest = std::max(cheapest, c.engine_seconds / c.advised.cpu_seconds);
  }
  const double others = static_cast<double>(cases.size()) - by_engine;
  const double share = others > 0 ? kept / others : 0;
  evidence.checks.push_back({.label = "part of the answers that kept their promise",
                             .values = {share},
                             .band = {claim.parameter("least_kept"), 1},
                             .exact = true});
  evidence.checks.push_back({.label = "part of the engine's answers within 5 % that kept theirs",
                             .values = {by_engine > 0 ? kept_engine / by_engine : 0},
                             .band = {claim.parameter("least_kept"), 1},
                             .exact = true});
  evidence.checks.push_back({.label = "answers other than the engine",
                             .values = {others},
                             .band = {claim.parameter("least_answers"), INFINITY},
                             .exact = true});
  evidence.checks.push_back(
      {.label = "how many times cheaper than the engine at the same tolerance, best dilute answer",
       .values = {cheapest},
       .band = {claim.parameter("least_gain"), INFINITY},
       .exact = true});
  evidence.notes.push_back(fmt::format(
      "{} scenes, {} observables, tolerances of 3, 5, 10 and 20 %: {} answers other than the engine, of which {} kept "
      "their promise; {} times the engine, of which {} were tried at 5 % and {} kept it.",
      scenes.size(), asked.size(), others, kept, engine, by_engine, kept_engine));
  evidence.plot = {.title = "Errors of the advised methods on scenes not seen before",
                   .xlabel = "promised",
                   .ylabel = "found",
                   .logx = true,
                   .logy = true,
                   .series = {std::move(errors),
                              {.label = "promise", .style = SeriesStyle::line, .x = {1e-3, 0.2}, .y = {1e-3, 0.2}}}};
  return evidence;
}

}  // namespace gpf
