// algo.nomax: how dense a start each lattice allows, and that the engine can start there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/lattice.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

struct Case {
  const char* name;
  Geometry geometry;
  Lattice lattice;
  int disks;
  double width_over_diameter, area_fraction;
};
/// The thesis' channel, and channels and boxes whose width suits whole rows: k triangular rows at contact fill 1 + (k -
/// 1) sqrt(3)/2 diameters between walls (k = 36: 31.311), k sqrt(3)/2 round a period (k = 36: 31.177).
constexpr Case cases[] = {
    {"square, channel, W/d 31", Geometry::channel, Lattice::square, 930, 31, 0.78},
    {"square, periodic, W/d 32.1", Geometry::periodic, Lattice::square, 1024, 32.1, 0.78},
    {"triangular, channel, W/d 31", Geometry::channel, Lattice::triangular, 900, 31, 0.875},
    {"triangular, channel, W/d 31.32", Geometry::channel, Lattice::triangular, 900, 31.32, 0.90},
    {"triangular, periodic, W/d 31.2", Geometry::periodic, Lattice::triangular, 900, 31.2, 0.90},
};

Scene scene_of(const Case& c) {
  Scene scene;
  scene.geometry = c.geometry;
  scene.lattice = c.lattice;
  scene.particles = c.disks;
  scene.width_over_diameter = c.width_over_diameter;
  scene.length_over_width = std::numbers::pi * c.disks / (4 * c.area_fraction * square(c.width_over_diameter));
  scene.normal_restitution = 0.99;
  if (c.geometry == Geometry::channel) {
    scene.gravity = 1;
    scene.wall_tangential_restitution = {0.9, 0.9};
  }
  return scene;
}

/// Least distance of two centres, periodic images included, and of a centre from its mirror image in a wall; in d.
double least_distance(const Scene& scene, const State& state) {
  double least = INFINITY;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const Vec2 a = state.position[i];
    if (scene.geometry == Geometry::channel) least = std::min({least, 2 * a.y, 2 * (1 - a.y)});
    for (std::size_t j = i + 1; j < state.position.size(); ++j) {
      Vec2 r = state.position[j] - a;
      r.x -= scene.length() * std::round(r.x / scene.length());
      if (scene.geometry == Geometry::periodic) r.y -= std::round(r.y);
      least = std::min(least, std::sqrt(dot(r, r)));
    }
  }
  return least / scene.diameter();
}

/// Collisions per disk that the engine executes from the start; fewer than asked for when it finds an overlap.
double collisions_from(const Scene& scene, const State& start, double wanted) {
  try {
    Engine<> engine(scene, start);
    const auto done = [&] { return 2 * static_cast<double>(engine.counts().pair_contacts) / scene.particles; };
    const double step = engine.epoch_length() / 64;
    for (int k = 1; done() < wanted; ++k) engine.advance(k * step);
    return done();
  } catch (const PhysicsError&) {
    return 0;
  }
}

}  // namespace

Evidence estimate_lattices(const Claim& claim, Tier, const SceneRecords&) {
  Evidence evidence;
  const double before = process_cpu_seconds(), wanted = claim.parameter("collisions_per_disk");
  Series reached{.label = "densest start of this lattice"}, claimed{.label = "started from here"};
  for (std::size_t k = 0; k < std::size(cases); ++k) {
    const Scene scene = scene_of(cases[k]);
    const double most = largest_area_fraction(scene, cases[k].lattice), x = static_cast<double>(k + 1);
    const State start = start_state(scene);
    evidence.checks.push_back({.label = fmt::format("{}: densest start", cases[k].name),
                               .values = {most},
                               .band = {cases[k].area_fraction, 1},
                               .exact = true,
                               .x = x});
    evidence.checks.push_back({.label = fmt::format("{}: least distance/d at the start, area fraction {:.3f}",
                                                    cases[k].name, scene.area_fraction()),
                               .values = {least_distance(scene, start)},
                               .band = {1, INFINITY},
                               .exact = true,
                               .x = x});
    evidence.checks.push_back({.label = fmt::format("{}: collisions per disk executed from it", cases[k].name),
                               .values = {collisions_from(scene, start, wanted)},
                               .band = {wanted, INFINITY},
                               .exact = true,
                               .x = x});
    reached.x.push_back(x);
    reached.y.push_back(most);
    claimed.x.push_back(x);
    claimed.y.push_back(scene.area_fraction());
    evidence.notes.push_back(
        fmt::format("{:g}: {}, N {}, densest start {:.4f}.", x, cases[k].name, cases[k].disks, most));
  }
  evidence.extra_cpu_seconds = process_cpu_seconds() - before;
  evidence.plot = {.title = "Densest starts",
                   .xlabel = "case (see the notes)",
                   .ylabel = "area fraction",
                   .xrange = {{0, static_cast<double>(std::size(cases)) + 1}},
                   .series = {reached, claimed}};
  return evidence;
}

}  // namespace gpf
