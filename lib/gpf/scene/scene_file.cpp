#include "gpf/scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "gpf/scene/key_values.hpp"
#include "gpf/scene/lattice.hpp"
#include "gpf/scene/scene_size.hpp"

namespace gpf {
namespace {

constexpr std::size_t most_snapshots = 100;

/// Enumerator of E whose name_of is the value of `key`; for words that KeyValues has checked.
template <class E>
E named(std::string_view name, std::initializer_list<E> all) {
  return *std::find_if(all.begin(), all.end(), [name](E e) { return name_of(e) == name; });
}

void set_walls(Scene& scene, const KeyValues& values) {
  if (scene.geometry == Geometry::channel) {
    const auto beta = values.wall_pair("wall_tangential_restitution");
    if (!beta) throw values.missing("wall_tangential_restitution", "0.9");
    scene.wall_tangential_restitution = *beta;
    scene.wall_normal_restitution = values.real("wall_normal_restitution").value_or(1);
    return;
  }
  for (const std::string_view key : {"wall_normal_restitution", "wall_tangential_restitution"})
    if (values.has(key))
      throw values.error({key}, fmt::format("{} is given in a periodic scene", key), "it has no walls",
                         "remove the key, or set geometry = \"channel\"");
}

void set_gravity(Scene& scene, const KeyValues& values) {
  const bool channel = scene.geometry == Geometry::channel;
  scene.gravity = values.real("gravity").value_or(channel ? 1 : 0);
  if (!channel && scene.gravity > 0)
    throw values.error({"gravity"}, fmt::format("gravity = {} in a periodic scene", scene.gravity),
                       "without walls the flow would accelerate for ever",
                       "remove gravity, or set geometry = \"channel\"");
}

void check_lattice(const Scene& scene, const KeyValues& values) {
  try {
    static_cast<void>(plan_lattice(scene));
  } catch (const InputError& error) {
    throw values.error({"area_fraction", "lattice", "particles"}, error.problem(), error.why(), error.remedy());
  }
}

void set_tc_time(Scene& scene, const KeyValues& values) {
  const double mean_free_time = 1 / scene.reference_collision_rate();
  scene.tc_time = values.real("tc_time").value_or(1e-4 * mean_free_time);
  if (scene.tc_time > mean_free_time)
    throw values.error({"tc_time"}, fmt::format("tc_time = {} exceeds the mean free time", scene.tc_time),
                       fmt::format("that is {:.6g} at the start: most collisions would be elastic", mean_free_time),
                       fmt::format("choose 1e-4 mean free times, tc_time = {:.3g}", 1e-4 * mean_free_time));
}

Scene scene_of(const KeyValues& values) {
  const auto geometry = values.word("geometry");
  if (!geometry) throw values.missing("geometry", "\"channel\"");
  const auto restitution = values.real("normal_restitution");
  if (!restitution) throw values.missing("normal_restitution", "0.99");

  Scene scene;
  scene.geometry = named(*geometry, {Geometry::channel, Geometry::periodic});
  const SceneSize size = resolve_size(values, scene.geometry);
  scene.particles = size.particles;
  scene.width_over_diameter = size.width_over_diameter;
  scene.length_over_width = size.length_over_width;
  scene.normal_restitution = *restitution;
  scene.lattice =
      named(values.word("lattice").value_or("auto"), {Lattice::automatic, Lattice::square, Lattice::triangular});
  scene.seed = static_cast<std::uint64_t>(values.integer("seed").value_or(1));
  set_walls(scene, values);
  set_gravity(scene, values);
  check_lattice(scene, values);
  set_tc_time(scene, values);
  return scene;
}

double largest_power_of_two_up_to(double x) {
  int exponent = 0;
  static_cast<void>(std::frexp(x, &exponent));  // x = m 2^exponent with m in [1/2, 1)
  return std::ldexp(1.0, exponent - 1);
}

Run run_of(const KeyValues& values, const Scene& scene) {
  const double mean_free_time = 1 / scene.reference_collision_rate();
  const auto duration = values.real("duration"), collisions = values.real("collisions_per_particle");
  if (!duration && !collisions)
    throw values.error({"duration"}, "[run] has no target", "neither duration nor collisions_per_particle is given",
                       "add collisions_per_particle = 1000, or a duration");

  // A gas that nothing heats loses (1 - e_n^2)/2 of its temperature per collision and disk (Haff, J. Fluid Mech. 134
  // (1983)), so the time in which it collides so often grows exponentially.
  const double loss = 1 - scene.normal_restitution * scene.normal_restitution;
  if (collisions && scene.geometry == Geometry::periodic && loss / 4 * *collisions > 20)
    throw values.error({"collisions_per_particle"},
                       fmt::format("collisions_per_particle = {} in a gas that cools", *collisions),
                       fmt::format("with normal_restitution = {} it takes {:.1e} times as long as without losses",
                                   scene.normal_restitution, std::exp(std::min(loss / 4 * *collisions, 700.0))),
                       "give a duration instead, or fewer collisions");

  Run run;
  run.duration = duration.value_or(0);
  run.collisions_per_particle = collisions.value_or(0);
  run.start_up =
      values.real("start_up").value_or(50 * (scene.gravity > 0 ? 1 / scene.velocity_scale() : mean_free_time));
  const double shortest = std::min(4 * mean_free_time, 0.25 / scene.velocity_scale());
  run.sample_interval = values.real("sample_interval")
                            .value_or(largest_power_of_two_up_to(duration ? std::min(shortest, *duration) : shortest));
  if (duration && run.sample_interval > *duration)
    throw values.error({"sample_interval"},
                       fmt::format("sample_interval = {} exceeds duration = {}", run.sample_interval, *duration),
                       "no sample would be taken", "lower sample_interval or leave it out");
  const double bins = std::floor(scene.width_over_diameter * 18 / 31 + 0.5);
  run.bins =
      static_cast<std::int32_t>(values.integer("bins").value_or(static_cast<int>(std::clamp(bins, 1.0, 1000.0))));
  run.detail = named(values.word("detail").value_or("profiles"),
                     {Detail::profiles, Detail::distributions, Detail::correlations});
  if (run.detail != Detail::profiles && scene.geometry != Geometry::channel)
    throw values.error({"detail"}, fmt::format("detail = \"{}\" in a periodic scene", name_of(run.detail)),
                       "distributions and correlations are those of the bins across a channel",
                       "remove detail, or set geometry = \"channel\"");
  run.density_modes = static_cast<std::int32_t>(values.integer("density_modes").value_or(0));
  if (run.density_modes > 0 && scene.geometry != Geometry::channel)
    throw values.error({"density_modes"}, fmt::format("density_modes = {} in a periodic scene", run.density_modes),
                       "they are told apart by their shape across a channel",
                       "remove density_modes, or set geometry = \"channel\"");
  run.snapshots = values.ascending("snapshots").value_or(std::vector<double>{});
  if (run.snapshots.size() > most_snapshots)
    throw values.error({"snapshots"}, fmt::format("snapshots has {} times", run.snapshots.size()),
                       fmt::format("each is a copy of all disks; at most {} are kept", most_snapshots),
                       "leave some out");
  for (std::size_t k = 1; k < run.snapshots.size(); ++k)
    if (run.snapshots[k] - run.snapshots[k - 1] < run.sample_interval)
      throw values.error({"snapshots"}, fmt::format("snapshots has {} and {}", run.snapshots[k - 1], run.snapshots[k]),
                         fmt::format("states are kept at samples, which are {} apart", run.sample_interval),
                         "leave one out, or lower sample_interval");
  if (!run.snapshots.empty() && run.snapshots.back() > run.start_up + run.duration)
    throw values.error({"snapshots"},
                       fmt::format("snapshots has {}, beyond start_up + duration = {}", run.snapshots.back(),
                                   run.start_up + run.duration),
                       "only until then is the run sure to last", "leave it out, or lengthen duration");
  return run;
}

}  // namespace

SceneFile parse_scene(std::string_view text, std::string_view name_for_messages) {
  const KeyValues values(text, name_for_messages);
  const Scene scene = scene_of(values);
  return {scene, run_of(values, scene), std::string(text), std::string(name_for_messages)};
}

SceneFile load_scene(const std::filesystem::path& path) {
  const auto unreadable = [&path](std::string why) {
    return StorageError(fmt::format("cannot read the scene file {}", path.string()), std::move(why),
                        "check the path and its permissions");
  };
  std::error_code status;
  if (std::filesystem::is_directory(path, status)) throw unreadable("it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable("it does not exist or may not be opened");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw unreadable("reading failed");
  return parse_scene(text, path.string());
}

}  // namespace gpf
