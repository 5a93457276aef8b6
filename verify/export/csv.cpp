#include "verify/export/csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string_view>

#include "gpf/measure/bins.hpp"

namespace gpf {
namespace {

std::string number(double value) { return std::isnan(value) ? "nan" : fmt::format("{}", value); }

bool is_of_modes(std::string_view name) { return name.starts_with("density_power"); }

/// `first`: the leading columns; first_of(row): their values in a row, counted from 0.
std::string table(const MeasuredQuantities& quantities, bool modes, int rows, std::string_view first,
                  const std::function<std::string(int)>& first_of) {
  std::string text(first);
  for (const auto& [name, measured] : quantities)
    if (measured.several && is_of_modes(name) == modes) text += fmt::format(",{0},{0}_error", name);
  text += '\n';
  for (int row = 0; row < rows; ++row) {
    text += first_of(row);
    for (const auto& [name, measured] : quantities)
      if (measured.several && is_of_modes(name) == modes) {
        const Estimate& e = measured.values[static_cast<std::size_t>(row)];
        text += fmt::format(",{},{}", number(e.mean), number(e.error));
      }
    text += '\n';
  }
  return text;
}

}  // namespace

CsvTables csv_tables(const Record& record) {
  const MeasuredQuantities quantities = quantities_of(record);
  CsvTables tables;
  const Bins bins(record.run.bins);
  tables.profiles = table(quantities, false, bins.count(), "bin,y",
                          [&](int bin) { return fmt::format("{},{}", bin + 1, bins.centre(bin)); });
  if (record.run.density_modes > 0)
    tables.modes =
        table(quantities, true, record.run.density_modes, "k", [](int row) { return fmt::format("{}", row + 1); });
  tables.scalars = "quantity,mean,error\n";
  for (const auto& [name, measured] : quantities)
    if (!measured.several)
      tables.scalars +=
          fmt::format("{},{},{}\n", name, number(measured.values.front().mean), number(measured.values.front().error));
  return tables;
}

}  // namespace gpf
