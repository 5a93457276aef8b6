// Markdown tables and numbers with their errors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gpf {

/// A text as the content of one table cell: pipes escaped, line breaks as spaces.
std::string markdown_cell(std::string_view text);

/// A table with aligned pipes, one line per row, ending in a line break. Cells are escaped with markdown_cell; rows
/// shorter than the header are filled with empty cells.
/// @throws InputError when a row has more cells than the header.
std::string markdown_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);

/// "0.1234 ± 0.0056": the error with two significant digits, the value to the same place. Beyond 10^6 and below
/// 10^-4 with a common power of ten: "(1.234 ± 0.056)e-07". An error that is not finite or below
/// 10^-12 of the value (zero included) is written as it is, beside the value with six significant digits.
std::string number_with_error(double value, double error);

}  // namespace gpf
