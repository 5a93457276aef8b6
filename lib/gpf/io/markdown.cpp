#include "gpf/io/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/io/utf8.hpp"

namespace gpf {
namespace {

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths, char fill) {
  std::string text = "|";
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const std::string cell = i < cells.size() ? cells[i] : "";
    text += fill + cell + std::string(widths[i] - character_count(cell) + 1, fill) + '|';
  }
  return text + '\n';
}

int decimal_exponent(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

}  // namespace

std::string markdown_cell(std::string_view text) {
  std::string cell;
  std::size_t backslashes = 0;  // directly before c: doubled before a pipe, or they would undo its escape
  for (const char c : text) {
    if (c == '|') cell += std::string(backslashes + 1, '\\');
    backslashes = c == '\\' ? backslashes + 1 : 0;
    cell += c == '\n' || c == '\r' ? ' ' : c;
  }
  return cell;
}

std::string markdown_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::vector<std::string>> cells{header};
  cells.insert(cells.end(), rows.begin(), rows.end());
  std::vector<std::size_t> widths(header.size(), 3);
  for (std::vector<std::string>& row : cells) {
    if (row.size() > header.size()) {
      throw InputError("cannot write a table row of " + std::to_string(row.size()) + " cells",
                       "the header has " + std::to_string(header.size()), "give the table a wider header");
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      row[i] = markdown_cell(row[i]);
      widths[i] = std::max(widths[i], character_count(row[i]));
    }
  }
  std::string table = line(cells.front(), widths, ' ') + line({}, widths, '-');
  for (auto row = cells.begin() + 1; row != cells.end(); ++row) table += line(*row, widths, ' ');
  return table;
}

std::string number_with_error(double value, double error) {
  error = std::abs(error);
  if (!std::isfinite(value) || !std::isfinite(error) || error <= 1e-12 * std::abs(value)) {
    return fmt::format("{:.6g} ± {:g}", value, error);
  }
  const int scale = decimal_exponent(std::max(std::abs(value), error));
  const bool scientific = scale >= 6 || scale < -4;
  const double unit = scientific ? std::pow(10.0, scale) : 1;
  value /= unit;
  error /= unit;
  // The exponent of the rounded error: 0.0996 with two digits is 0.10, one place less than its own exponent says.
  const int places = std::max(0, 1 - decimal_exponent(std::stod(fmt::format("{:.1e}", error))));
  const std::string text = fmt::format("{:.{}f} ± {:.{}f}", value, places, error, places);
  return scientific ? fmt::format("({})e{:+03d}", text, scale) : text;
}

}  // namespace gpf
