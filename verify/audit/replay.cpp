#include "verify/audit/replay.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"

namespace gpf {
namespace {

std::string trace(const std::filesystem::path& program, const std::filesystem::path& scene, const char* option,
                  std::int64_t number) {
  ProcessResult result =
      run_program({program.string(), "trace", scene.string(), option, fmt::format("{}", number)}, "");
  if (result.exit_status != 0)
    throw InputError(fmt::format("{} cannot trace the run", program.string()), result.errors,
                     "compare programs that have the command trace");
  return std::move(result.output);
}

}  // namespace

std::optional<EventDifference> replay(const ReplayTask& task) {
  const std::filesystem::path scene = task.folder / "replay.toml";
  write_text_atomically(scene, task.scene);
  const auto before = parse_marks(trace(task.before, scene, "--epochs", task.epochs));
  const auto after = parse_marks(trace(task.after, scene, "--epochs", task.epochs));
  const auto first = first_differing(before, after);
  if (!first) return std::nullopt;
  const bool other_start = *first == 0;
  const std::int64_t begin = std::max<std::int64_t>(1, before[*first].epoch);
  // States that differ in bits which no contact has shown yet show in one of the next epochs.
  const std::int64_t last = std::min(begin + 2, task.epochs);
  for (std::int64_t epoch = begin; epoch <= last; ++epoch) {
    auto event = first_differing(parse_contacts(trace(task.before, scene, "--epoch", epoch)),
                                 parse_contacts(trace(task.after, scene, "--epoch", epoch)), task.epoch_length);
    if (!event) continue;
    event->epoch = epoch;
    event->other_start = other_start;
    return event;
  }
  EventDifference found;
  found.kind = EventDifference::Kind::state;
  found.epoch = begin;
  found.other_start = other_start;
  return found;
}

}  // namespace gpf
