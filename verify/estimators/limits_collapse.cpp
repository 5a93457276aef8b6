// limits.collapse: where in the plane of e_n and nu a flow without the TC model comes to a stop.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/collapse_boundary.hpp"
#include "verify/estimators/contacts_at_once.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/limit_scenes.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

constexpr std::array area_fractions{0.05, 0.10, 0.20, 0.35, 0.50, 0.70};
constexpr double first_restitution = 0.1, restitution_step = 0.1;
constexpr std::size_t restitutions = 9;
double restitution_at(std::size_t k) { return first_restitution + restitution_step * static_cast<double>(k); }

/// So many contacts of a disk at one time, to the last bit, are a collapse.
constexpr double enough_at_once = 10;

/// When a flow from its lattice collapsed, if it did up to time `until`.
std::optional<double> collapse_time(const Scene& scene, double until) {
  Engine<> engine(scene, start_state(scene));
  ContactsAtOnce seen(scene);
  bool refused = false;
  const double step = 1.0 / 64;
  try {
    for (int k = 1; k * step <= until && seen.count() < enough_at_once; ++k) engine.advance(k * step, seen);
  } catch (const PhysicsError&) {
    refused = true;  // all disks together no longer advance in time
  }
  if (refused || seen.count() >= enough_at_once) return engine.time();
  return {};
}

/// Times of collapse by area fraction, restitution and seed.
class Map {
 public:
  Map(std::size_t seeds, int disks, double width, double until, std::vector<double> densities)
      : densities_(std::move(densities)), seeds_(seeds), times_(densities_.size() * restitutions * seeds) {
    for_each_in_parallel(times_.size(), [&](std::size_t job) {
      const std::size_t seed = job % seeds_, e = job / seeds_ % restitutions, nu = job / seeds_ / restitutions;
      Scene scene = limit_channel(disks, width, densities_[nu], restitution_at(e));
      scene.seed = seed + 1;
      times_[job] = collapse_time(scene, until);
    });
  }

  [[nodiscard]] const std::vector<double>& densities() const { return densities_; }
  [[nodiscard]] std::size_t seeds() const { return seeds_; }
  [[nodiscard]] const std::optional<double>& at(std::size_t nu, std::size_t e, std::size_t seed) const {
    return times_[(nu * restitutions + e) * seeds_ + seed];
  }
  /// How many of the seeds collapsed.
  [[nodiscard]] double collapses(std::size_t nu, std::size_t e) const {
    double count = 0;
    for (std::size_t seed = 0; seed < seeds_; ++seed) count += at(nu, e, seed) ? 1 : 0;
    return count;
  }
  /// The boundary e_c of each seed, when the runs are given `until`.
  [[nodiscard]] std::vector<double> boundary(std::size_t nu, double until) const {
    return per_replica(seeds_, [&](std::size_t seed) {
      std::vector<bool> collapsed;
      for (std::size_t e = 0; e < restitutions; ++e) collapsed.push_back(at(nu, e, seed).value_or(2 * until) <= until);
      return collapse_boundary(first_restitution, restitution_step, collapsed);
    });
  }

 private:
  std::vector<double> densities_;
  std::size_t seeds_;
  std::vector<std::optional<double>> times_;
};

void check_ends(const Claim& claim, const Map& map, Evidence& evidence) {
  const auto seeds = static_cast<double>(map.seeds());
  for (std::size_t nu = 0; nu < map.densities().size(); ++nu)
    for (std::size_t e = 0; e < restitutions; ++e) {
      const bool always =
          restitution_at(e)<claim.parameter("always_to") + 1e-6, never = restitution_at(e)> claim.parameter(
              "never_from") -
          1e-6;
      if (!always && !never) continue;
      const double wanted = always ? seeds : 0;
      evidence.checks.push_back({.label = fmt::format("nu {:.2f}, e_n {:.1f}: runs that collapse, of {:g}",
                                                      map.densities()[nu], restitution_at(e), seeds),
                                 .values = {map.collapses(nu, e)},
                                 .band = {wanted, wanted},
                                 .exact = true,
                                 .x = map.densities()[nu]});
    }
}

