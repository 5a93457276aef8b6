// Lines of comma-separated values (RFC 4180, but lines end with \n).
#pragma once

#include <string>
#include <vector>

namespace gpf {

/// Cells that hold commas, quotes or line breaks are quoted.
inline std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    if (cell.find_first_of(",\"\n\r") == std::string::npos) {
      line += cell;
      continue;
    }
    line += '"';
    for (const char c : cell) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\n";
}

}  // namespace gpf
