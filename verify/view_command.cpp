// gpf view: the flow to look at - a page, a picture, a movie.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/snapshot.hpp"
#include "verify/commands.hpp"
#include "verify/stop_signals.hpp"
#include "verify/view/movie.hpp"
#include "verify/view/packed_frames.hpp"
#include "verify/view/page.hpp"
#include "verify/writable.hpp"

namespace gpf {
namespace {

constexpr double most_page_bytes = 400e6;  // browsers end near 500 MB

struct Options {
  std::filesystem::path input, page, svg, movie;
  ViewStart start;
  FramePlan frames;
  std::string colouring = "speed";
  bool force = false;
};

const std::map<std::string, Colouring> colourings{
    {"speed", Colouring::speed}, {"fluctuation", Colouring::fluctuation}, {"one", Colouring::one}};

void require_free(const std::filesystem::path& output, const Options& options) {
  std::error_code ignored;
  if (std::filesystem::equivalent(output, options.input, ignored))
    throw InputError(fmt::format("'{}' is what is to be shown", output.string()), "it would be replaced",
                     "choose another output");
  if (std::filesystem::exists(output, ignored) && !options.force)
    throw InputError(fmt::format("'{}' exists", output.string()), "a file is never overwritten unasked",
                     "choose another output, or --force to replace it");
  require_writable_file(output);
}

/// How many frames are done, on stderr: in place on a terminal, elsewhere a line now and then.
class FrameProgress {
  using Clock = std::chrono::steady_clock;

 public:
  explicit FrameProgress(int count) : count_(count) {}
  ~FrameProgress() {
    if (terminal_) fmt::print(stderr, "\r\033[K");
  }
  FrameProgress(const FrameProgress&) = delete;
  FrameProgress& operator=(const FrameProgress&) = delete;

  void operator()(int done) {
    const auto now = Clock::now();
    if (now - told_ < (terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10))) return;
    told_ = now;
    fmt::print(stderr, "{}frame {} of {}{}", terminal_ ? "\r\033[K" : "", done, count_, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  int count_;
  bool terminal_ = ::isatty(STDERR_FILENO) == 1;
  Clock::time_point told_ = Clock::now();
};

void warn_of_other_physics(const ViewSource& source) {
  if (source.record && source.record->physics_version != physics_version)
    fmt::print(stderr, "gpf: warning: the record is of physics version {}, its frames will be of {}\n",
               source.record->physics_version, physics_version);
}

int view(Options options) {
  if (options.page.empty() && options.svg.empty() && options.movie.empty())
    options.page = std::filesystem::path(options.input).replace_extension(".html");
  if (!options.movie.empty()) require_movie_maker(options.movie);
  if (!options.page.empty()) require_page_parts();
  const ViewSource source = load_view_source(options.input, options.start);
  for (const auto* output : {&options.page, &options.svg, &options.movie})
    if (!output->empty()) require_free(*output, options);
  if ((!options.page.empty() && (options.page == options.svg || options.page == options.movie)) ||
      (!options.svg.empty() && options.svg == options.movie))
    throw InputError("two outputs have one name", "one would replace the other", "give each its own");
  if (options.frames.interval == 0) options.frames.interval = default_interval(source.start.state);
  const double bytes = options.frames.count * bytes_per_frame(source.scene, source.run.bins);
  if (!options.page.empty() && bytes > most_page_bytes)
    throw InputError(fmt::format("the page would have {:.0f} MB", bytes / 1e6), "browsers do not open that",
                     fmt::format("ask for fewer: --frames {:.0f}", options.frames.count * most_page_bytes / bytes));
  warn_of_other_physics(source);

  if (!options.svg.empty()) {
    write_text_atomically(options.svg, snapshot_svg(source.scene, source.start.state,
                                                    fmt::format("{}; t = {:.4g}", source.name, source.start.time)));
    fmt::print("{}\n", options.svg.string());
  }
  if (!options.movie.empty()) {
    FrameProgress progress(options.frames.count);
    write_movie(source, options.frames, colourings.at(options.colouring), options.movie, std::ref(progress));
    fmt::print("{}\n", options.movie.string());
  }
  if (!options.page.empty()) {
    FrameProgress progress(options.frames.count);
    write_text_atomically(options.page, view_page(source, options.frames, std::ref(progress)));
    fmt::print("{}\n", options.page.string());
  }
  return static_cast<int>(ExitStatus::success);
}

}  // namespace

void add_view_command(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("view", "Watch a flow: a page for the browser, a picture, a movie");
  command->add_option("input", options->input, "Record (HDF5), or scene file (*.toml)")->required();
  command->add_option("-o,--output", options->page,
                      "Page to write, HTML (default: INPUT with the end .html, unless --svg or --movie is given)");
  command->add_option("--svg", options->svg, "Picture of the first frame to write");
  command->add_option("--movie", options->movie, "Movie to write, *.mp4 or *.gif (needs ffmpeg)");
  command->add_option("--frames", options->frames.count, "Number of frames")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command
      ->add_option(
          "--interval", options->frames.interval,
          "Time between frames (default: the power of two next below W/(32 v), v the root mean square velocity in the "
          "first)")
      ->check(CLI::PositiveNumber);
  CLI::Option* from_start =
      command->add_flag("--from-start", options->start.from_start, "Begin where the run began, not where it ended");
  command->add_option("--from-snapshot", options->start.snapshot, "Begin at this snapshot of the record, from 1")
      ->check(CLI::PositiveNumber)
      ->excludes(from_start);
  command->add_option("--colour", options->colouring, "Of the movie's disks: speed, fluctuation or one")
      ->check(CLI::IsMember({"speed", "fluctuation", "one"}))
      ->capture_default_str();
  command->add_flag("--force", options->force, "Replace files that exist");
  command->footer(
      "A record keeps few states: what is shown is simulated anew from the last of them, or from the start of a "
      "scene.\n"
      "The page needs neither a network nor other files. Its keys: space plays, arrows step and change the speed.\n"
      "Examples:\n"
      "  gpf view nu30.h5\n"
      "  gpf view scene.toml -o scene.html --frames 600\n"
      "  gpf view nu30.h5 --svg nu30.svg --movie nu30.mp4 --colour fluctuation\n");
  command->callback([options, &status] {
    options->frames.stop = stop_on_signals();
    status = view(*options);
  });
}

}  // namespace gpf