/// The largest restitution at which any run collapsed; 0 when none did.
double largest_collapse(const Map& map) {
  double largest = 0;
  for (std::size_t nu = 0; nu < map.densities().size(); ++nu)
    for (std::size_t e = 0; e < restitutions; ++e)
      if (map.collapses(nu, e) > 0) largest = std::max(largest, restitution_at(e));
  return largest;
}

/// The boundary against the one `apart` densities below.
void check_rise(const Map& map, std::size_t apart, double until, Evidence& evidence) {
  for (std::size_t nu = apart; nu < map.densities().size(); ++nu)
    evidence.checks.push_back({.label = fmt::format("e_c at nu {:.2f} less e_c at nu {:.2f}", map.densities()[nu],
                                                    map.densities()[nu - apart]),
                               .values = difference(map.boundary(nu, until), map.boundary(nu - apart, until)),
                               .band = {0, INFINITY},
                               .x = map.densities()[nu]});
}

void draw(const Map& map, double until, Evidence& evidence) {
  Series all{.label = "every run collapses"}, some{.label = "some do"}, none{.label = "none does"};
  Series boundary{.style = SeriesStyle::line},
      early{.label = fmt::format("e_c up to t = {:g}", until / 8), .style = SeriesStyle::line},
      bars{.label = fmt::format("e_c up to t = {:g}, standard error", until)};
  for (std::size_t nu = 0; nu < map.densities().size(); ++nu) {
    const double x = map.densities()[nu];
    for (std::size_t e = 0; e < restitutions; ++e) {
      const double count = map.collapses(nu, e);
      Series& series = count == 0 ? none : count < static_cast<double>(map.seeds()) ? some : all;
      series.x.push_back(x), series.y.push_back(restitution_at(e));
    }
    const std::vector<double> late = map.boundary(nu, until), soon = map.boundary(nu, until / 8);
    boundary.x.push_back(x), boundary.y.push_back(over_replicas(late).mean);
    early.x.push_back(x), early.y.push_back(over_replicas(soon).mean);
    add_point(bars, x, late);
    evidence.notes.push_back(
        fmt::format("nu {:.2f}: e_c = {:.3f} +- {:.3f}; {:.3f} +- {:.3f} for collapses up to t = {:g}.", x,
                    over_replicas(late).mean, over_replicas(late).error, over_replicas(soon).mean,
                    over_replicas(soon).error, until / 8));
  }
  evidence.plot = {.title = "Inelastic collapse without the TC model",
                   .xlabel = "area fraction nu",
                   .ylabel = "e_n",
                   .xrange = {{0, 0.75}},
                   .yrange = {{0, 1}},
                   .series = {}};
  for (Series* series : {&all, &some, &none, &boundary, &bars, &early})
    if (!series->x.empty()) evidence.plot.series.push_back(std::move(*series));
}

/// With the TC model: part of the time that a flow ran, and of all contacts those at the time of a disk's last one.
struct WithTc {
  double reached = 0, share = 0;
};

WithTc watch_with_tc(const Scene& scene, double until) {
  Engine<> engine(scene, start_state(scene));
  ContactsAtOnce seen(scene);
  try {
    engine.advance(until, seen);
  } catch (const PhysicsError&) {
    // The time that it reached tells.
  }
  return {engine.time() / until, seen.count() / static_cast<double>(engine.counts().pair_contacts)};
}

/// Strongly dissipative flows of the same kind.
void check_tc(const Claim& claim, std::size_t seeds, const std::vector<double>& densities, Evidence& evidence) {
  constexpr std::array strong{0.1, 0.3, 0.5};
  const double until = claim.parameter("horizon_with_tc"), disks = claim.parameter("disks");
  std::vector<WithTc> outcomes(densities.size() * strong.size() * seeds);
  for_each_in_parallel(outcomes.size(), [&](std::size_t job) {
    Scene scene = limit_channel(static_cast<int>(disks), claim.parameter("width_over_diameter"),
                                densities[job / seeds / strong.size()], strong[job / seeds % strong.size()]);
    scene.seed = job % seeds + 1;
    scene.tc_time = claim.parameter("tc_per_mean_free_time") / scene.reference_collision_rate();
    outcomes[job] = watch_with_tc(scene, until);
  });
  for (std::size_t k = 0; k < densities.size() * strong.size(); ++k) {
    const double nu = densities[k / strong.size()];
    const auto add = [&](const char* what, double WithTc::*value, Interval band) {
      evidence.checks.push_back(
          {.label = fmt::format("nu {:.2f}, e_n {:.1f}, TC model: {}", nu, strong[k % strong.size()], what),
           .values = per_replica(seeds, [&](std::size_t seed) { return outcomes[k * seeds + seed].*value; }),
           .band = band,
           .exact = true,
           .x = nu});
    };
    add("part of the time that it ran", &WithTc::reached, {1, 1});
    add("share of contacts at the time of a disk's last", &WithTc::share, {0, claim.parameter("share_at_once")});
  }
}

