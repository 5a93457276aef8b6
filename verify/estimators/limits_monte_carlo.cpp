// limits.monte-carlo, .dilute: where Enskog's equation gives the engine's flow, and how well when it is dilute.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/flow/range.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/profile_misfit.hpp"

namespace gpf {
namespace {

/// The claim's cells, or with cells = 0 as many as Enskog's mean free path fits into the scene's channel.
MethodSetting setting_of(const Claim& claim, const Scene& scene) {
  const auto asked = static_cast<int>(claim.parameter("cells"));
  const int fine = static_cast<int>(std::ceil((1 - scene.diameter()) / knudsen_number(scene)));
  MethodSetting setting;
  setting.method = Method::monte_carlo;
  setting.monte_carlo = {asked > 0 ? asked : fine, static_cast<int>(claim.parameter("particles_per_cell")),
                         claim.parameter("step")};
  return setting;
}

struct Number {
  const char *label, *quantity;
  bool profile;  ///< averaged over the bins
};
constexpr std::array<Number, 4> numbers{{{"mean velocity", "mean_flow", false},
                                         {"velocity at the centre", "centre_velocity", false},
                                         {"temperature", "granular_temperature", true},
                                         {"wall pressure", "wall_pressure_lower", false}}};

/// A run for each replica; `failure` when one gave up.
struct Flows {
  std::vector<SteadyFlow> replicas;
  std::string failure;
};
Flows flows_of(const SceneValues& scene, const MethodSetting& setting, double part) {
  Flows flows{std::vector<SteadyFlow>(scene.replicas()), ""};
  std::vector<std::string> failures(scene.replicas());
  for_each_in_parallel(scene.replicas(), [&](std::size_t r) {
    const Record& record = scene.records()[r];
    Scene own = record.scene;
    own.seed ^= 0x5eed;  // not the numbers that the engine's start was drawn with
    try {
      flows.replicas[r] = steady_flow(own, part_of(record.run, part), setting);
    } catch (const PhysicsError& error) {
      failures[r] = error.problem();
    }
  });
  for (const std::string& failure : failures)
    if (!failure.empty()) flows.failure = failure;
  return flows;
}

}  // namespace

Evidence estimate_limits_monte_carlo(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = {.title = "Largest misfit of U, T and nu",
                   .xlabel = "mean nu",
                   .ylabel = "root mean square over the bins, relative",
                   .logx = true,
                   .logy = true};
  RangeScan scan{claim.tolerance_total()};
  const double before = process_cpu_seconds();
  for (const SceneValues& scene : by_area_fraction(records)) {
    const double nu = scene.scene().area_fraction();
    const MethodSetting setting = setting_of(claim, scene.scene());
    const std::vector<std::string> warnings = range_warnings(scene.scene(), setting);
    const Flows flows = flows_of(scene, setting, claim.parameter("part"));
    evidence.notes.push_back(fmt::format("{}: {}.", scene.name(), text_of(setting)));
    if (!flows.failure.empty()) {
      // A method that says so has not returned nonsense.
      evidence.checks.push_back({.label = fmt::format("{}: given up, beyond the range", scene.name()),
                                 .values = std::vector<double>(scene.replicas(), warnings.empty() ? 0.0 : 1.0),
                                 .band = {1, 1},
                                 .exact = true});
      evidence.notes.push_back(fmt::format("{}: {}.", scene.name(), flows.failure));
      continue;
    }
    scan.add(scene, flows.replicas, warnings, nu, evidence);
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  scan.draw(evidence.plot);
  return evidence;
}

Evidence estimate_monte_carlo_dilute(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = {.title = "Enskog Monte Carlo over the engine, less 1", .xlabel = "mean nu", .ylabel = "ratio - 1"};
  const double before = process_cpu_seconds();
  for (const Number& number : numbers) evidence.plot.series.push_back({.label = number.label});
  for (const SceneValues& scene : by_area_fraction(records)) {
    const MethodSetting setting = setting_of(claim, scene.scene());
    const Flows flows = flows_of(scene, setting, claim.parameter("part"));
    evidence.notes.push_back(fmt::format("{}: {}.", scene.name(), text_of(setting)));
    if (!flows.failure.empty()) throw PhysicsError(flows.failure, scene.name(), "take a scene that is less dense");
    std::size_t series = 0;
    for (const Number& number : numbers) {
      const int bins = number.profile ? scene.bins() : 1;
      std::vector<double> engine(scene.replicas(), 0.0), method(scene.replicas(), 0.0);
      for (int bin = 0; bin < bins; ++bin) {
        const std::vector<double> values = scene.of(number.quantity, bin);
        for (std::size_t r = 0; r < values.size(); ++r) {
          engine[r] += values[r] / bins;
          method[r] += values_of(flows.replicas[r].quantities, number.quantity)[static_cast<std::size_t>(bin)] / bins;
        }
      }
      const double mean = over_replicas(engine).mean;
      std::vector<double> ratio =
          per_replica(scene.replicas(), [&](std::size_t r) { return (method[r] - engine[r]) / mean; });
      add_point(evidence.plot.series[series++], scene.scene().area_fraction(), ratio);
      evidence.checks.push_back({.label = fmt::format("{} of {}", number.label, scene.name()),
                                 .values = std::move(ratio),
                                 .band = band_about(0, claim.tolerance_total()),
                                 .x = scene.scene().area_fraction()});
    }
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  return evidence;
}

}  // namespace gpf
