// algo.tc: inelastic collapse without the TC model, none with it, and fields that do not depend on its time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/contacts_at_once.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// A flow from its lattice, for as long as collapse takes there.
struct Case {
  double area_fraction, normal_restitution;
  int disks;
  double time;
};
constexpr Case cases[] = {{0.56, 0.5, 150, 4}, {0.30, 0.5, 450, 8}, {0.05, 0.5, 900, 60}};

Scene scene_of(const Case& c) {
  Scene scene;
  scene.particles = c.disks;
  scene.width_over_diameter = 31;
  scene.length_over_width = std::numbers::pi * c.disks / (4 * c.area_fraction * square(scene.width_over_diameter));
  scene.normal_restitution = c.normal_restitution;
  scene.wall_tangential_restitution = {0.9, 0.9};
  scene.gravity = 1;
  return scene;
}

/// What became of it.
struct Outcome {
  double at_once = 0, time = 0;  ///< contacts at once, and the time when it stopped
};

/// Stops early when `enough` contacts at once have been seen: the point is made, and collapse costs time.
Outcome watch(Scene scene, double tc_time, double until, double enough) {
  scene.tc_time = tc_time;
  Engine<> engine(scene, start_state(scene));
  ContactsAtOnce seen(scene);
  const double step = 1.0 / 64;
  try {
    for (int k = 1; k * step <= until && seen.count() < enough; ++k) engine.advance(k * step, seen);
  } catch (const PhysicsError&) {
    // Collapse that the engine itself refuses to go on from; what was seen until then stands.
  }
  return {seen.count(), engine.time()};
}

void check_collapse(const Claim& claim, Evidence& evidence) {
  const double enough = claim.parameter("contacts_at_once");
  std::vector<Outcome> without(std::size(cases)), with(std::size(cases));
  for_each_in_parallel(std::size(cases), [&](std::size_t k) {
    const Scene scene = scene_of(cases[k]);
    without[k] = watch(scene, 0, cases[k].time, enough);
    with[k] = watch(scene, claim.parameter("tc_time"), cases[k].time, enough);
  });
  for (std::size_t k = 0; k < std::size(cases); ++k) {
    const std::string name = fmt::format("nu {:.2f}, e_n {:g}", cases[k].area_fraction, cases[k].normal_restitution);
    evidence.checks.push_back({.label = name + ", no TC model: contacts of a disk at one time, to the last bit",
                               .values = {without[k].at_once},
                               .band = {enough, INFINITY},
                               .exact = true});
    evidence.checks.push_back(
        {.label = name + ", TC model: the same", .values = {with[k].at_once}, .band = {0, 0}, .exact = true});
    evidence.notes.emplace_back(
        fmt::format("{}, N {}: without the TC model time stood still for a disk before t = {:.2f}; "
                    "with it the run reached its end at t = {:g}.",
                    name, cases[k].disks, without[k].time, with[k].time));
  }
}

/// Scenes that differ in their t_c only, the smallest t_c first.
std::vector<std::vector<SceneValues>> families_of(const SceneRecords& records) {
  std::vector<SceneValues> scenes = by_area_fraction(records);
  std::stable_sort(scenes.begin(), scenes.end(), [](const SceneValues& a, const SceneValues& b) {
    const auto key = [](const Scene& s) {
      return std::tuple(s.area_fraction(), s.normal_restitution, s.particles, s.tc_time);
    };
    return key(a.scene()) < key(b.scene());
  });
  std::vector<std::vector<SceneValues>> families;
  for (SceneValues& scene : scenes) {
    const auto alike = [&](const Scene& s) {
      return s.particles == scene.scene().particles && s.normal_restitution == scene.scene().normal_restitution &&
             s.length_over_width == scene.scene().length_over_width;
    };
    if (families.empty() || !alike(families.back().front().scene())) families.emplace_back();
    families.back().push_back(std::move(scene));
  }
  return families;
}

void check_same(const SceneValues& reference, const SceneValues& scene, std::string_view quantity,
                std::string_view symbol, double scale, double margin, Evidence& evidence) {
  for (int bin = 0; bin < scene.half(); ++bin) {
    const std::vector<double> base = reference.mirrored(quantity, bin), other = scene.mirrored(quantity, bin);
    evidence.checks.push_back({.label = fmt::format("{} less {}: {} of bins {} and {}", scene.name(), reference.name(),
                                                    symbol, bin + 1, scene.bins() - bin),
                               .values = per_replica(std::min(base.size(), other.size()),
                                                     [&](std::size_t r) { return (other[r] - base[r]) / scale; }),
                               .band = band_about(0, margin),
                               .x = scene.centre(bin)});
  }
}

}  // namespace

Evidence estimate_tc(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  const double before = process_cpu_seconds();
  check_collapse(claim, evidence);
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.plot = {
      .title = "Granular temperature for different t_c", .xlabel = "y/W", .ylabel = "T/(g W)", .series = {}};
  for (const std::vector<SceneValues>& family : families_of(records)) {
    const SceneValues& reference = family.front();
    const std::vector<double> temperature = reference.mean_profile("granular_temperature");
    for (const SceneValues& scene : family) {
      Series points{.label = fmt::format("nu {:.2f}, e_n {:g}, t_c {:g}", scene.scene().area_fraction(),
                                         scene.scene().normal_restitution, scene.scene().tc_time)};
      for (int bin = 0; bin < scene.bins(); ++bin)
        add_point(points, scene.centre(bin), scene.of("granular_temperature", bin));
      evidence.plot.series.push_back(std::move(points));
      evidence.notes.push_back(fmt::format("{}: {:.3g} collisions per disk and time.", scene.name(),
                                           over_replicas(scene.of("collision_rate")).mean));
      if (&scene == &reference) continue;
      check_same(reference, scene, "mean_velocity", "U/U_0", over_replicas(reference.of("centre_velocity")).mean,
                 claim.parameter("velocity_margin"), evidence);
      check_same(reference, scene, "granular_temperature", "T/T_max",
                 *std::max_element(temperature.begin(), temperature.end()), claim.tolerance_total(), evidence);
    }
  }
  evidence.notes.emplace_back(
      "Collision rates are no result in this sense: the shorter t_c, the more of the collisions of a cluster are "
      "inelastic ones that hardly move anything, and the rate grows by factors where the fields stay.");
  return evidence;
}

}  // namespace gpf
