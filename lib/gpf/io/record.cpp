#include "gpf/io/record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/io/arrays.hpp"
#include "gpf/io/hdf5.hpp"
#include "gpf/io/states.hpp"
#include "gpf/measure/tallies.hpp"
#include "gpf/scene/scene_file.hpp"

namespace gpf {

namespace {

constexpr std::string_view format_name = "gpf record 1";

InputError unusable(const std::filesystem::path& path, std::string why) {
  return {fmt::format("'{}' is not a usable record", path.string()), std::move(why),
          "delete it and run the scene again"};
}

}  // namespace

std::string canonical_text(const Scene& scene, const Run& run) {
  std::string text = canonical_text(scene);
  text += fmt::format("\n[run]\nstart_up = {}\n", run.start_up);
  if (run.duration > 0) text += fmt::format("duration = {}\n", run.duration);
  if (run.collisions_per_particle > 0)
    text += fmt::format("collisions_per_particle = {}\n", run.collisions_per_particle);
  text += fmt::format("sample_interval = {}\nbins = {}\n", run.sample_interval, run.bins);
  if (run.detail != Detail::profiles) text += fmt::format("detail = \"{}\"\n", name_of(run.detail));
  if (run.density_modes > 0) text += fmt::format("density_modes = {}\n", run.density_modes);
  if (!run.snapshots.empty()) text += fmt::format("snapshots = [{}]\n", fmt::join(run.snapshots, ", "));
  return text;
}

std::string record_name(const Scene& scene, const Run& run) {
  return hexadecimal(hash_text(fmt::format("{}physics {}\n", canonical_text(scene, run), physics_version)));
}

void write_record(const Record& r, const std::filesystem::path& path) {
  Hdf5Writer file(path);
  file.attribute("/", "format", format_name);
  file.attribute("/", "physics_version", r.physics_version);
  file.attribute("/", "trace_hash", hexadecimal(r.trace_hash));
  file.attribute("/", "time", r.time);
  file.attribute("/", "epoch_length", r.epoch_length);
  file.attribute("/", "deepest_overlap", r.deepest_overlap);
  file.attribute("/", "pair_contacts", r.counts.pair_contacts);
  file.attribute("/", "wall_contacts", r.counts.wall_contacts);
  file.attribute("/", "crossings", r.counts.crossings);
  file.attribute("/", "stale", r.counts.stale);

  file.write_text("/scene/text", r.scene_text);
  file.write_text("/scene/canonical", canonical_text(r.scene, r.run));

  const TallyLayout layout(r.run);
  std::string names;
  for (const std::string& label : layout.labels()) names += label + "\n";
  file.write_text("/tallies/names", names);
  file.write("/tallies/sums", r.sums, Dims{r.blocks, layout.size()});

  write_arrays(file, r.arrays);
  file.write("/history/time", r.history.time);
  file.write("/history/energy", r.history.energy);
  file.write("/history/granular_temperature", r.history.temperature);

  const auto disks = static_cast<std::size_t>(r.scene.particles);
  if (!r.run.snapshots.empty()) write_snapshots(file, r.snapshots, disks);
  write_state(file, "/final", r.final_state);

  file.write_text("/provenance", r.build);
  file.write_text("/session/provenance", r.session);
  file.attribute("/session", "wall_seconds", r.wall_seconds);
  file.attribute("/session", "cpu_seconds", r.cpu_seconds);
  file.commit();
}

Record read_record(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  if (!file.has_attribute("/", "format") || file.attribute_text("/", "format") != format_name)
    throw unusable(path, fmt::format("it does not say that it is a '{}'", format_name));
  Record r;
  r.scene_text = file.text("/scene/text");
  const SceneFile parsed = parse_scene(file.text("/scene/canonical"), path.string() + ":/scene/canonical");
  r.scene = parsed.scene;
  r.run = parsed.run;
  r.physics_version = static_cast<int>(file.attribute_int64("/", "physics_version"));
  try {
    r.trace_hash = std::stoull(file.attribute_text("/", "trace_hash"), nullptr, 16);
  } catch (const std::exception&) {
    throw unusable(path, "its trace hash is not a hexadecimal number");
  }
  r.time = file.attribute_double("/", "time");
  r.epoch_length = file.attribute_double("/", "epoch_length");
  r.deepest_overlap = file.attribute_double("/", "deepest_overlap");
  r.counts = {file.attribute_uint64("/", "pair_contacts"), file.attribute_uint64("/", "wall_contacts"),
              file.attribute_uint64("/", "crossings"), file.attribute_uint64("/", "stale")};

  auto sums = file.doubles("/tallies/sums");
  if (sums.dims.size() != 2 || sums.dims[1] != TallyLayout(r.run).size())
    throw unusable(path, "its sums are not those that this version of gpf collects");
  r.blocks = sums.dims[0];
  r.sums = std::move(sums.values);
  r.arrays = read_arrays(file, r.scene, r.run);
  r.history.time = file.doubles("/history/time").values;
  r.history.energy = file.doubles("/history/energy").values;
  r.history.temperature = file.doubles("/history/granular_temperature").values;
  if (r.history.energy.size() != r.history.time.size() || r.history.temperature.size() != r.history.time.size())
    throw unusable(path, "its history has columns of different lengths");
  const auto disks = static_cast<std::size_t>(r.scene.particles);
  try {
    if (!r.run.snapshots.empty()) r.snapshots = read_snapshots(file, disks, r.run);
    r.final_state = read_state(file, "/final", disks);
  } catch (const InputError& error) {
    throw unusable(path, error.problem());
  }
  if (r.snapshots.size() != r.run.snapshots.size()) throw unusable(path, "not all of its snapshots are there");
  r.build = file.text("/provenance");
  r.session = file.text("/session/provenance");
  r.wall_seconds = file.attribute_double("/session", "wall_seconds");
  r.cpu_seconds = file.attribute_double("/session", "cpu_seconds");
  return r;
}

MeasuredQuantities quantities_of(const Record& record) {
  return measure_quantities(record.scene, TallyLayout(record.run), record.sums, record.blocks);
}

}  // namespace gpf
