// limits.soft-disks.stiffness, .dissipation, .step: soft disks become hard ones, unless the steps are too large.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/flow/range.hpp"
#include "gpf/methods/soft_disks.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

constexpr std::array contacts{0.2, 0.1, 0.05, 0.025};  // in mean free times
constexpr std::array step_counts{2, 3, 4, 6, 8, 12, 24};
constexpr int fine_steps = 24;

/// Sums the virial of the engine's contacts.
struct Virial {
  double sum = 0;
  void on_pair(const PairContact& c) { sum += dot(c.r_12, c.impulse); }
  void on_wall(const WallContact&) {}
};

/// p A/(N T) of an elastic periodic gas from the virial over a time and the mean kinetic energy.
double compressibility(double virial_rate, double kinetic_energy) { return 1 + virial_rate / (2 * kinetic_energy); }

double hard_compressibility(const Scene& scene, const State& start, double time) {
  Engine<> engine(scene, start);
  Virial virial;
  engine.advance(time, virial);
  return compressibility(virial.sum / time, kinetic_energy(start));
}

struct SoftGas {
  double compressibility = 0, overlap = 0, energy_gain = 0;
};
/// `duration` and `time` in the scene's unit. The energy gained is relative.
SoftGas soft_gas(const Scene& scene, const State& start, double duration, int steps, double time) {
  constexpr int looks = 50;
  SoftDisks disks(scene, {duration, steps}, start);
  const double energy = disks.kinetic_energy() + disks.contact_energy();
  double kinetic = 0;
  for (int k = 1; k <= looks; ++k) {
    disks.advance(time * k / looks);
    kinetic += disks.kinetic_energy() / looks;
  }
  return {compressibility(disks.sums().virial / disks.time(), kinetic), disks.deepest_overlap(),
          (disks.kinetic_energy() + disks.contact_energy()) / energy - 1};
}

/// Slope of ln y over ln x with weights.
double exponent(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& weights) {
  double sw = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(y[k]), w = weights[k];
    sw += w, sx += w * a, sy += w * b, sxx += w * a * a, sxy += w * a * b;
  }
  return (sw * sxy - sx * sy) / (sw * sxx - sx * sx);
}

/// ln(E_0/E) of a gas that cools for a time, by the engine.
double hard_cooling(const Scene& scene, const State& start, double time) {
  Engine<> engine(scene, start);
  engine.advance(time);
  return std::log(kinetic_energy(start) / kinetic_energy(engine.state()));
}

/// The slope of ln y over ln x of the means over the replicas, each with the weight (mean/error)^2 that its logarithm
/// has, as pseudo-values of a jackknife: a single replica's value at the stiffest may have the other sign, their mean
/// has not. y: by abscissa, then replica.
std::vector<double> jackknife_exponents(const std::vector<double>& x, const std::vector<std::vector<double>>& y) {
  std::vector<double> means, weights;
  for (const std::vector<double>& values : y) {
    const Estimate summary = over_replicas(values);
    means.push_back(summary.mean);
    weights.push_back(square(summary.mean / summary.error));
  }
  const std::size_t replicas = y.front().size();
  const auto count = static_cast<double>(replicas);
  return per_replica(replicas, [&](std::size_t r) {
    std::vector<double> others;
    for (std::size_t c = 0; c < y.size(); ++c) others.push_back((count * means[c] - y[c][r]) / (count - 1));
    return count * exponent(x, means, weights) - (count - 1) * exponent(x, others, weights);
  });
}

/// What is wanted at the limit that the program warns at, and beyond it at the softest.
void add_limit_checks(const std::string& what, const std::vector<std::vector<double>>& bias, double most,
                      Evidence& evidence) {
  const auto limit = static_cast<std::size_t>(std::find(contacts.begin(), contacts.end(), range::soft_disks_contact) -
                                              contacts.begin());
  evidence.checks.push_back({.label = fmt::format("{} at {} mean free times", what, contacts.at(limit)),
                             .values = bias.at(limit),
                             .band = {0, most},
                             .x = contacts.at(limit)});
  evidence.checks.push_back({.label = fmt::format("{} at {} mean free times", what, contacts.front()),
                             .values = bias.front(),
                             .band = {most, 1},
                             .x = contacts.front()});
}

SceneValues only_scene(const SceneRecords& records) {
  std::vector<SceneValues> scenes = by_area_fraction(records);
  if (scenes.size() != 1 || scenes.front().scene().geometry != Geometry::periodic ||
      scenes.front().scene().normal_restitution < 1)
    throw InputError("the claim wants one elastic periodic scene", "its pressure is compared with that of hard disks",
                     "name one of eos-*");
  return scenes.front();
}

}  // namespace

