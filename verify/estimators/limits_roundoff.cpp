// limits.roundoff: what round-off does over long runs, and what it would do in single precision.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/event/engine.hpp"
#include "gpf/event/position_grid.hpp"
#include "gpf/event/state_check.hpp"
#include "gpf/methods/all_pairs.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/departure.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/limit_scenes.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

struct Case {
  const char* name;
  Scene scene;
};

constexpr int disks = 32;

/// A square channel.
Scene channel(double area_fraction, double restitution) {
  Scene scene =
      limit_channel(disks, limit_gas(disks, area_fraction, 1).width_over_diameter, area_fraction, restitution);
  scene.tc_time = 1e-4 / scene.reference_collision_rate();
  return scene;
}

/// For what must hold however long a run is, and whatever the disks do.
std::vector<Case> long_cases() {
  return {{"gas, nu 0.30, elastic", limit_gas(disks, 0.30, 1)},
          {"gas, nu 0.70, elastic", limit_gas(disks, 0.70, 1)},
          {"channel, nu 0.30, e_n 0.9", channel(0.30, 0.9)},
          {"channel, nu 0.60, e_n 0.6", channel(0.60, 0.6)}};
}

/// Fluids that are the same everywhere and at all times: crystals and clusters have no one rate of growth.
std::vector<Case> mixing_cases() {
  return {{"gas, nu 0.10, elastic", limit_gas(disks, 0.10, 1)},
          {"gas, nu 0.30, elastic", limit_gas(disks, 0.30, 1)},
          {"channel, nu 0.30, e_n 0.9", channel(0.30, 0.9)}};
}

// ---- the engine over long runs ----

/// Deepest overlap at t = 1, 10, 100, ... in quanta of the grid of positions.
void check_overlap(const Claim& claim, double until, Evidence& evidence) {
  const std::vector<Case> all = long_cases();
  std::vector<std::vector<double>> deepest(all.size());
  std::vector<double> contacts(all.size());
  for_each_in_parallel(all.size(), [&](std::size_t k) {
    const Scene& scene = all[k].scene;
    Engine<> engine(scene, start_state(scene));
    const double quantum = PositionGrid(scene.length(), 1).quantum();
    for (double time = 1; time < 1.01 * until; time *= 10) {
      engine.advance(time);
      deepest[k].push_back(engine.deepest_overlap() / quantum);
    }
    contacts[k] = static_cast<double>(engine.counts().pair_contacts);
  });
  for (std::size_t k = 0; k < all.size(); ++k) {
    double time = 1;
    for (const double depth : deepest[k]) {
      evidence.checks.push_back(
          {.label = fmt::format("{}: deepest overlap of the engine up to t = {:g}, in quanta", all[k].name, time),
           .values = {depth},
           .band = {0, claim.parameter("overlap_quanta")},
           .exact = true,
           .x = time});
      time *= 10;
    }
    evidence.notes.push_back(
        fmt::format("{}: engine up to t = {:g}, {:.3g} collisions, deepest overlap {:.2f} quanta = {:.2g} d.",
                    all[k].name, until, contacts[k], deepest[k].back(),
                    deepest[k].back() * PositionGrid(all[k].scene.length(), 1).quantum() / all[k].scene.diameter()));
  }
}

/// Numbers of the state that differ by a bit when the same run begins in a late epoch.
double bits_lost(const Scene& scene, std::int64_t first_epoch, int epochs) {
  Engine<> early(scene, start_state(scene));
  EngineState state = early.checkpoint();
  state.epoch = first_epoch;
  Engine<> late(scene, state);
  for (int k = 0; k < epochs; ++k) early.advance(early.epoch_end()), late.advance(late.epoch_end());
  const EngineState a = early.checkpoint(), b = late.checkpoint();
  double count = a.counts.pair_contacts == b.counts.pair_contacts ? 0 : 1;
  for (const auto member : {&EngineState::x, &EngineState::y, &EngineState::vx, &EngineState::vy})
    for (std::size_t i = 0; i < (a.*member).size(); ++i) count += (a.*member)[i] == (b.*member)[i] ? 0 : 1;
  return count;
}

