#include "verify/methods/advice_table.hpp"

#include <array>
#include <string>
#include <string_view>

namespace gpf {

std::vector<ChartPoint> advice_table() {
  // A line each: one string of it all would be longer than a compiler need accept.
  const auto lines = std::to_array<std::string_view>({
#include "gpf_methods_table.inc"
  });
  std::string csv;
  for (const std::string_view line : lines) (csv += line) += '\n';
  return points_in(csv, "reference/methods.csv");
}

}  // namespace gpf