Evidence estimate_limits_soft_stiffness(const Claim& claim, Tier, const SceneRecords& records) {
  const SceneValues scene = only_scene(records);
  const double before = process_cpu_seconds();
  const std::size_t replicas = scene.replicas();
  std::vector<std::vector<double>> deficit(contacts.size(), std::vector<double>(replicas)), overlap = deficit;
  std::vector<double> hard(replicas);
  for_each_in_parallel(replicas, [&](std::size_t r) {
    const Record& record = scene.records()[r];
    const double mean_free_time = 1 / record.scene.reference_collision_rate();
    const double time = claim.parameter("mean_free_times") * mean_free_time;
    hard[r] = hard_compressibility(record.scene, record.final_state, time);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const SoftGas gas = soft_gas(record.scene, record.final_state, contacts[c] * mean_free_time, fine_steps, time);
      deficit[c][r] = (hard[r] - gas.compressibility) / (hard[r] - 1);
      overlap[c][r] = gas.overlap;
    }
  });
  Evidence evidence;
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  const std::vector<double> x(contacts.begin(), contacts.end());
  Series measured{.label = "(Z - Z_soft)/(Z - 1)"}, deepest{.label = "deepest overlap, d"};
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    add_point(measured, contacts[c], deficit[c]);
    add_point(deepest, contacts[c], overlap[c]);
  }
  evidence.checks.push_back({.label = "exponent of the missing pressure over the duration of a contact",
                             .values = jackknife_exponents(x, deficit),
                             .band = band_about(1, claim.tolerance_total()),
                             .reference = 1});
  add_limit_checks("missing part of Z - 1", deficit, claim.parameter("most_missing"), evidence);
  evidence.plot = {.title = "Soft disks become hard",
                   .xlabel = "duration of a contact in mean free times",
                   .ylabel = "missing pressure, overlap",
                   .logx = true,
                   .logy = true,
                   .series = {std::move(measured), std::move(deepest)}};
  return evidence;
}

Evidence estimate_limits_soft_dissipation(const Claim& claim, Tier, const SceneRecords& records) {
  const SceneValues scene = only_scene(records);
  const double before = process_cpu_seconds();
  const std::size_t replicas = scene.replicas();
  const auto starts = static_cast<int>(claim.parameter("starts"));
  std::vector<std::vector<double>> deficit(contacts.size(), std::vector<double>(replicas));
  std::vector<double> hard(replicas);
  for_each_in_parallel(replicas, [&](std::size_t r) {
    const Record& record = scene.records()[r];
    Scene cooling = record.scene;
    cooling.normal_restitution = claim.parameter("restitution");
    const double mean_free_time = 1 / record.scene.reference_collision_rate();
    const double time = claim.parameter("mean_free_times") * mean_free_time;
    Engine<> elastic(record.scene, record.final_state);
    std::array<double, contacts.size()> soft{};
    for (int start = 1; start <= starts; ++start) {
      const State state = elastic.state();
      hard[r] += hard_cooling(cooling, state, time);
      for (std::size_t c = 0; c < contacts.size(); ++c)
        soft[c] -= std::log1p(soft_gas(cooling, state, contacts[c] * mean_free_time, fine_steps, time).energy_gain);
      elastic.advance(start * time);
    }
    for (std::size_t c = 0; c < contacts.size(); ++c) deficit[c][r] = 1 - soft[c] / hard[r];
  });
  Evidence evidence;
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  const std::vector<double> x(contacts.begin(), contacts.end());
  Series measured{.label = "1 - cooling/that of hard disks"};
  for (std::size_t c = 0; c < contacts.size(); ++c) add_point(measured, contacts[c], deficit[c]);
  evidence.checks.push_back({.label = "exponent of the missing dissipation over the duration of a contact",
                             .values = jackknife_exponents(x, deficit),
                             .band = band_about(1, claim.tolerance_total()),
                             .reference = 1});
  add_limit_checks("missing part of the dissipation", deficit, claim.parameter("most_missing"), evidence);
  evidence.plot = {.title = "Soft disks cool too slowly",
                   .xlabel = "duration of a contact in mean free times of the start",
                   .ylabel = "missing dissipation",
                   .logx = true,
                   .logy = true,
                   .series = {std::move(measured)}};
  evidence.notes.push_back(
      fmt::format("Hard disks keep {:.3g} of their energy.", std::exp(-over_replicas(hard).mean / starts)));
  return evidence;
}

Evidence estimate_limits_soft_step(const Claim& claim, Tier, const SceneRecords& records) {
  const SceneValues scene = only_scene(records);
  const double before = process_cpu_seconds();
  std::vector<std::vector<double>> gain(step_counts.size(), std::vector<double>(scene.replicas()));
  for_each_in_parallel(scene.replicas(), [&](std::size_t r) {
    const Record& record = scene.records()[r];
    const double mean_free_time = 1 / record.scene.reference_collision_rate();
    for (std::size_t k = 0; k < step_counts.size(); ++k) try {
        gain[k][r] = soft_gas(record.scene, record.final_state, range::soft_disks_contact * mean_free_time,
                              step_counts[k], claim.parameter("mean_free_times") * mean_free_time)
                         .energy_gain;
      } catch (const PhysicsError&) {
        gain[k][r] = claim.parameter("stopped");  // disks overlapped by half a diameter
      }
  });
  Evidence evidence;
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  Series measured{.label = "energy gained"};
  const double tolerance = claim.tolerance_total();
  for (std::size_t k = 0; k < step_counts.size(); ++k) {
    add_point(measured, step_counts[k], magnitude(gain[k]));
    const bool fine = step_counts[k] >= range::soft_disks_steps;
    if (!fine && step_counts[k] > claim.parameter("fails_up_to")) continue;  // between the two
    evidence.checks.push_back({.label = fmt::format("energy gained with {} steps in a contact", step_counts[k]),
                               .values = gain[k],
                               .band = fine ? band_about(0, tolerance) : Interval{tolerance, INFINITY},
                               .x = static_cast<double>(step_counts[k])});
  }
  evidence.plot = {.title = "Energy that elastic soft disks gain",
                   .xlabel = "steps in a contact",
                   .ylabel = "relative gain",
                   .logx = true,
                   .logy = true,
                   .series = {std::move(measured)}};
  evidence.notes.push_back(
      fmt::format("A run that the method stopped (disks overlap by half a diameter) counts as a gain of {}.",
                  claim.parameter("stopped")));
  return evidence;
}

}  // namespace gpf
