// gpf view: the flow to look at - a page, a picture, a movie.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/snapshot.hpp"
#include "verify/commands.hpp"
#include "verify/frame_command.hpp"
#include "verify/stop_signals.hpp"
#include "verify/view/movie.hpp"
#include "verify/view/packed_frames.hpp"
#include "verify/view/page.hpp"

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

int view(Options options) {
  if (options.page.empty() && options.svg.empty() && options.movie.empty())
    options.page = std::filesystem::path(options.input).replace_extension(".html");
  if (!options.movie.empty()) require_movie_maker(options.movie);
  if (!options.page.empty()) require_page_parts();
  const ViewSource source = load_view_source(options.input, options.start);
  for (const auto* output : {&options.page, &options.svg, &options.movie})
    if (!output->empty()) require_free(*output, options.input, options.force);
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
  add_frame_options(*command, options->frames, options->start)->capture_default_str();
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
