// A cell of the grid, and its sides.
#pragma once

#include <cstdint>

#include "gpf/event/disk.hpp"

namespace gpf {

/// A cell, by column and row.
struct Place {
  static constexpr Index most_rows = 1 << 16;  ///< so that a Plan has room for the row
  Index column = 0, row = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// Side of a cell through which a disk leaves, as Cells::exit() numbers them.
enum class Side : std::uint8_t { left, right, lower, upper };

}  // namespace gpf
