#include "verify/view/view_source.hpp"

#include <fmt/format.h>

#include "gpf/base/error.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"

namespace gpf {
namespace {

Snapshot start_of(const Record& record, const ViewStart& start) {
  if (start.from_start) return {0, start_state(record.scene)};
  if (start.snapshot == 0) return {record.time, record.final_state};
  const auto count = static_cast<int>(record.snapshots.size());
  if (start.snapshot > count)
    throw InputError(fmt::format("there is no snapshot {}", start.snapshot),
                     fmt::format("the record has {}, counted from 1", count),
                     "choose one of those, or run the scene with `snapshots = [time, ...]` in [run]");
  return record.snapshots[static_cast<std::size_t>(start.snapshot - 1)];
}

}  // namespace

ViewSource load_view_source(const std::filesystem::path& path, const ViewStart& start) {
  ViewSource source;
  source.name = path.filename().string();
  if (path.extension() == ".toml") {
    if (start.snapshot > 0)
      throw InputError(fmt::format("'{}' is a scene file", path.string()), "only records have snapshots",
                       "name a record, or leave --from-snapshot out");
    const SceneFile file = load_scene(path);
    source.scene = file.scene;
    source.run = file.run;
    source.start = {0, start_state(file.scene)};
    return source;
  }
  source.record = read_record(path);
  source.scene = source.record->scene;
  source.run = source.record->run;
  source.start = start_of(*source.record, start);
  return source;
}

}  // namespace gpf
