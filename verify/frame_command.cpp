#include "verify/frame_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "gpf/base/error.hpp"
#include "gpf/event/physics_version.hpp"
#include "verify/writable.hpp"

namespace gpf {

CLI::Option* add_frame_options(CLI::App& command, FramePlan& plan, ViewStart& start) {
  CLI::Option* frames = command.add_option("--frames", plan.count, "Number of frames")->check(CLI::Range(1, 100000));
  command
      .add_option(
          "--interval", plan.interval,
          "Time between frames (default: the power of two next below W/(32 v), v the root mean square velocity in the "
          "first)")
      ->check(CLI::PositiveNumber);
  CLI::Option* from_start =
      command.add_flag("--from-start", start.from_start, "Begin where the run began, not where it ended");
  command.add_option("--from-snapshot", start.snapshot, "Begin at this snapshot of the record, from 1")
      ->check(CLI::PositiveNumber)
      ->excludes(from_start);
  return frames;
}

void require_free(const std::filesystem::path& output, const std::filesystem::path& input, bool force) {
  std::error_code ignored;
  if (std::filesystem::equivalent(output, input, ignored))
    throw InputError(fmt::format("'{}' is the input", output.string()), "it would be replaced",
                     "choose another output");
  if (std::filesystem::exists(output, ignored) && !force)
    throw InputError(fmt::format("'{}' exists", output.string()), "a file is never overwritten unasked",
                     "choose another output, or --force to replace it");
  require_writable_file(output);
}

void warn_of_other_physics(const ViewSource& source) {
  if (source.record && source.record->physics_version != physics_version)
    fmt::print(stderr, "gpf: warning: the record is of physics version {}, its frames will be of {}\n",
               source.record->physics_version, physics_version);
}

FrameProgress::FrameProgress(int count) : count_(count), terminal_(::isatty(STDERR_FILENO) == 1) {}

FrameProgress::~FrameProgress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void FrameProgress::operator()(int done) {
  const auto now = Clock::now();
  if (now - told_ < (terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10))) return;
  told_ = now;
  fmt::print(stderr, "{}frame {} of {}{}", terminal_ ? "\r\033[K" : "", done, count_, terminal_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace gpf
