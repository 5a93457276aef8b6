// The cells around a cell: where they lie in the grid, and how far round the period.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "gpf/base/vec2.hpp"
#include "gpf/event/disk.hpp"

namespace gpf {

/// What a disk looks at: its whole neighbourhood, or what came into reach when it crossed a side of the cell before.
enum class Block : std::uint8_t { ahead_left, ahead_right, ahead_lower, ahead_upper, all };
inline constexpr std::size_t block_count = 5;

/// At most nine cells: how far each is from the cell in the middle in memory, and the shift that brings its disks
/// beside that cell.
struct NearCells {
  struct Cell {
    std::ptrdiff_t offset;  ///< in bytes
    Vec2 shift;
  };
  std::size_t count = 0;
  bool shifted = false;         ///< some of them lie round a period
  std::array<Cell, 9> cells{};  ///< from count on: the cell in the middle
};

/// The blocks of any cell of a grid. Those of the first, an inner and the last row and column are all that there are.
class NearCellsOfGrid {
 public:
  NearCellsOfGrid() = default;
  /// A period is 0 where the grid ends at walls; a cell takes `size` bytes, and they lie row by row.
  NearCellsOfGrid(Index columns, Index rows, double period_x, double period_y, std::ptrdiff_t size)
      : last_column_(columns - 1), last_row_(rows - 1), size_(size) {
    for (const Index row : {Index{0}, std::min(Index{1}, last_row_), last_row_})
      for (const Index column : {Index{0}, std::min(Index{1}, last_column_), last_column_})
        for (std::size_t block = 0; block < block_count; ++block)
          blocks_[number(column, row, static_cast<Block>(block))] =
              around(column, row, static_cast<Block>(block), period_x, period_y);
  }

  /// Number of a block around a cell, for operator[].
  [[nodiscard]] std::size_t number(Index column, Index row, Block block) const {
    return kind(column, row) * block_count + static_cast<std::size_t>(block);
  }
  const NearCells& operator[](std::size_t number) const { return blocks_[number]; }

 private:
  static std::size_t edge(Index at, Index last) { return std::size_t{at == 0} + 2 * std::size_t{at == last}; }
  [[nodiscard]] std::size_t kind(Index column, Index row) const {
    return 4 * edge(row, last_row_) + edge(column, last_column_);
  }

  [[nodiscard]] NearCells around(Index column, Index row, Block block, double period_x, double period_y) const {
    const Index left = block == Block::ahead_right ? 1 : -1, right = block == Block::ahead_left ? -1 : 1;
    const Index lower = block == Block::ahead_upper ? 1 : -1, upper = block == Block::ahead_lower ? -1 : 1;
    const auto beyond = [](Index at, Index last) { return at < 0 ? -1 : at > last ? 1 : 0; };
    NearCells near;
    for (Index y = lower; y <= upper; ++y)
      for (Index x = left; x <= right; ++x) {
        const int over_x = beyond(column + x, last_column_), over_y = beyond(row + y, last_row_);
        if ((over_x != 0 && period_x == 0) || (over_y != 0 && period_y == 0)) continue;
        const std::ptrdiff_t columns = last_column_ + 1, rows = last_row_ + 1;
        near.cells[near.count++] = {size_ * ((y - over_y * rows) * columns + x - over_x * columns),
                                    {over_x * period_x, over_y * period_y}};
        near.shifted |= over_x != 0 || over_y != 0;
      }
    return near;
  }

  Index last_column_ = 0, last_row_ = 0;
  std::ptrdiff_t size_ = 0;
  std::array<NearCells, 16 * block_count> blocks_;
};

}  // namespace gpf
