#include "verify/audit/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/audit/child.hpp"

namespace gpf {
namespace {

std::filesystem::path scene_of(const ReplayTask& task) { return task.folder / "replay.toml"; }

std::string trace(const ReplayTask& task, const std::filesystem::path& program, const char* option,
                  std::int64_t number) {
  const std::filesystem::path output = task.folder / "replay.txt", log = task.folder / "replay.log";
  for (const std::filesystem::path& old : {output, log}) std::filesystem::remove(old);
  const ChildResult child = run_child(
      {program.string(), "trace", scene_of(task).string(), option, fmt::format("{}", number)}, log, task.stop, output);
  task.between();
  if (child.exit_status != 0)
    throw InputError(fmt::format("{} cannot trace the run", program.string()), read_text(log),
                     "compare programs that have the command trace");
  return read_text(output);
}

}  // namespace

std::optional<EventDifference> replay(const ReplayTask& task) {
  write_text_atomically(scene_of(task), task.scene);
  const auto before = parse_marks(trace(task, task.before, "--epochs", task.epochs));
  const auto after = parse_marks(trace(task, task.after, "--epochs", task.epochs));
  const auto first = first_differing(before, after);
  if (!first) return std::nullopt;
  const bool other_start = *first == 0;
  const std::int64_t begin = std::max<std::int64_t>(1, before[*first].epoch);
  // States that differ in bits which no contact has shown yet show in one of the next epochs.
  const std::int64_t last = std::min(begin + 2, task.epochs);
  for (std::int64_t epoch = begin; epoch <= last; ++epoch) {
    auto event = first_differing(parse_contacts(trace(task, task.before, "--epoch", epoch)),
                                 parse_contacts(trace(task, task.after, "--epoch", epoch)), task.epoch_length);
    if (!event) continue;
    event->epoch = epoch;
    event->other_start = other_start;
    return event;
  }
  EventDifference found;
  found.kind = EventDifference::Kind::state;
  found.epoch = begin;
  found.other_start = other_start;
  found.largest_ulps = INFINITY;  // by how much is not known
  return found;
}

}  // namespace gpf
