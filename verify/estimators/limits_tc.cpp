// limits.tc: the window of t_c in which the TC model leaves a flow as it is.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/contacts_at_once.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/limit_scenes.hpp"
#include "verify/estimators/onset.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// What is compared: means over the measured window of one run.
struct Flow {
  double velocity = 0, temperature = 0, density = 0,
         loss = 0;     ///< U_0, T over the width, nu at the centre, loss in pairs
  double rate = 0;     ///< contacts per disk and time
  double at_once = 0;  ///< contacts of a disk at the time of its last one
};
struct Reading {
  const char* name;
  double Flow::*value;
};
constexpr std::array readings{Reading{"U_0", &Flow::velocity}, Reading{"T", &Flow::temperature},
                              Reading{"nu at the centre", &Flow::density}, Reading{"loss in pairs", &Flow::loss}};

/// Passes contacts on to two observers.
struct Both {
  Measurement& measurement;
  ContactsAtOnce& at_once;
  void on_pair(const PairContact& c) { measurement.on_pair(c), at_once.on_pair(c); }
  void on_wall(const WallContact& c) { measurement.on_wall(c), at_once.on_wall(c); }
};

/// Of a run that collapses only the contacts at once are told, and the rest is NaN.
Flow flow_of(const Scene& scene, double start_up, double duration) {
  constexpr int bins = 6;
  constexpr double interval = 0.25;
  Engine<> engine(scene, start_state(scene));
  Measurement measurement(scene, bins);
  ContactsAtOnce at_once(scene);
  Both both{measurement, at_once};
  try {
    engine.advance(start_up, both);
    measurement.begin(start_up, engine.state());
    for (int k = 1; k * interval <= duration; ++k) {
      engine.advance(start_up + k * interval, both);
      measurement.sample(start_up + k * interval, engine.state());
    }
  } catch (const PhysicsError&) {
    return {NAN, NAN, NAN, NAN, NAN, at_once.count()};
  }
  const auto totals = block_totals(measurement.series().sums(), measurement.series().tallies());
  Flow flow{.at_once = at_once.count()};
  for (const Quantity& q : derive_quantities(scene, measurement.layout(), totals)) {
    if (q.name == "centre_velocity") flow.velocity = q.values[0];
    if (q.name == "granular_temperature")
      for (const double t : q.values) flow.temperature += t / bins;
    if (q.name == "area_fraction") flow.density = 0.5 * (q.values[bins / 2 - 1] + q.values[bins / 2]);
    if (q.name == "pair_loss") flow.loss = q.values[0];
    if (q.name == "collision_rate") flow.rate = q.values[0];
  }
  return flow;
}

/// Flows that differ in t_c and seed only.
class Family {
 public:
  Family(const Scene& scene, std::vector<double> times, std::size_t seeds, double start_up, double duration)
      : scene_(scene), times_(std::move(times)), seeds_(seeds), flows_(times_.size() * seeds) {
    for_each_in_parallel(flows_.size(), [&](std::size_t job) {
      Scene one = scene_;
      one.tc_time = times_[job / seeds_];
      one.seed = job % seeds_ + 1;
      flows_[job] = flow_of(one, start_up, duration);
    });
  }

