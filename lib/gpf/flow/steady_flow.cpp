#include "gpf/flow/steady_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gpf/base/cpu_time.hpp"
#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/flow/range.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/methods/all_pairs.hpp"
#include "gpf/methods/contact_watcher.hpp"
#include "gpf/methods/soft_disks.hpp"
#include "gpf/scene/start.hpp"

namespace gpf {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, quantities_of_a_flow> common{
    "area_fraction",       "mean_velocity",       "granular_temperature", "pressure_xx",
    "pressure_yy",         "pressure_xy",         "kurtosis_x",           "kurtosis_y",
    "mean_flow",           "centre_velocity",     "slip_velocity",        "wall_temperature",
    "wall_pressure_lower", "wall_pressure_upper", "wall_shear_lower",     "wall_shear_upper",
};

/// Shows a measurement what a method does.
struct Watch final : ContactWatcher {
  explicit Watch(Measurement& m) : measurement(m) {}
  void on_pair(const PairContact& contact) override { measurement.on_pair(contact); }
  void on_wall(const WallContact& contact) override { measurement.on_wall(contact); }
  Measurement& measurement;
};

/// `advance(t)` moves on to t, `state()` is the state then; `scene` is what the states are states of.
template <class Advance, class StateOf>
std::vector<Quantity> measured(const Scene& scene, const Run& run, Measurement& measurement, Advance&& advance,
                               StateOf&& state) {
  const double first = std::ceil(run.start_up / run.sample_interval),
               samples = std::max(1.0, std::ceil(run.duration / run.sample_interval));
  if (first > 0) advance(first * run.sample_interval);
  measurement.begin(first * run.sample_interval, state());
  for (double k = 1; k <= samples; ++k) {
    const double time = (first + k) * run.sample_interval;
    advance(time);
    measurement.sample(time, state());
  }
  const auto totals = block_totals(measurement.series().sums(), measurement.layout().size());
  std::vector<Quantity> kept;
  for (Quantity& q : derive_quantities(scene, measurement.layout(), totals))
    if (std::find(common.begin(), common.end(), q.name) != common.end()) kept.push_back(std::move(q));
  return kept;
}

std::vector<Quantity> event_driven(const Scene& scene, const Run& run, const State& start) {
  Engine<> engine(scene, start);
  Measurement measurement(scene, run.bins);
  return measured(
      scene, run, measurement, [&](double until) { engine.advance(until, measurement); },
      [&] { return engine.state(); });
}

/// All-pairs and soft disks.
template <class Simulator>
std::vector<Quantity> disks(Simulator simulator, const Scene& scene, const Run& run) {
  Measurement measurement(scene, run.bins);
  Watch watch(measurement);
  simulator.watch(&watch);
  return measured(
      scene, run, measurement, [&](double until) { simulator.advance(until); }, [&] { return simulator.state(); });
}

std::vector<Quantity> monte_carlo(const Scene& scene, const Run& run, const MonteCarloSetting& setting) {
  EnskogMonteCarlo simulator(scene, setting);
  // The simulated particles are the disks of a channel that is so long that there are as many. With cells along the
  // channel their x have the scene's period, which no quantity here knows of.
  Scene long_channel = scene;
  long_channel.particles = static_cast<std::int32_t>(simulator.particles());
  long_channel.length_over_width = scene.length() * long_channel.particles / scene.particles;
  Measurement measurement(long_channel, run.bins);
  Watch watch(measurement);
  simulator.watch(&watch);
  return measured(
      long_channel, run, measurement, [&](double until) { simulator.advance(until); },
      [&] { return simulator.state(); });
}

/// Averages of the profile over the bins, as a measurement would have found them: T about the mean velocity of the bin
/// holds what U varies within it.
std::vector<Quantity> hydrodynamics(const Scene& scene, const Run& run, const ChannelFlowSetting& setting) {
  const ChannelProfile p = channel_flow(scene, setting);
  const double radius = scene.diameter() / 2, cell = (1 - 2 * radius) / setting.cells;
  const double disk_area = std::numbers::pi * square(radius);
  const auto bins = static_cast<std::size_t>(run.bins);
  Quantity nu{"area_fraction", true, {}}, u{"mean_velocity", true, {}}, t{"granular_temperature", true, {}},
      shear{"pressure_xy", true, {}};
  for (std::size_t b = 0; b < bins; ++b) {
    const double lo = static_cast<double>(b) / run.bins, hi = static_cast<double>(b + 1) / run.bins;
    double weight = 0, sum_u = 0, sum_u2 = 0, sum_t = 0, sum_shear = 0, below = 0;
    // Shear: the weight below each height hangs on the lower wall.
    for (std::size_t k = 0; k < p.y.size(); ++k) {
      const double a = std::max(lo, p.y[k] - cell / 2), z = std::min(hi, p.y[k] + cell / 2);
      const double n = p.area_fraction[k] / disk_area;
      if (z > a) {
        weight += n * (z - a);
        sum_u += n * (z - a) * p.mean_velocity[k];
        sum_u2 += n * (z - a) * square(p.mean_velocity[k]);
        sum_t += n * (z - a) * p.granular_temperature[k];
        sum_shear += (z - a) * scene.gravity * (below + n * ((a + z) / 2 - (p.y[k] - cell / 2)));
      }
      below += n * cell;
    }
    sum_shear += std::max(0.0, hi - std::max(lo, 1 - radius)) * scene.gravity * below;
    const double mean = sum_u / weight;
    nu.values.push_back(disk_area * weight * run.bins);
    u.values.push_back(mean);
    t.values.push_back(sum_t / weight + (sum_u2 / weight - square(mean)) / 2);
    shear.values.push_back(sum_shear * run.bins - p.shear_lower);
  }
  const double centre = (u.values[(bins - 1) / 2] + u.values[bins / 2]) / 2;
  const auto one = [](const char* name, double value) { return Quantity{name, false, {value}}; };
  const auto all = [&](const char* name, double value) {
    return Quantity{name, true, std::vector<double>(bins, value)};
  };
  std::vector<Quantity> known{all("pressure_xx", p.pressure),
                              all("pressure_yy", p.pressure),
                              all("kurtosis_x", unknown),
                              all("kurtosis_y", unknown),
                              one("mean_flow", p.mean_flow),
                              one("centre_velocity", centre),
                              one("slip_velocity", (u.values.front() + u.values.back()) / (2 * centre)),
                              one("wall_temperature", (t.values.front() + t.values.back()) / 2),
                              one("wall_pressure_lower", p.pressure),
                              one("wall_pressure_upper", p.pressure),
                              one("wall_shear_lower", p.shear_lower),
                              one("wall_shear_upper", p.shear_upper)};
  for (Quantity* q : {&nu, &u, &t, &shear}) known.push_back(std::move(*q));
  return known;
}

std::vector<Quantity> quantities_by(const Scene& scene, const Run& run, const MethodSetting& setting,
                                    const State* given) {
  if (setting.method == Method::hydrodynamics) return hydrodynamics(scene, run, setting.hydrodynamics);
  if (setting.method == Method::monte_carlo) return monte_carlo(scene, run, setting.monte_carlo);
  const State start = given != nullptr ? *given : start_state(scene);
  if (setting.method == Method::all_pairs) return disks(AllPairs<double>(scene, start), scene, run);
  if (setting.method == Method::soft_disks)
    return disks(SoftDisks(scene, {setting.contact / scene.reference_collision_rate(), setting.steps}, start), scene,
                 run);
  return event_driven(scene, run, start);
}

}  // namespace

SteadyFlow steady_flow(const Scene& scene, const Run& run, const MethodSetting& setting, const State* start) {
  if (setting.method != Method::hydrodynamics && !(run.sample_interval > 0 && run.duration > 0))
    throw InputError("the run has no duration or no sample interval", "the fields are averages over samples",
                     "set duration and sample_interval in [run]");
  const double before = thread_cpu_seconds();
  SteadyFlow flow{quantities_by(scene, run, setting, start)};
  flow.warnings = range_warnings(scene, setting);
  flow.cpu_seconds = thread_cpu_seconds() - before;
  return flow;
}

const std::vector<double>& values_of(const std::vector<Quantity>& quantities, std::string_view name) {
  for (const Quantity& q : quantities)
    if (q.name == name) return q.values;
  throw InputError(fmt::format("there is no quantity '{}'", name), "it is not among those that every method gives",
                   "see gpf/flow/steady_flow.hpp");
}

}  // namespace gpf
