// The cells around a cell against their definition.
#include "gpf/event/near_cells.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <utility>

using namespace gpf;

namespace {

constexpr double length = 1.3;

/// Steps in columns and rows to the cells of a block.
bool in_block(int x, int y, Block block) {
  switch (block) {
    case Block::ahead_left:
      return x == -1;
    case Block::ahead_right:
      return x == 1;
    case Block::ahead_lower:
      return y == -1;
    case Block::ahead_upper:
      return y == 1;
    case Block::all:
      return true;
  }
  return false;
}

/// Every block of every cell of a grid: each cell of the 3 x 3 around it that belongs to the block exactly once, named
/// by its offset in bytes, with the shift of the periods that were gone round. No cell beyond walls.
void check(Index columns, Index rows, bool walls) {
  const NearCellsOfGrid grid(columns, rows, length, walls ? 0 : 1, 24);
  for (Index row = 0; row < rows; ++row)
    for (Index column = 0; column < columns; ++column)
      for (const Block block :
           {Block::ahead_left, Block::ahead_right, Block::ahead_lower, Block::ahead_upper, Block::all}) {
        std::map<std::ptrdiff_t, std::pair<double, double>> expected;  // by offset
        bool shifted = false;
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x) {
            if (!in_block(x, y, block)) continue;
            const int over_x = static_cast<int>(std::floor(1.0 * (column + x) / columns));
            const int over_y = static_cast<int>(std::floor(1.0 * (row + y) / rows));
            if (walls && over_y != 0) continue;
            const std::ptrdiff_t offset = 24 * (std::ptrdiff_t{columns} * (y - over_y * rows) + x - over_x * columns);
            expected[offset] = {over_x * length, over_y};
            shifted |= over_x != 0 || over_y != 0;
          }
        const NearCells& found = grid[grid.number(column, row, block)];
        BOOST_REQUIRE(found.count == expected.size());
        BOOST_REQUIRE(found.shifted == shifted);
        for (std::size_t k = found.count; k < found.cells.size(); ++k) BOOST_REQUIRE(found.cells[k].offset == 0);
        for (std::size_t k = 0; k < found.count; ++k) {
          const auto cell = expected.find(found.cells[k].offset);
          BOOST_REQUIRE(cell != expected.end());
          BOOST_REQUIRE(found.cells[k].shift.x == cell->second.first);
          BOOST_REQUIRE(found.cells[k].shift.y == cell->second.second);
          expected.erase(cell);
        }
      }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(near_cells)

BOOST_AUTO_TEST_CASE(inside_and_at_the_edges_of_a_grid_that_closes_on_itself) {
  check(5, 4, false);
  check(3, 3, false);  // where all cells are near each other
  check(3, 7, false);
}

BOOST_AUTO_TEST_CASE(between_walls_the_grid_ends) {
  check(5, 4, true);
  check(3, 3, true);
  check(6, 2, true);
  check(4, 1, true);
}

BOOST_AUTO_TEST_SUITE_END()
