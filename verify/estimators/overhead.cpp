// algo.overhead and algo.cost: events that the engine examines in vain, and the work of its queues, against the number
// of disks.
#include <fmt/format.h>

#include <cmath>

#include "gpf/event/engine.hpp"
#include "gpf/event/heap_queue.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// A family of scenes that differ in the number of disks only.
struct Family {
  const char* name;
  Geometry geometry;
  double area_fraction, normal_restitution;
};
constexpr Family families[] = {{"elastic, periodic, nu 0.05", Geometry::periodic, 0.05, 1},
                               {"elastic, periodic, nu 0.30", Geometry::periodic, 0.30, 1},
                               {"elastic, periodic, nu 0.70", Geometry::periodic, 0.70, 1},
                               {"channel, e_n 0.9, nu 0.30", Geometry::channel, 0.30, 0.9},
                               {"channel, e_n 0.9, nu 0.56", Geometry::channel, 0.56, 0.9}};

/// A box as long as it is wide.
Scene scene_of(const Family& family, int disks) {
  Scene scene;
  scene.geometry = family.geometry;
  scene.particles = disks;
  scene.length_over_width = 1;
  scene.width_over_diameter = std::sqrt(std::numbers::pi * disks / (4 * family.area_fraction));
  scene.normal_restitution = family.normal_restitution;
  if (family.geometry == Geometry::channel) {
    scene.gravity = 1;
    scene.wall_tangential_restitution = {0.9, 0.9};
    scene.tc_time = 1e-4 / scene.reference_collision_rate();
  }
  return scene;
}

/// Share of the examined events that were contacts whose partner had changed course, over `collisions` per disk after
/// as many to forget the lattice.
double overhead(const Scene& scene, double collisions) {
  Engine<> engine(scene, start_state(scene));
  const double span = collisions / scene.reference_collision_rate();
  engine.advance(span);
  const EventCounts before = engine.counts();
  engine.advance(2 * span);
  const EventCounts& after = engine.counts();
  return static_cast<double>(after.stale - before.stale) / static_cast<double>(after.examined() - before.examined());
}

/// Counts the steps of the queues of one thread.
struct StepMeter {
  static thread_local std::uint64_t steps;
  static void step() { ++steps; }
};
thread_local std::uint64_t StepMeter::steps = 0;

/// Steps of the queue per pair collision, in the second half of a run.
template <class Queue>
double queue_steps(const Scene& scene, double collisions) {
  Engine<Queue> engine(scene, start_state(scene));
  const double span = collisions / scene.reference_collision_rate();
  engine.advance(span);
  const std::uint64_t contacts = engine.counts().pair_contacts;
  StepMeter::steps = 0;
  engine.advance(2 * span);
  return static_cast<double>(StepMeter::steps) / static_cast<double>(engine.counts().pair_contacts - contacts);
}

/// 100, 1000, ... up to the largest number that the tier allows.
std::vector<int> sizes_of(const Claim& claim, Tier tier) {
  const double largest = claim.parameter(tier == Tier::quick ? "largest_disks_quick" : "largest_disks_standard");
  std::vector<int> sizes;
  for (double disks = 100; disks <= 1.01 * largest; disks *= 10) sizes.push_back(static_cast<int>(disks));
  return sizes;
}

