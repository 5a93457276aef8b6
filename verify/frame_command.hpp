// What the commands that make frames share: their options, their outputs, their progress.
#pragma once

#include <chrono>
#include <filesystem>

#include "verify/view/frames.hpp"
#include "verify/view/view_source.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace gpf {

/// --frames, --interval, --from-start, --from-snapshot. Returns the first.
CLI::Option* add_frame_options(CLI::App& command, FramePlan& plan, ViewStart& start);

/// Throws InputError when `output` is the input, or is there and may not be replaced; StorageError when it cannot be
/// written.
void require_free(const std::filesystem::path& output, const std::filesystem::path& input, bool force);

/// Says so on stderr when the frames of a record will be those of other physics than its own.
void warn_of_other_physics(const ViewSource& source);

/// How many frames are done, on stderr: in place on a terminal, elsewhere a line now and then.
class FrameProgress {
  using Clock = std::chrono::steady_clock;

 public:
  explicit FrameProgress(int count);
  ~FrameProgress();
  FrameProgress(const FrameProgress&) = delete;
  FrameProgress& operator=(const FrameProgress&) = delete;

  void operator()(int done);

 private:
  int count_;
  bool terminal_;
  Clock::time_point told_ = Clock::now();
};

}  // namespace gpf
