#include "gpf/io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gpf/base/error.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/io/arrays.hpp"
#include "gpf/io/hdf5.hpp"
#include "gpf/io/record.hpp"
#include "gpf/io/states.hpp"

namespace gpf {

void write_checkpoint(const Scene& scene, const Run& run, const Checkpoint& c, const std::filesystem::path& path) {
  Hdf5Writer file(path);
  file.write_text("/run", canonical_text(scene, run));
  file.attribute("/", "physics_version", physics_version);
  file.attribute("/", "wall_seconds", c.wall_seconds);
  file.attribute("/", "cpu_seconds", c.cpu_seconds);
  file.attribute("/", "deepest_overlap", c.deepest_overlap);
  const EngineState& e = c.engine;
  file.write("/engine/integers",
             std::vector<std::uint64_t>{static_cast<std::uint64_t>(e.epoch), e.trace_hash, e.counts.pair_contacts,
                                        e.counts.wall_contacts, e.counts.crossings, e.counts.stale, c.samples,
                                        c.contacts_at_begin, c.history.stride, c.history.offered,
                                        c.measurement.series.per_block, c.measurement.series.in_open,
                                        c.measurement.begun ? 1u : 0u});
  const Measurement::Memory& m = c.measurement;
  file.write("/engine/reals",
             std::vector<double>{e.frame_velocity, e.frame_offset, m.last_time, m.momentum_time, m.momentum, m.energy});
  file.write("/engine/x", e.x);
  file.write("/engine/y", e.y);
  file.write("/engine/vx", e.vx);
  file.write("/engine/vy", e.vy);
  file.write("/engine/last_contact", e.last_contact);
  std::vector<double> travels;
  for (const auto& t : m.travels)
    travels.insert(travels.end(), {t.time, t.velocity.x, t.velocity.y, t.displacement.x, t.displacement.y, t.started});
  file.write("/measurement/travels", travels);
  file.write("/measurement/open", m.open);
  file.write("/measurement/series", m.series.sums);
  file.write("/measurement/series_open", m.series.open);
  write_arrays(file, m.arrays);
  if (!run.snapshots.empty()) write_snapshots(file, c.snapshots, static_cast<std::size_t>(scene.particles));
  file.write("/history/time", c.history.time);
  file.write("/history/energy", c.history.energy);
  file.write("/history/temperature", c.history.temperature);
  file.commit();
}

Checkpoint read_checkpoint(const Scene& scene, const Run& run, const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  const auto refuse = [&](std::string why) {
    return InputError(fmt::format("the checkpoint '{}' cannot be used", path.string()), std::move(why),
                      "remove it and run without --resume, or go back to the scene and program that wrote it");
  };
  if (!file.has_attribute("/", "physics_version") || file.attribute_int64("/", "physics_version") != physics_version)
    throw refuse("it was written with another version of the physics");
  if (file.text("/run") != canonical_text(scene, run)) throw refuse("it belongs to another scene, seed or run");
  const auto integers = file.uint64s("/engine/integers").values;
  const auto reals = file.doubles("/engine/reals").values;
  const auto travels = file.doubles("/measurement/travels").values;
  const auto disks = static_cast<std::size_t>(scene.particles);
  if (integers.size() != 13 || reals.size() != 6 || travels.size() != 6 * disks)
    throw refuse("its parts have wrong lengths");

  Checkpoint c;
  c.wall_seconds = file.attribute_double("/", "wall_seconds");
  c.cpu_seconds = file.attribute_double("/", "cpu_seconds");
  c.deepest_overlap = file.attribute_double("/", "deepest_overlap");
  c.engine = {static_cast<std::int64_t>(integers[0]),
              reals[0],
              reals[1],
              file.doubles("/engine/x").values,
              file.doubles("/engine/y").values,
              file.doubles("/engine/vx").values,
              file.doubles("/engine/vy").values,
              file.doubles("/engine/last_contact").values,
              integers[1],
              {integers[2], integers[3], integers[4], integers[5]}};
  c.samples = integers[6];
  c.contacts_at_begin = integers[7];
  c.history.stride = integers[8];
  c.history.offered = integers[9];
  c.measurement = {integers[12] != 0,
                   reals[2],
                   reals[3],
                   reals[4],
                   reals[5],
                   file.doubles("/measurement/open").values,
                   {},
                   {integers[10], integers[11], file.doubles("/measurement/series").values,
                    file.doubles("/measurement/series_open").values},
                   read_arrays(file, scene, run)};
  for (std::size_t i = 0; i < disks; ++i) {
    const double* t = &travels[6 * i];
    c.measurement.travels.push_back({t[0], {t[1], t[2]}, {t[3], t[4]}, t[5]});
  }
  if (!run.snapshots.empty()) {
    try {
      c.snapshots = read_snapshots(file, disks, run);
    } catch (const InputError& error) {
      throw refuse(error.problem());
    }
    const double now = static_cast<double>(c.samples) * run.sample_interval;
    const auto taken = std::count_if(run.snapshots.begin(), run.snapshots.end(),
                                     [&](double t) { return t < now + run.sample_interval / 2; });
    if (taken != static_cast<std::ptrdiff_t>(c.snapshots.size()))
      throw refuse("its snapshots are not those up to its time");
  }
  c.history.time = file.doubles("/history/time").values;
  c.history.energy = file.doubles("/history/energy").values;
  c.history.temperature = file.doubles("/history/temperature").values;
  if (c.history.stride == 0 || c.history.energy.size() != c.history.time.size() ||
      c.history.temperature.size() != c.history.time.size())
    throw refuse("its history has columns of different lengths");
  return c;
}

}  // namespace gpf
