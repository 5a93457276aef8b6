// A plot on disk: the picture, and beside it the numbers that it shows.
#pragma once

#include <filesystem>
#include <string>

#include "gpf/io/plot.hpp"

namespace gpf {

/// One line for each point of each series: its label, its style (points, line, band), x, y, the half length of its bar,
/// and the lower and upper edge of a band. The columns of x and y are named after the axes. Numbers are written in
/// full, those that are not finite (gaps) as empty cells; nothing is left out, whatever the axes can show.
std::string plot_csv(const Plot& plot);

/// "claims/a.csv" of "claims/a.svg": where the numbers of a picture are.
std::string data_file_of(const std::string& picture);

/// Writes `picture`, which ends with .svg, and its data_file_of(). Throws what write_svg throws, and StorageError.
void write_plot(const Plot& plot, const std::filesystem::path& picture);

/// Markdown that shows the picture and links its data; both paths are relative to the page. `alt` is markdown.
std::string plot_markdown(const std::string& alt, const std::string& picture);

}  // namespace gpf
