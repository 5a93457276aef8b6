// limits.engine: the engine at the ends of what a scene can ask for.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/event/position_grid.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/balances.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/limit_scenes.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"
#include "verify/health.hpp"

namespace gpf {
namespace {

struct Trial {
  std::string name;
  Scene scene;
  double time;  ///< for how long it runs
};

Trial trial(std::string name, Scene scene, double time) {
  if (scene.normal_restitution < 1) scene.tc_time = 1e-4 / scene.reference_collision_rate();
  return {std::move(name), scene, time};
}

/// So many mean free times of the scene.
Trial short_trial(std::string name, const Scene& scene, double free_times) {
  return trial(std::move(name), scene, free_times / scene.reference_collision_rate());
}

Scene triangular(Scene scene) {
  scene.lattice = Lattice::triangular;
  return scene;
}

/// As dense as a lattice between walls or round a box can be: widths that suit whole rows.
void add_dense(Tier tier, std::vector<Trial>& trials) {
  const double free_times = tier == Tier::quick ? 20 : 500;
  Scene gas = triangular(limit_gas(900, 0.90, 0.99));
  gas.width_over_diameter = 31.2;
  gas.length_over_width = std::numbers::pi * gas.particles / (4 * 0.90 * square(gas.width_over_diameter));
  trials.push_back(short_trial("gas, nu 0.90, e_n 0.99", gas, free_times));
  trials.push_back(
      short_trial("channel, nu 0.90, e_n 0.99", triangular(limit_channel(900, 31.32, 0.90, 0.99)), free_times));
  trials.push_back(
      short_trial("channel, nu 0.90, e_n 0.1", triangular(limit_channel(900, 31.32, 0.90, 0.1)), free_times));
}

void add_dissipative(Tier tier, std::vector<Trial>& trials) {
  const std::vector<double> restitutions =
      tier == Tier::quick ? std::vector<double>{0.1} : std::vector<double>{0.1, 0.3, 0.5, 0.7, 0.9};
  for (const double e : restitutions)
    for (const double nu : {0.05, 0.30, 0.70})
      trials.push_back(trial(fmt::format("channel, nu {:.2f}, e_n {:.1f}", nu, e), limit_channel(200, 15, nu, e),
                             tier == Tier::quick ? 2 : 50));
}

void add_dilute(Tier tier, std::vector<Trial>& trials) {
  const double time = tier == Tier::quick ? 1e3 : 1e4;
  trials.push_back(trial("channel, nu 7e-4, e_n 0.9", limit_channel(100, 31, 7e-4, 0.9), time));
  trials.push_back(trial("channel, nu 7e-4, e_n 0.1", limit_channel(100, 31, 7e-4, 0.1), time));
}

void add_long(Tier tier, std::vector<Trial>& trials) {
  const double time = tier == Tier::quick ? 1e3 : 1e5;
  trials.push_back(trial("channel, nu 0.05, e_n 0.9, N 10", limit_channel(10, 5, 0.05, 0.9), time));
  trials.push_back(trial("channel, nu 0.30, e_n 0.9, N 10", limit_channel(10, 5, 0.30, 0.9), time));
  if (tier == Tier::full)
    trials.push_back(trial("channel, nu 0.30, e_n 0.9, N 150", limit_channel(150, 15, 0.30, 0.9), time));
}

void add_large(Tier tier, std::vector<Trial>& trials) {
  const int disks = tier == Tier::quick ? 100'000 : 1'000'000;
  const double width = std::sqrt(std::numbers::pi * disks / (4 * 0.5));  // a square at nu .5
  trials.push_back(
      short_trial(fmt::format("channel, nu 0.50, e_n 0.9, N {}", disks), limit_channel(disks, width, 0.5, 0.9), 2));
  trials.push_back(short_trial(fmt::format("gas, nu 0.50, elastic, N {}", disks), limit_gas(disks, 0.5, 1), 2));
}

/// What became of a trial.
struct Outcome {
  double reached = 0;   ///< part of the time that it ran
  double contacts = 0;  ///< per disk
  double overlap = 0;   ///< over the deepest that is healthy
  Balances balances;
  std::string refusal;
};

Outcome run(const Trial& t) {
  const State start = start_state(t.scene);
  Engine<> engine(t.scene, start);
  Measurement measurement(t.scene, 1);
  measurement.begin(0, start);
  constexpr int samples = 64;
  Outcome outcome;
  State last = start;
  try {
    for (int k = 1; k <= samples; ++k) {
      const double time = t.time * k / samples;
      engine.advance(time, measurement);
      last = engine.state();
      measurement.sample(time, last);
      outcome.reached = static_cast<double>(k) / samples;
    }
  } catch (const PhysicsError& error) {
    outcome.refusal = error.what();
  }
  outcome.contacts = 2 * static_cast<double>(engine.counts().pair_contacts) / t.scene.particles;
  outcome.overlap = engine.deepest_overlap() / t.scene.diameter() / healthy_overlap(t.scene);
  outcome.balances = balances_of(t.scene, measurement, start, last);
  return outcome;
}

void check(const Claim& claim, const Trial& t, const Outcome& outcome, Evidence& evidence) {
  const auto add = [&](const char* what, double value, Interval band) {
    evidence.checks.push_back(
        {.label = fmt::format("{}: {}", t.name, what), .values = {value}, .band = band, .exact = true});
  };
  add("part of the time that it ran", outcome.reached, {1, 1});
  add("deepest overlap over the healthy one", outcome.overlap, {0, 1});
  const double round_off = claim.tolerance_total();
  add("imbalance of energy", outcome.balances.energy, band_about(0, round_off));
  add("imbalance of momentum along x", outcome.balances.momentum_x, band_about(0, round_off));
  add("imbalance of momentum along y", outcome.balances.momentum_y, band_about(0, round_off));
  evidence.notes.push_back(fmt::format(
      "{}: t = {:.3g}, {:.3g} contacts per disk, deepest overlap {:.1g} d, energy "
      "{:.1e}, momentum {:.1e}{}.",
      t.name, t.time * outcome.reached, outcome.contacts, outcome.overlap * healthy_overlap(t.scene),
      outcome.balances.energy, std::max(std::abs(outcome.balances.momentum_x), std::abs(outcome.balances.momentum_y)),
      outcome.refusal.empty() ? "" : "; refused: " + outcome.refusal));
}

}  // namespace

Evidence estimate_limits_engine(const Claim& claim, Tier tier, const SceneRecords&) {
  const double before = process_cpu_seconds();
  std::vector<Trial> trials;
  for (const auto add : {add_large, add_long, add_dense, add_dissipative, add_dilute}) add(tier, trials);
  std::vector<Outcome> outcomes(trials.size());
  for_each_in_parallel(trials.size(), [&](std::size_t k) { outcomes[k] = run(trials[k]); });

  Evidence evidence;
  Series overlap{.label = "deepest overlap over the healthy one"}, energy{.label = "imbalance of energy"},
      momentum{.label = "imbalance of momentum"};
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const Outcome& outcome = outcomes[k];
    check(claim, trials[k], outcome, evidence);
    const double contacts = std::max(1e-3, outcome.contacts);
    const auto point = [&](Series& series, double value) {
      series.x.push_back(contacts);
      series.y.push_back(std::max(value, 0x1p-53));  // no error at all is drawn at the resolution of a double
    };
    point(overlap, outcome.overlap);
    point(energy, std::abs(outcome.balances.energy));
    point(momentum, std::max(std::abs(outcome.balances.momentum_x), std::abs(outcome.balances.momentum_y)));
  }
  evidence.plot = {.title = "Round-off in extreme runs",
                   .xlabel = "contacts per disk",
                   .ylabel = "part of what is healthy, or relative imbalance",
                   .logx = true,
                   .logy = true,
                   .yrange = {{1e-17, 10}},
                   .series = {{.label = "allowed imbalance",
                               .style = SeriesStyle::band,
                               .x = {1, 1e6},
                               .lower = {1e-17, 1e-17},
                               .upper = {claim.tolerance_total(), claim.tolerance_total()}},
                              overlap,
                              energy,
                              momentum}};
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.notes.emplace_back(
      "Energy: work of gravity less losses and kinetic energy gained, over the work or the energy at the start. "
      "Momentum: what was gained less what gravity and walls gave, along both axes. An engine that hangs makes this "
      "claim run for ever: its watchdog and the time limit of the test are what ends that.");
  return evidence;
}

}  // namespace gpf