/// Slope of log(y) against log(x), least squares.
double log_slope(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double lx = std::log(x[k]), ly = std::log(y[k]);
    sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
  }
  const auto n = static_cast<double>(x.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

Evidence estimate_overhead(const Claim& claim, Tier tier, const SceneRecords&) {
  const double before = process_cpu_seconds();
  const double limit = claim.parameter("limit"), growth = claim.parameter("growth_per_decade");
  const std::vector<int> sizes = sizes_of(claim, tier);
  const std::size_t count = std::size(families) * sizes.size();
  std::vector<double> shares(count);
  for_each_in_parallel(count, [&](std::size_t k) {
    const std::size_t job = count - 1 - k;  // the largest first, so that no long one is left alone at the end
    const int disks = sizes[job / std::size(families)];
    shares[job] =
        overhead(scene_of(families[job % std::size(families)], disks), claim.parameter("collisions_per_disk"));
  });

  Evidence evidence;
  evidence.plot = {.title = "Events examined and not executed",
                   .xlabel = "number of disks",
                   .ylabel = "share of all events examined",
                   .logx = true,
                   .series = {{.label = "claimed",
                               .style = SeriesStyle::band,
                               .x = {static_cast<double>(sizes.front()), static_cast<double>(sizes.back())},
                               .lower = {0, 0},
                               .upper = {limit, limit}}}};
  for (std::size_t f = 0; f < std::size(families); ++f) {
    Series points{.label = families[f].name};
    for (std::size_t s = 0; s < sizes.size(); ++s) {
      const double share = shares[s * std::size(families) + f];
      points.x.push_back(sizes[s]);
      points.y.push_back(share);
      evidence.checks.push_back({.label = fmt::format("{}, N {}: share of stale events", families[f].name, sizes[s]),
                                 .values = {share},
                                 .band = {0, limit},
                                 .exact = true,
                                 .x = static_cast<double>(sizes[s])});
    }
    // From N = 1000: a box of a hundred disks is a few cells wide, and its share is its own.
    const double decades = static_cast<double>(sizes.size()) - 2;
    if (decades > 0)
      evidence.checks.push_back(
          {.label = fmt::format("{}: growth of the share per decade of N from 1000 on", families[f].name),
           .values = {(points.y.back() - points.y[1]) / decades},
           .band = {-1, growth},
           .exact = true});
    evidence.plot.series.push_back(std::move(points));
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.notes = {
      "Examined are contacts, wall contacts, cell crossings and stale contacts; a stale one was scheduled with a "
      "partner "
      "that collided with another before, and leads to a new prediction only.",
      "At the start of each epoch, 16 to 32 mean free times long in a periodic box, all disks are predicted anew: one "
      "prediction more for every 16 to 32 that contacts cause, and no event.",
      "Boxes as long as they are wide. The counts are those of the calendar queue; the heap executes the same events "
      "in "
      "the same order."};
  return evidence;
}

Evidence estimate_cost(const Claim& claim, Tier tier, const SceneRecords&) {
  const double before = process_cpu_seconds();
  const std::vector<int> sizes = sizes_of(claim, tier);
  const std::size_t count = std::size(families) * sizes.size();
  std::vector<double> heap(count), calendar(count);
  for_each_in_parallel(count, [&](std::size_t k) {
    const std::size_t job = count - 1 - k;  // the largest first
    const Scene scene = scene_of(families[job % std::size(families)], sizes[job / std::size(families)]);
    heap[job] = queue_steps<BasicHeapQueue<StepMeter>>(scene, claim.parameter("collisions_per_disk"));
    calendar[job] = queue_steps<BasicCalendarQueue<StepMeter>>(scene, claim.parameter("collisions_per_disk"));
  });

  Evidence evidence;
  evidence.plot = {.title = "Steps of the event queue",
                   .xlabel = "number of disks",
                   .ylabel = "entries looked at per pair collision",
                   .logx = true,
                   .series = {}};
  for (std::size_t f = 0; f < std::size(families); ++f) {
    Series heaps{.label = fmt::format("heap, {}", families[f].name)},
        calendars{.label = fmt::format("calendar, {}", families[f].name)};
    std::vector<double> over_logarithm;
    for (std::size_t s = 0; s < sizes.size(); ++s) {
      const std::size_t k = s * std::size(families) + f;
      heaps.x.push_back(sizes[s]), heaps.y.push_back(heap[k]);
      calendars.x.push_back(sizes[s]), calendars.y.push_back(calendar[k]);
      over_logarithm.push_back(heap[k] / std::log2(static_cast<double>(sizes[s])));
    }
    const auto check = [&](const char* what, const std::vector<double>& x, const std::vector<double>& y) {
      evidence.checks.push_back({.label = fmt::format("{}: exponent in N of the {}", families[f].name, what),
                                 .values = {log_slope(x, y)},
                                 .band = {-1, claim.tolerance_total()},
                                 .exact = true});
    };
    check("heap's steps per collision over log2 N", heaps.x, over_logarithm);
    check("calendar's steps per collision", calendars.x, calendars.y);
    evidence.notes.push_back(
        fmt::format("{}: heap {:.1f} steps per collision at N {} and {:.1f} at N {}; calendar "
                    "{:.1f} and {:.1f}.",
                    families[f].name, heaps.y.front(), sizes.front(), heaps.y.back(), sizes.back(), calendars.y.front(),
                    calendars.y.back()));
    evidence.plot.series.push_back(std::move(heaps));
    evidence.plot.series.push_back(std::move(calendars));
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.notes.emplace_back(
      "A step is a comparison of two entries of the heap, or a day or an entry of the calendar that is looked at; they "
      "are counted, not timed, so the answer is the same on every machine. What else a collision costs does not depend "
      "on N but through the memory: see algo.overhead for the events, tests/performance for nanoseconds.");
  return evidence;
}

}  // namespace gpf