  [[nodiscard]] std::string name() const {
    return fmt::format("e_n {:.1f}, nu {:.2f}", scene_.normal_restitution, scene_.area_fraction());
  }
  [[nodiscard]] std::size_t size() const { return times_.size(); }
  [[nodiscard]] double time(std::size_t k) const { return times_[k]; }
  [[nodiscard]] std::size_t index_of(double time) const {
    return static_cast<std::size_t>(
        std::min_element(times_.begin(), times_.end(),
                         [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); }) -
        times_.begin());
  }
  [[nodiscard]] std::vector<double> values(std::size_t k, double Flow::*value) const {
    return per_replica(seeds_, [&](std::size_t seed) { return flows_[k * seeds_ + seed].*value; });
  }
  /// omega t_c, omega the collision rate of a disk in the flow itself.
  [[nodiscard]] double omega_tc(std::size_t k) const { return times_[k] * over_replicas(values(k, &Flow::rate)).mean; }
  /// Relative change from the flow at index `from`, seed by seed.
  [[nodiscard]] std::vector<double> change(std::size_t k, std::size_t from, double Flow::*value) const {
    const std::vector<double> a = values(k, value), b = values(from, value);
    return per_replica(seeds_, [&](std::size_t seed) { return a[seed] / b[seed] - 1; });
  }
  [[nodiscard]] double at_once(std::size_t k) const {
    double sum = 0;
    for (const double count : values(k, &Flow::at_once)) sum += count;
    return sum;
  }
  [[nodiscard]] std::size_t seeds() const { return seeds_; }

 private:
  Scene scene_;
  std::vector<double> times_;
  std::size_t seeds_;
  std::vector<Flow> flows_;
};

void check_window(const Claim& claim, const Family& family, std::size_t reference, Evidence& evidence) {
  for (std::size_t k = 0; k < family.size(); ++k) {
    if (k == reference || family.time(k) < claim.parameter("lower_end") ||
        family.omega_tc(k) > claim.parameter("upper_end_omega_tc"))
      continue;
    for (const Reading& reading : readings)
      evidence.checks.push_back(
          {.label = fmt::format("{}, t_c {:.0e}: change of {}", family.name(), family.time(k), reading.name),
           .values = family.change(k, reference, reading.value),
           .band = band_about(0, claim.tolerance_total()),
           .x = family.time(k)});
  }
}

/// omega t_c at which U_0 has fallen by the tolerance, seed by seed.
void check_upper_end(const Claim& claim, const Family& family, std::size_t reference, Evidence& evidence) {
  std::vector<double> abscissa;
  std::vector<std::vector<double>> change;
  for (std::size_t k = reference; k < family.size(); ++k) {
    abscissa.push_back(std::log10(family.omega_tc(k)));
    change.push_back(family.change(k, reference, &Flow::velocity));
  }
  const std::vector<double> onsets = per_replica(family.seeds(), [&](std::size_t seed) {
    std::vector<double> fall;
    for (const std::vector<double>& c : change) fall.push_back(-c[seed]);
    return std::pow(10, onset(abscissa, fall, claim.tolerance_total()));
  });
  evidence.checks.push_back({.label = fmt::format("{}: omega t_c where U_0 has fallen by {:g} %", family.name(),
                                                  100 * claim.tolerance_total()),
                             .values = onsets,
                             .band = {claim.parameter("upper_end_omega_tc"), claim.parameter("onset_omega_tc")}});
  for (std::size_t k = 0; k < family.size(); ++k) {
    if (family.omega_tc(k) > claim.parameter("onset_omega_tc"))
      evidence.checks.push_back(
          {.label = fmt::format("{}, omega t_c {:.2g}: change of U_0", family.name(), family.omega_tc(k)),
           .values = family.change(k, reference, &Flow::velocity),
           .band = {-1, -claim.tolerance_total()},
           .x = family.time(k)});
    if (family.omega_tc(k) > 1)
      evidence.checks.push_back(
          {.label = fmt::format("{}, omega t_c {:.2g}: change of the loss in pairs", family.name(), family.omega_tc(k)),
           .values = family.change(k, reference, &Flow::loss),
           .band = {-1, -0.99},
           .exact = true,
           .x = family.time(k)});
  }
}

/// Contacts of a disk at the time of its last one: the cluster has come to the end of a double.
void check_lower_end(const Claim& claim, const Family& family, Evidence& evidence) {
  for (std::size_t k = 0; k < family.size(); ++k) {
    const bool below = family.time(k)<1.01 * claim.parameter("end_of_a_double"), inside = family.time(k)> 0.99 *
                       claim.parameter("lower_end");
    if (!below && !inside) continue;
    evidence.checks.push_back({.label = fmt::format("{}, t_c {:.0e}: contacts of a disk at one time, all seeds",
                                                    family.name(), family.time(k)),
                               .values = {family.at_once(k)},
                               .band = below ? Interval{1, INFINITY} : Interval{0, 0},
                               .exact = true,
                               .x = family.time(k)});
  }
}