void check_origin(const Claim& claim, Evidence& evidence) {
  const auto epoch = static_cast<std::int64_t>(std::exp2(claim.parameter("late_epoch_log2")));
  for (const Case& c : long_cases())
    evidence.checks.push_back(
        {.label = fmt::format("{}: numbers of the state that differ when the run begins at t = {:.2g}", c.name,
                              static_cast<double>(epoch) * Engine<>::epoch_length(c.scene)),
         .values = {bits_lost(c.scene, epoch, 64)},
         .band = {0, 0},
         .exact = true});
}

// ---- single against double precision ----

/// What arithmetic has done to a run of the O(N) search.
struct Wear {
  double overlap = 0;  ///< deepest at a contact, in diameters
  double energy = 0;   ///< largest relative change of the energy of elastic disks
  double allowed = 0;  ///< contacts until an overlap was deeper than the engine goes on from
};

template <class Real>
Wear wear(const Scene& scene, const State& start, int contacts) {
  AllPairs<Real> oracle(scene, start);
  const double energy = oracle.energy(), deepest_allowed = detail::deepest_round_off(scene) / scene.diameter();
  Wear wear;
  for (int k = 0; k < contacts; ++k) {
    const AllPairsEvent event = oracle.step();
    const State now = oracle.state();
    Vec2 r = now.position[static_cast<std::size_t>(event.b)] - now.position[static_cast<std::size_t>(event.a)];
    r.x -= scene.length() * std::round(r.x / scene.length());
    r.y -= std::round(r.y);
    wear.overlap = std::max(wear.overlap, 1 - std::sqrt(dot(r, r)) / scene.diameter());
    wear.energy = std::max(wear.energy, std::abs(oracle.energy() / energy - 1));
    if (wear.overlap <= deepest_allowed) wear.allowed = k + 1;
  }
  return wear;
}

/// A state that has forgotten its lattice, in numbers of single precision.
State mixed(const Scene& scene) {
  Engine<> engine(scene, start_state(scene));
  engine.advance(20 / scene.reference_collision_rate());
  return rounded_to_float(engine.state());
}

void check_wear(const Claim& claim, std::size_t seeds, Evidence& evidence) {
  const auto contacts = static_cast<int>(claim.parameter("wear_contacts"));
  for (const Case& c : long_cases()) {
    if (c.scene.geometry != Geometry::periodic) continue;
    std::vector<Wear> single(seeds), twofold(seeds);
    for_each_in_parallel(seeds, [&](std::size_t k) {
      Scene scene = c.scene;
      scene.seed = k + 1;
      const State start = mixed(scene);
      single[k] = wear<float>(scene, start, contacts);
      twofold[k] = wear<double>(scene, start, contacts);
    });
    const auto of = [&](const std::vector<Wear>& runs, double Wear::*value) {
      return per_replica(seeds, [&](std::size_t k) { return runs[k].*value; });
    };
    evidence.checks.push_back(
        {.label = fmt::format("{}: bits of overlap, single over double precision", c.name),
         .values =
             per_replica(seeds, [&](std::size_t k) { return std::log2(single[k].overlap / twofold[k].overlap) / 29; }),
         .band = band_about(1, claim.parameter("overlap_bits")),
         .reference = 1});
    evidence.checks.push_back({.label = fmt::format("{}: energy, largest relative error in single precision", c.name),
                               .values = of(single, &Wear::energy),
                               .band = {1e-7, INFINITY},
                               .exact = true});
    evidence.checks.push_back({.label = fmt::format("{}: energy, largest relative error in double precision", c.name),
                               .values = of(twofold, &Wear::energy),
                               .band = {0, 1e-12},
                               .exact = true});
    evidence.checks.push_back(
        {.label = fmt::format("{}: contacts in single precision before the engine's limit of overlap", c.name),
         .values = of(single, &Wear::allowed),
         .band = {0, claim.parameter("single_contacts")},
         .exact = true});
    evidence.checks.push_back(
        {.label = fmt::format("{}: contacts in double precision before it, of {}", c.name, contacts),
         .values = of(twofold, &Wear::allowed),
         .band = band_about(contacts, 0),
         .exact = true});
  }
}

