#include "gpf/io/plot.hpp"

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"

namespace gpf {

void write_svg(const Plot& plot, const std::filesystem::path& path) {
  const std::string script = gnuplot_script(plot);
  // -d: the user's own gnuplot settings must not change the pictures.
  const ProcessResult result = run_program({"gnuplot", "-d"}, script);
  // gnuplot does not report a full disk; only a complete picture ends like this.
  if (result.exit_status != 0 || !result.output.ends_with("</svg>\n\n")) {
    throw StorageError(
        "cannot draw " + path.string() + " with gnuplot (status " + std::to_string(result.exit_status) + ")",
        result.errors.empty() ? "the picture is incomplete" : result.errors,
        "check the data and the ranges, that gnuplot is 5.4 or later, and that temporary files have room");
  }
  write_text_atomically(path, result.output);
}

}  // namespace gpf
