// The cell grid: equal rectangles no narrower than a disk, which know the numbers of their disks.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/fetch.hpp"
#include "gpf/event/huge_pages.hpp"
#include "gpf/event/lane.hpp"
#include "gpf/event/near_cells.hpp"
#include "gpf/event/neighbourhood.hpp"
#include "gpf/event/place.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

constexpr Block ahead(Side side) { return static_cast<Block>(side); }

/// Rows run along x. In a channel the outermost sides are the contact planes of the walls; otherwise the grid closes
/// on itself with the periods L and 1.
class GPF_LANES Cells {
 public:
  /// Cells of about `disks_per_cell` disks at the mean density, never narrower than a diameter.
  Cells(const Scene& scene, double lower, double upper, double length, double disks_per_cell)
      : channel_(scene.geometry == Geometry::channel),
        corner_{0, lower},
        opposite_{length, upper},
        narrowest_(scene.diameter() * (1 + 1e-9)),
        area_per_disk_(length * (upper - lower) / scene.particles) {
    divide(disks_per_cell);
  }

  /// Divides the box anew, into empty cells of such a size.
  void divide(double disks_per_cell) {
    const double side = std::sqrt(disks_per_cell * area_per_disk_), length = opposite_[0],
                 height = opposite_[1] - corner_[1];
    const auto fit = [=, this](double extent, Index least) {
      return std::max(least, static_cast<Index>(std::min(std::round(extent / side), std::floor(extent / narrowest_))));
    };
    columns_ = fit(length, 3);
    rows_ = std::min(fit(height, channel_ ? 1 : 3), Place::most_rows);
    cell_ = Two{length / columns_, height / rows_};
    const auto margin = [this](double extent) { return std::max((extent - narrowest_) / 2, 1e-10 * narrowest_); };
    margin_ = Two{margin(cell_[0]), margin(cell_[1])};
    near_ = {columns_, rows_, length, channel_ ? 0.0 : 1.0, sizeof(CellLine)};
    lines_.assign(size(), CellLine{});
  }

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }

  /// In which order disks should lie in memory, by their cells: along tiles of 8 x 8 cells, so that those around a cell
  /// lie on few pages. Below orders().
  [[nodiscard]] std::size_t order(const Place& place) const {
    const auto column = static_cast<std::size_t>(place.column), row = static_cast<std::size_t>(place.row);
    return ((row / tile * tiles(columns_) + column / tile) * tile + row % tile) * tile + column % tile;
  }
  [[nodiscard]] std::size_t orders() const { return tiles(columns_) * tiles(rows_) * tile * tile; }

  /// The cell for a disk: of those that it is in, or outside of by no more than the margin (see exit()), the last on
  /// its way, in which it stays longest. One outside the box belongs to the nearest cell.
  [[nodiscard]] Place locate(const Flight& f) const {
    const Two r{f.x, f.y}, v{f.vx, f.vy};
    const Two cells = (r + (v > 0 ? margin_ : Two{}) - (v < 0 ? margin_ : Two{}) - corner_) / cell_;
    const auto clamped = [](double a, Index count) { return std::clamp(static_cast<Index>(a), Index{0}, count - 1); };
    return {clamped(cells[0], columns_), clamped(cells[1], rows_)};
  }

  /// Whether disks often move to another cell when they begin a flight: not where cells leave them no choice, to which
  /// of two a place may belong. In a gas of area fraction .54 cells of one disk are so wide.
  [[nodiscard]] bool are_roomy() const { return std::min(cell_[0], cell_[1]) > 1.2 * narrowest_; }

  /// Moves disk i, which begins flight f, from the cell of `place` to the one that is best for it. Returns whether that
  /// is another: a branch, for where it is not, which is more often, nothing then waits for the divisions in locate().
  bool settle(Place& place, Index i, const Flight& f) {
    const Place best = locate(f);
    if (best == place) return false;
    remove(place, i);
    place = best;
    insert(place, i);
    return true;
  }

  /// Puts disk i into the cell of `place`.
  void insert(const Place& place, Index i) {
    std::size_t line = number(place);
    for (; lines_[line].count == CellLine::room; line = lines_[line].next)
      if (lines_[line].next == 0) {
        lines_[line].next = static_cast<std::uint32_t>(lines_.size());
        lines_.emplace_back();
      }
    lines_[line].disks[lines_[line].count++] = i;
  }

  /// Takes disk i, which is in the cell of `place`, out of it.
  void remove(const Place& place, Index i) {
    for (std::size_t line = number(place);; line = lines_[line].next) {
      CellLine& here = lines_[line];
      if (const unsigned found = here.places_of(i); found != 0) {
        here.disks[static_cast<unsigned>(std::countr_zero(found))] = here.disks[--here.count];
        return;
      }
    }
  }

  /// When and through which side a disk in free flight leaves its cell: not until it is outside by half of what a cell
  /// is wider than a disk, or at the side of the box. Two disks whose cells are no neighbours still cannot touch then,
  /// and many a disk collides before it would have to be moved.
  struct Exit {
    double time;
    Side side;
  };

  [[nodiscard]] Exit exit(const Place& place, const Flight& f) const {
    const Two r{f.x, f.y}, v{f.vx, f.vy};
    const auto forward = v > 0;
    const Two edge =
        Two{static_cast<double>(place.column), static_cast<double>(place.row)} + (forward ? Two{1, 1} : Two{});
    Two goal = corner_ + edge * cell_ + (forward ? margin_ : -margin_);
    goal = goal > corner_ ? goal : corner_;
    goal = goal < opposite_ ? goal : opposite_;
    Two flight = (goal - r) / v;
    flight = flight > 0 ? flight : Two{};
    flight = v != 0 ? flight : Two{never, never};
    const unsigned across = flight[0] < flight[1] ? 0 : 1;  // no branch: it would be guessed wrong
    return {f.time + std::min(flight[0], flight[1]), static_cast<Side>(2 * across + ((bits(forward) >> across) & 1))};
  }

  /// Whether a side of the cell of `place` is a wall.
  [[nodiscard]] bool is_wall(const Place& place, Side side) const {
    return channel_ && ((side == Side::lower && place.row == 0) || (side == Side::upper && place.row == rows_ - 1));
  }

  /// The cell beyond a side, where `x` and `y` count how often that goes round the grid.
  struct Beyond {
    Place place;
    int x, y;
  };
  [[nodiscard]] Beyond beyond(const Place& place, Side side) const {
    const auto k = static_cast<std::size_t>(side);
    const Index column = place.column + std::array{-1, 1, 0, 0}[k], row = place.row + std::array{0, 0, -1, 1}[k];
    const auto round = [](Index at, Index count) { return at < 0 ? -1 : at == count ? 1 : 0; };
    const int x = round(column, columns_), y = round(row, rows_);
    return {{column - x * columns_, row - y * rows_}, x, y};
  }

  /// Moves disk i to the cell beyond a side; where the grid closes on itself its coordinate changes by a period,
  /// exactly. Returns whether it did: whether the disk has gone round the box.
  bool cross(Place& place, Index i, Side side, Flight& flight) {
    remove(place, i);
    const Beyond next = beyond(place, side);
    place = next.place;
    insert(place, i);
    if (next.x == 0 && next.y == 0) return false;
    flight.x -= next.x * opposite_[0], flight.y -= next.y;
    return true;
  }

  /// A disk that asks: from which cell, its flight, the contact that it knows of, and then the earliest that it has
  /// found.
  struct Question {
    Place place;
    Flight flight;
    FoundContact contact;
    const NearCells* near = nullptr;  ///< the cells that are asked
  };

  /// Answers each question with the disks of a block of cells around its place; see Neighbourhood. Two questions are
  /// worked on side by side, for each of them is a long chain of operations that wait for each other.
  template <bool asker_is_latest, std::size_t count>
  void answer(std::array<Question, count>& questions, Block block, const Disk* disks, Index nobody,
              const ContactTime& contact_time) const {
    bool shifted = false;
    for (Question& q : questions) {
      q.near = &near_[near_.number(q.place.column, q.place.row, block)];
      shifted |= q.near->shifted;
    }
    if (shifted)
      answer_shifted<asker_is_latest, true>(questions, disks, nobody, contact_time);
    else
      answer_shifted<asker_is_latest, false>(questions, disks, nobody, contact_time);
  }

  /// A block of cells around a place, to be fetched from memory.
  struct Around {
    std::size_t cell, block;  ///< their numbers
  };
  [[nodiscard]] Around around(const Place& place, Block block) const {
    return {number(place), near_.number(place.column, place.row, block)};
  }
  /// The first `count` cells of a block, which has nine or, ahead of a side, three and the one that is entered. Where a
  /// grid ends some are the middle one once more, which costs less than a branch on their number.
  template <std::size_t count>
  void fetch_cells(const Around& around) const {
    const CellLine* const home = &lines_[around.cell];
    const NearCells& near = near_[around.block];
    if constexpr (count == 3) fetch(home);
#pragma GCC unroll 9
    for (std::size_t k = 0; k < count; ++k) fetch(&line_at(home, near.cells[k].offset));
  }
  void fetch_cell(const Place& place) const { fetch(&lines_[number(place)]); }
  /// Two disks of each of nine cells, three of each of three, whether or not there are so many, for the same reason.
  template <std::size_t count>
  void fetch_disks(const Around& around, const Disk* disks) const {
    constexpr std::size_t disks_of_a_cell = count == 3 ? 3 : 2;
    const CellLine* const home = &lines_[around.cell];
    const NearCells& near = near_[around.block];
#pragma GCC unroll 9
    for (std::size_t k = 0; k < count; ++k) {
      const CellLine& line = line_at(home, near.cells[k].offset);
#pragma GCC unroll 3
      for (std::size_t m = 0; m < disks_of_a_cell; ++m) fetch(&disks[line.disks[m]]);
    }
  }

 private:
  template <bool asker_is_latest, bool shifted, std::size_t count>
  void answer_shifted(std::array<Question, count>& questions, const Disk* disks, Index nobody,
                      const ContactTime& contact_time) const {
    std::array<Neighbourhood<shifted>, count> near;
    std::uint32_t continued = 0;
    unsigned most = 0;
#pragma GCC unroll 2
    for (std::size_t n = 0; n < count; ++n) {
      continued |= gather(questions[n], near[n]);
      most = std::max(most, near[n].count());
    }
#pragma GCC unroll 2
    for (std::size_t n = 0; n < count; ++n) near[n].begin(questions[n].contact.time, nobody, most);
    for (std::size_t k = 0; k < most; k += lane_width) {
#pragma GCC unroll 2
      for (std::size_t n = 0; n < count; ++n)
        near[n].template ask<asker_is_latest>(k, questions[n].flight, disks, contact_time);
    }
#pragma GCC unroll 2
    for (std::size_t n = 0; n < count; ++n) near[n].choose(questions[n].contact, disks);
    if (continued == 0) [[likely]]
      return;
    for (std::size_t n = 0; n < count; ++n) ask_the_rest<asker_is_latest>(questions[n], disks, nobody, contact_time);
  }

  /// The first lines of the cells that are asked. Returns 0 if no cell has more of them.
  template <bool shifted>
  std::uint32_t gather(const Question& question, Neighbourhood<shifted>& neighbours) const {
    const NearCells& near = *question.near;
    const CellLine* const home = &lines_[number(question.place)];
    neighbours.surround(near);
    std::uint32_t continued = 0;
    const auto cell = [&](std::size_t k) {
      const CellLine& line = line_at(home, near.cells[k].offset);
      neighbours.gather(line, k);
      continued |= line.next;
    };
    if (near.count == 9)
#pragma GCC unroll 9
      for (std::size_t k = 0; k < 9; ++k) cell(k);
    else if (near.count == 3)
#pragma GCC unroll 3
      for (std::size_t k = 0; k < 3; ++k) cell(k);
    else
      for (std::size_t k = 0; k < near.count; ++k) cell(k);
    return continued;
  }

  /// Asks the disks of all lines but the first of each cell.
  template <bool asker_is_latest>
  [[gnu::noinline]] void ask_the_rest(Question& question, const Disk* disks, Index nobody,
                                      const ContactTime& contact_time) const {
    const NearCells& near = *question.near;
    const CellLine* const home = &lines_[number(question.place)];
    for (std::size_t cell = 0; cell < near.count; ++cell)
      for (std::uint32_t more = line_at(home, near.cells[cell].offset).next; more != 0; more = lines_[more].next) {
        Neighbourhood<true> rest;
        rest.surround(near);
        rest.gather(lines_[more], cell);
        rest.begin(question.contact.time, nobody, rest.count());
        for (std::size_t k = 0; k < rest.count(); k += lane_width)
          rest.ask<asker_is_latest>(k, question.flight, disks, contact_time);
        rest.choose(question.contact, disks);
      }
  }

  static constexpr std::size_t tile = 8;
  static std::size_t tiles(Index cells) { return (static_cast<std::size_t>(cells) + tile - 1) / tile; }
  static const CellLine& line_at(const CellLine* home, std::ptrdiff_t offset) {
    return *reinterpret_cast<const CellLine*>(reinterpret_cast<const std::byte*>(home) + offset);
  }
  [[nodiscard]] std::size_t number(const Place& place) const {
    return static_cast<std::size_t>(place.row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(place.column);
  }

  bool channel_;
  using Two = double __attribute__((vector_size(16)));  // along x and y
  Two corner_, opposite_;                               // of the box
  double narrowest_, area_per_disk_;
  Index columns_ = 0, rows_ = 0;
  Two cell_{};
  Two margin_{};  // more than round-off: exit() clamps to the sides of the box
  NearCellsOfGrid near_;
  std::vector<CellLine, HugePages<CellLine>> lines_;  // of each cell the first, then those that continue others
};

}  // namespace gpf