void plot_departure(const Case& c, const std::vector<Departure>& runs, Evidence& evidence) {
  const auto add = [&](const char* name, const std::vector<double> Departure::*distance) {
    Series line{.label = fmt::format("{}, {}", c.name, name), .style = SeriesStyle::line};
    std::size_t shortest = runs.front().contacts.size();
    for (const Departure& d : runs) shortest = std::min(shortest, d.contacts.size());
    for (std::size_t k = 0; k < shortest; ++k) {
      double contacts = 0, logarithm = 0;
      for (const Departure& d : runs) contacts += d.contacts[k], logarithm += std::log((d.*distance)[k]);
      line.x.push_back(contacts / static_cast<double>(runs.size()));
      line.y.push_back(std::exp(logarithm / static_cast<double>(runs.size())));
    }
    evidence.plot.series.push_back(std::move(line));
  };
  add("float", &Departure::single);
  add("double", &Departure::twofold);
  add("engine", &Departure::engine);
}

void check_departure(const Claim& claim, std::size_t seeds, Evidence& evidence) {
  constexpr double threshold = 0.1;  // diameters
  constexpr double bits = 29;        // that double has more than float: 53 - 24
  for (const Case& c : mixing_cases()) {
    std::vector<Departure> runs(seeds);
    for_each_in_parallel(seeds, [&](std::size_t k) {
      Scene scene = c.scene;
      scene.seed = k + 1;
      runs[k] = departure_from(scene, mixed(scene), threshold, 200);
    });
    const auto of = [&](auto&& f) { return per_replica(seeds, [&](std::size_t k) { return f(runs[k]); }); };
    const auto rate = [](const Departure& d) { return d.rate(d.twofold, d.twofold, 1e-13, threshold); };
    // Along the same piece of the same trajectory, the one that float still follows.
    const auto ratio = [](const Departure& d) {
      return d.rate(d.single, d.single, 1e-6, 0.01) / d.rate(d.twofold, d.single, 1e-6, 0.01);
    };
    const auto single = [](const Departure& d) { return d.contacts_to(threshold, d.single); };
    const auto twofold = [](const Departure& d) { return d.contacts_to(threshold, d.twofold); };
    const auto engine = [](const Departure& d) { return d.contacts_to(threshold, d.engine); };
    const auto check = [&](const char* what, std::vector<double> values) {
      evidence.checks.push_back({.label = fmt::format("{}: {}", c.name, what),
                                 .values = std::move(values),
                                 .band = band_about(1, claim.tolerance_total()),
                                 .reference = 1});
    };
    evidence.checks.push_back({.label = fmt::format("{}: growth of a difference per contact of a disk", c.name),
                               .values = of(rate),
                               .band = {0, INFINITY}});
    check("growth in single over that in double precision, up to .01 d", of(ratio));
    check("growth times the contacts that double lasts longer, over 29 ln 2",
          of([&](const Departure& d) { return rate(d) * (twofold(d) - single(d)) / (bits * std::log(2.0)); }));
    check("contacts that the engine lasts over those of the O(N) search in double",
          of([&](const Departure& d) { return engine(d) / twofold(d); }));
    evidence.notes.push_back(fmt::format(
        "{}: differences grow by a factor exp({:.3f} +- {:.3f}) per contact of a disk; they reach {} d after {:.1f} "
        "contacts in float, {:.1f} in double and {:.1f} in the engine.",
        c.name, over_replicas(of(rate)).mean, over_replicas(of(rate)).error, threshold, over_replicas(of(single)).mean,
        over_replicas(of(twofold)).mean, over_replicas(of(engine)).mean));
    if (c.scene.geometry == Geometry::periodic) plot_departure(c, runs, evidence);  // the channel's would cover them
  }
}

}  // namespace

Evidence estimate_limits_roundoff(const Claim& claim, Tier tier, const SceneRecords&) {
  const double before = process_cpu_seconds();
  const auto seeds = static_cast<std::size_t>(claim.parameter(tier == Tier::quick ? "seeds_quick" : "seeds_standard"));
  Evidence evidence;
  evidence.plot = {.title = "Two trajectories from one state part",
                   .xlabel = "contacts per disk",
                   .ylabel = "distance from the trajectory in long double, d",
                   .logy = true,
                   .series = {}};
  check_overlap(claim, claim.parameter(fmt::format("longest_{}", name_of(tier))), evidence);
  check_origin(claim, evidence);
  check_departure(claim, seeds, evidence);
  check_wear(claim, seeds, evidence);
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.notes.emplace_back(
      "Chaos makes any round-off grow to the size of the system within some tens of contacts per disk; more digits "
      "only delay it, in proportion. What remains true for ever is what does not depend on the trajectory: no disk in "
      "another, and the balances.");
  return evidence;
}

}  // namespace gpf
