// The neighbours of a cell along one axis of the grid, round the period where the grid closes on itself.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "gpf/event/disk.hpp"

namespace gpf {

/// At most three cells in a row: how far each is from the cell in the middle, in cells of the grid, and the shift that
/// brings its disks beside that cell.
struct NearCells {
  std::size_t count = 0;
  std::array<std::ptrdiff_t, 3> offset{};
  std::array<double, 3> shift{};
};

/// The neighbours of any cell along an axis: those of the first, an inner and the last cell are all that there are.
class NearCellsOfAxis {
 public:
  enum class Which : std::uint8_t { before, after, both };  ///< both: and the cell itself

  NearCellsOfAxis() = default;
  /// `size` cells, `stride` apart in the grid. `period`: 0 if the axis does not close on itself.
  NearCellsOfAxis(Index size, std::ptrdiff_t stride, double period) : last_(size - 1) {
    for (const Index at : {Index{0}, std::min(Index{1}, last_), last_})
      for (const Which which : {Which::before, Which::after, Which::both})
        cells_[edge(at)][static_cast<std::size_t>(which)] = around(at, which, stride, period);
  }

  [[nodiscard]] const NearCells& operator()(Index at, Which which) const {
    return cells_[edge(at)][static_cast<std::size_t>(which)];
  }

 private:
  [[nodiscard]] std::size_t edge(Index at) const { return std::size_t{at > 0} + std::size_t{at == last_}; }

  [[nodiscard]] NearCells around(Index at, Which which, std::ptrdiff_t stride, double period) const {
    NearCells cells;
    for (Index near = at - (which != Which::after); near <= at + (which != Which::before); ++near) {
      if (near == at && which != Which::both) continue;
      const bool below = near<0, above = near> last_;
      if ((below || above) && period == 0) continue;
      cells.offset[cells.count] = stride * ((below ? last_ : above ? 0 : near) - at);
      cells.shift[cells.count] = below ? -period : above ? period : 0;
      ++cells.count;
    }
    return cells;
  }

  Index last_ = 0;
  std::array<std::array<NearCells, 3>, 3> cells_;
};

}  // namespace gpf
