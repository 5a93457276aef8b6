#include "verify/view/movie.hpp"

#include <fmt/format.h>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"
#include "verify/view/canvas.hpp"
#include "verify/view/piped_program.hpp"

namespace gpf {
namespace {

std::vector<std::string> ffmpeg_call(const Canvas& canvas, const std::string& format, const std::string& output) {
  std::vector<std::string> call{"ffmpeg",
                                "-nostdin",
                                "-loglevel",
                                "error",
                                "-y",
                                "-f",
                                "rawvideo",
                                "-pix_fmt",
                                "rgb24",
                                "-s",
                                fmt::format("{}x{}", canvas.width(), canvas.height()),
                                "-r",
                                fmt::format("{}", movie_frames_per_second),
                                "-i",
                                "pipe:0"};
  // What most players read; for a GIF the best 256 colours instead of fixed ones.
  const std::vector<std::string> coding =
      format == "gif" ? std::vector<std::string>{"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse"}
                      : std::vector<std::string>{"-pix_fmt", "yuv420p", "-movflags", "+faststart"};
  call.insert(call.end(), coding.begin(), coding.end());
  call.insert(call.end(), {"-f", format, "file:" + output});
  return call;
}

std::string format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".mp4" || extension == ".gif") return extension.substr(1);
  throw InputError(fmt::format("'{}' names no movie", path.string()), "the name's end chooses the format",
                   "let it end in .mp4 or .gif");
}

}  // namespace

void require_movie_maker(const std::filesystem::path& path) {
  static_cast<void>(format_of(path));
  try {
    run_program({"ffmpeg", "-version"}, "");
  } catch (const StorageError& error) {
    throw StorageError("movies are made by ffmpeg, which cannot be started", error.why(),
                       "install it (Debian: apt-get install ffmpeg), or write a page with -o instead");
  }
}

void write_movie(const ViewSource& source, const FramePlan& plan, Colouring colouring,
                 const std::filesystem::path& path, const std::function<void(int)>& shown) {
  const Canvas canvas(source.scene, source.run.bins, colouring, source.start.state);
  write_atomically(path, [&](const std::filesystem::path& part) {
    PipedProgram ffmpeg(ffmpeg_call(canvas, format_of(path), part.string()));
    int count = 0;
    run_frames(source.scene, source.start, plan, [&](const Snapshot& frame) {
      ffmpeg.write(canvas.draw(frame.state));
      shown(++count);
    });
    ffmpeg.finish();
  });
}

}  // namespace gpf
