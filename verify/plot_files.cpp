#include "verify/plot_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gpf/io/atomic_file.hpp"
#include "verify/csv.hpp"

namespace gpf {
namespace {

std::string number_in(const std::vector<double>& values, std::size_t i) {
  return i < values.size() && std::isfinite(values[i]) ? fmt::format("{}", values[i]) : "";
}

std::string axis_name(const std::string& label, const char* otherwise) { return label.empty() ? otherwise : label; }

}  // namespace

std::string plot_csv(const Plot& plot) {
  std::string text = csv_line(
      {"series", "style", axis_name(plot.xlabel, "x"), axis_name(plot.ylabel, "y"), "error", "lower", "upper"});
  for (const Series& s : plot.series)
    for (std::size_t i = 0; i < s.x.size(); ++i)
      text += csv_line({s.label, std::string(name_of(s.style)), number_in(s.x, i), number_in(s.y, i),
                        number_in(s.yerr, i), number_in(s.lower, i), number_in(s.upper, i)});
  return text;
}

std::string data_file_of(const std::string& picture) {
  return std::filesystem::path(picture).replace_extension(".csv").string();
}

void write_plot(const Plot& plot, const std::filesystem::path& picture) {
  write_svg(plot, picture);
  write_text_atomically(data_file_of(picture.string()), plot_csv(plot));
}

std::string plot_markdown(const std::string& alt, const std::string& picture) {
  return fmt::format("![{}]({})\n\n[Data of this plot]({})\n", alt, picture, data_file_of(picture));
}

}  // namespace gpf