/// Whether three disks on a line end as one: the outer two close in with speed 1, the middle one moves with `middle`.
bool three_become_one(double restitution, double middle) {
  Scene scene;
  scene.particles = 3;
  scene.width_over_diameter = 7.4;
  scene.length_over_width = 2.1;
  scene.normal_restitution = restitution;
  Engine<> engine(scene, {{{0.5, 0.5}, {0.9, 0.5}, {1.3, 0.5}}, {{1, 0}, {middle, 0}, {-1, 0}}});
  engine.advance(1);
  const State end = engine.state();
  return std::abs(end.velocity[2].x - end.velocity[0].x) < 0x1p-52;
}

/// The largest restitution at which they do, by bisection.
double boundary_of_three(double middle) {
  double collapses = 0.05, does_not = 0.10;
  while (does_not - collapses > 1e-6) {
    const double e = 0.5 * (collapses + does_not);
    (three_become_one(e, middle) ? collapses : does_not) = e;
  }
  return collapses;
}

void check_three(const Claim& claim, Evidence& evidence) {
  constexpr int starts = 16;
  std::vector<double> values;
  for (int k = 1; k <= starts; ++k) values.push_back(boundary_of_three((2.0 * k - starts - 1) / (starts + 1)));
  const double exact = 7 - 4 * std::sqrt(3.0);
  evidence.checks.push_back(
      {.label = fmt::format("three disks on a line: largest e_n that collapses, {} starts", starts),
       .values = values,
       .band = {exact, exact + claim.tolerance_total()},
       .exact = true,
       .reference = exact});
}

}  // namespace

Evidence estimate_limits_collapse(const Claim& claim, Tier tier, const SceneRecords&) {
  const double before = process_cpu_seconds();
  const bool quick = tier == Tier::quick;
  const double until = claim.parameter("horizon"), width = claim.parameter("width_over_diameter");
  const auto disks = static_cast<int>(claim.parameter("disks"));
  const auto seeds = static_cast<std::size_t>(claim.parameter(quick ? "seeds_quick" : "seeds_standard"));
  const std::vector<double> densities(area_fractions.begin(), area_fractions.end());
  const Map map(seeds, disks, width, until, densities);

  Evidence evidence;
  check_three(claim, evidence);
  check_ends(claim, map, evidence);
  check_rise(map, quick ? densities.size() - 1 : 2, until, evidence);
  draw(map, until, evidence);
  check_tc(claim, quick ? 1 : 4, quick ? std::vector<double>{0.05, 0.35} : densities, evidence);
  if (!quick) {
    constexpr double dilute = 0.20;
    const Map few(seeds, disks / 2, width, until, {dilute}), many(seeds, disks * 4, width, until, {dilute});
    const std::vector<double> less = few.boundary(0, until), more = many.boundary(0, until);
    evidence.checks.push_back(
        {.label = fmt::format("nu {:.2f}: e_c of {} disks less e_c of {}", dilute, disks * 4, disks / 2),
         .values = difference(more, less),
         .band = {0, INFINITY},
         .x = dilute});
    evidence.notes.push_back(fmt::format("nu {:.2f}: e_c = {:.3f} +- {:.3f} with {} disks, {:.3f} +- {:.3f} with {}.",
                                         dilute, over_replicas(less).mean, over_replicas(less).error, disks / 2,
                                         over_replicas(more).mean, over_replicas(more).error, disks * 4));
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.notes.push_back(
      fmt::format("The boundary is one of a horizon: collapse is a matter of waiting, the longer the more dilute the "
                  "flow. The largest e_n at which any run collapsed is {:.1f}.",
                  largest_collapse(map)));
  return evidence;
}

}  // namespace gpf
