// A two-dimensional plot as a value, and its picture as an SVG file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gpf {

enum class SeriesStyle {
  points,  ///< x, y, and vertical bars where yerr is given
  line,    ///< x, y; broken where a value is not finite
  band     ///< between lower and upper over x, and a line through y where y is given
};

/// "points", "line", "band": in files.
constexpr std::string_view name_of(SeriesStyle style) {
  return style == SeriesStyle::points ? "points" : style == SeriesStyle::line ? "line" : "band";
}

/// Vectors that a style uses have one entry per x. Values that are not finite, or not positive on a logarithmic axis,
/// are left out.
struct Series {
  std::string label = {};  ///< in the key; empty: not in the key
  SeriesStyle style = SeriesStyle::points;
  std::vector<double> x = {}, y = {};
  std::vector<double> yerr = {};               ///< points: half length of the bar, empty: no bars
  std::vector<double> lower = {}, upper = {};  ///< band only
};

/// Texts are shown as they are (UTF-8, no markup): they may come from anywhere.
struct Plot {
  std::string title = {}, xlabel = {}, ylabel = {};
  bool logx = false, logy = false;
  std::optional<std::pair<double, double>> xrange = {}, yrange = {};  ///< empty: from the data
  std::vector<Series> series = {};
};

/// The gnuplot commands that draw the plot as SVG on standard output. No text of the plot can act as a command.
/// @throws InputError when vectors differ in length, a range is empty or nothing is left to draw.
std::string gnuplot_script(const Plot& plot);

/// Draws the plot with gnuplot and writes it with write_atomically; equal plots give equal bytes.
/// @throws InputError as gnuplot_script; StorageError when gnuplot is missing or fails or the file cannot be written.
void write_svg(const Plot& plot, const std::filesystem::path& path);

}  // namespace gpf
