// algo.two-codes: the event-driven engine and the O(N) search give the same contacts and the same fields.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "gpf/event/engine.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/methods/all_pairs.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// The engine's first contacts, as the oracle names them.
struct ContactLog {
  std::vector<AllPairsEvent> events;
  void on_pair(const PairContact& c) {
    events.push_back({c.time, std::min(c.first, c.second), std::max(c.first, c.second)});
  }
  void on_wall(const WallContact& c) {
    events.push_back({c.time, c.disk, c.wall == Wall::lower ? AllPairsEvent::lower_wall : AllPairsEvent::upper_wall});
  }
};

/// How many contacts both codes execute alike from `start`, of the first `most`: the same disks, in the same order, at
/// times that differ by less than a millionth of the mean time between two contacts of a disk. After some tens of
/// contacts per disk round-off has grown to the size of the system, as in any chaotic flow.
double same_contacts(const Scene& scene, const State& start, std::size_t most) {
  const double tolerance = 1e-6 / scene.reference_collision_rate();
  ContactLog log;
  Engine<> engine(scene, start);
  const double step = 0.25 / scene.reference_collision_rate();
  for (int k = 1; log.events.size() < most; ++k) engine.advance(k * step, log);
  AllPairs<double> oracle(scene, start);
  for (std::size_t n = 0; n < most; ++n) {
    const AllPairsEvent event = oracle.step(), &other = log.events[n];
    if (event.a != other.a || event.b != other.b || !(std::abs(event.time - other.time) < tolerance))
      return static_cast<double>(n);
  }
  return static_cast<double>(most);
}

/// U and T of each bin over `window`, by the O(N) search from `start`; the fields are sampled and derived exactly as
/// the engine's are.
struct Fields {
  std::vector<double> velocity, temperature;
};
Fields oracle_fields(const Record& record, double window) {
  const Run& run = record.run;
  AllPairs<double> oracle(record.scene, record.final_state);
  Measurement measurement(record.scene, run.bins);
  measurement.begin(0, record.final_state);
  for (int k = 1; k * run.sample_interval <= window; ++k) {
    oracle.advance(k * run.sample_interval);
    measurement.sample(k * run.sample_interval, oracle.state());
  }
  const auto totals = block_totals(measurement.series().sums(), measurement.series().tallies());
  Fields fields;
  for (const Quantity& q : derive_quantities(record.scene, measurement.layout(), totals)) {
    if (q.name == "mean_velocity") fields.velocity = q.values;
    if (q.name == "granular_temperature") fields.temperature = q.values;
  }
  return fields;
}

/// What is asked of the replicas of one scene.
struct Comparison {
  std::vector<double> contacts;
  std::vector<Fields> oracle;
};

Comparison compare(const SceneValues& scene, double window, std::size_t contacts) {
  Comparison result{std::vector<double>(scene.replicas()), std::vector<Fields>(scene.replicas())};
  for_each_in_parallel(scene.replicas(), [&](std::size_t r) {
    const Record& record = scene.records()[r];
    result.contacts[r] = same_contacts(record.scene, record.final_state, contacts);
    result.oracle[r] = oracle_fields(record, window);
  });
  return result;
}

/// Oracle less engine in each bin pair, in units of `scale`, one check per pair.
void check_field(const SceneValues& scene, const Comparison& comparison, std::vector<double> Fields::*field,
                 std::string_view quantity, std::string_view symbol, double scale, double margin, Evidence& evidence) {
  for (int bin = 0; bin < scene.half(); ++bin) {
    const std::vector<double> engine = scene.mirrored(quantity, bin);
    const auto mirror = static_cast<std::size_t>(scene.bins() - 1 - bin);
    evidence.checks.push_back(
        {.label =
             fmt::format("{}: {} of bins {} and {}, oracle less engine", scene.name(), symbol, bin + 1, mirror + 1),
         .values = per_replica(scene.replicas(),
                               [&](std::size_t r) {
                                 const std::vector<double>& other = comparison.oracle[r].*field;
                                 return (0.5 * (other[static_cast<std::size_t>(bin)] + other[mirror]) - engine[r]) /
                                        scale;
                               }),
         .band = band_about(0, margin),
         .x = scene.centre(bin)});
  }
}

void plot_temperature(const SceneValues& scene, const Comparison& comparison, Plot& plot) {
  const double e = scene.scene().normal_restitution, beta = scene.scene().wall_tangential_restitution[0];
  const std::string name = fmt::format("e_n {:g}, beta {:g}", e, beta);
  Series engine{.label = name + ", engine", .style = SeriesStyle::line}, oracle{.label = name + ", O(N) search"};
  for (int bin = 0; bin < scene.bins(); ++bin) {
    engine.x.push_back(scene.centre(bin));
    engine.y.push_back(over_replicas(scene.of("granular_temperature", bin)).mean);
    add_point(oracle, scene.centre(bin), per_replica(scene.replicas(), [&](std::size_t r) {
                return comparison.oracle[r].temperature[static_cast<std::size_t>(bin)];
              }));
  }
  plot.series.push_back(std::move(engine));
  plot.series.push_back(std::move(oracle));
}

}  // namespace

Evidence estimate_two_codes(const Claim& claim, Tier tier, const SceneRecords& records) {
  Evidence evidence;
  const double before = process_cpu_seconds();
  const double window = claim.parameter(tier == Tier::quick ? "window_quick" : "window_standard");
  const double contacts = claim.parameter("same_contacts");
  evidence.plot = {.title = "Granular temperature by two codes", .xlabel = "y/W", .ylabel = "T/(g W)", .series = {}};
  for (const auto& [name, replicas] : records) {
    const SceneValues scene(name, replicas);
    const Comparison comparison = compare(scene, window, static_cast<std::size_t>(contacts));
    evidence.checks.push_back({.label = fmt::format("{}: contacts alike from the same state, of {:g}", name, contacts),
                               .values = comparison.contacts,
                               .band = band_about(contacts, 0),
                               .exact = true});
    const std::vector<double> temperature = scene.mean_profile("granular_temperature");
    check_field(scene, comparison, &Fields::velocity, "mean_velocity", "U/U_0",
                over_replicas(scene.of("centre_velocity")).mean, claim.parameter("velocity_margin"), evidence);
    check_field(scene, comparison, &Fields::temperature, "granular_temperature", "T/T_max",
                *std::max_element(temperature.begin(), temperature.end()), claim.tolerance_total(), evidence);
    plot_temperature(scene, comparison, evidence.plot);
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.notes = {
      fmt::format("The O(N) search goes on from the last state of each engine run for a time {:g}; its means over that "
                  "window are compared with the engine's over the measured window before.",
                  window),
      "From the same state both codes execute the same contacts until round-off has grown to the size of the system, "
      "which is checked contact by contact. After that the two trajectories are independent, so the fields differ by "
      "the noise of both windows; starting from a steady state saves the start-up, and nothing else.",
      "T is taken about the instantaneous mean of the bin; the bins y and W - y are averaged."};
  return evidence;
}

}  // namespace gpf