/// Below the boundary of collapse: U_0 goes on rising with t_c, over decades in which TC touches few contacts.
void check_no_window(const Claim& claim, const Family& family, Evidence& evidence) {
  const std::size_t small = family.index_of(1e-9), large = family.index_of(1e-5);
  evidence.checks.push_back(
      {.label = fmt::format("{}: change of U_0 from t_c {:.0e} to {:.0e} (omega t_c {:.1g})", family.name(),
                            family.time(small), family.time(large), family.omega_tc(large)),
       .values = family.change(large, small, &Flow::velocity),
       .band = {claim.tolerance_total(), INFINITY}});
}

void describe(const Family& family, std::size_t reference, Evidence& evidence) {
  Series points{.label = family.name()};
  std::string rates;
  for (std::size_t k = 0; k < family.size(); ++k) {
    add_point(points, family.omega_tc(k), family.change(k, reference, &Flow::velocity));
    rates += fmt::format("{}{:.0e}: {:.3g}", k == 0 ? "" : ", ", family.time(k),
                         over_replicas(family.values(k, &Flow::rate)).mean);
  }
  evidence.plot.series.push_back(std::move(points));
  evidence.notes.push_back(fmt::format("{}: contacts per disk and time by t_c: {}.", family.name(), rates));
}

}  // namespace

Evidence estimate_limits_tc(const Claim& claim, Tier tier, const SceneRecords&) {
  const double before = process_cpu_seconds();
  const bool quick = tier == Tier::quick;
  const auto seeds = static_cast<std::size_t>(claim.parameter(quick ? "seeds_quick" : "seeds_standard"));
  const double start_up = claim.parameter("start_up"), duration = claim.parameter("duration"),
               reference_time = claim.parameter("reference");
  constexpr int disks = 200;
  constexpr double width = 15;

  Evidence evidence;
  const double tolerance = claim.tolerance_total();
  evidence.plot = {.title = "Change of U_0 with the time of the TC model",
                   .xlabel = "omega t_c",
                   .ylabel = "U_0(t_c)/U_0(reference) - 1",
                   .logx = true,
                   .series = {{.label = "no change",
                               .style = SeriesStyle::band,
                               .x = {1e-14, 100},
                               .lower = {-tolerance, -tolerance},
                               .upper = {tolerance, tolerance}}}};
  const std::vector<double> mild =
      quick ? std::vector<double>{1e-15, 1e-10, 1e-8, 1e-4, 1e-3, 1e-2, 1e-1}
            : std::vector<double>{1e-15, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 1e-1};
  const Family window(limit_channel(disks, width, 0.30, 0.6), mild, seeds, start_up, duration);
  check_window(claim, window, window.index_of(reference_time), evidence);
  check_upper_end(claim, window, window.index_of(reference_time), evidence);
  check_lower_end(claim, window, evidence);
  describe(window, window.index_of(reference_time), evidence);
  if (!quick) {
    const Family dense(limit_channel(disks, width, 0.50, 0.8), {1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2},
                       seeds, start_up, duration);
    check_window(claim, dense, dense.index_of(reference_time), evidence);
    check_upper_end(claim, dense, dense.index_of(reference_time), evidence);
    describe(dense, dense.index_of(reference_time), evidence);
    const Family strong(limit_channel(disks, width, 0.30, 0.3), {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1},
                        seeds, start_up, duration);
    check_no_window(claim, strong, evidence);
    describe(strong, strong.index_of(reference_time), evidence);
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.notes.emplace_back(
      "U_0: velocity at the centre plane; T: about the instantaneous mean of a bin, mean over the width; loss: energy "
      "lost in pairs per time; omega: contacts per disk and time of the flow itself.");
  return evidence;
}

}  // namespace gpf
