// The cell grid: equal rectangles no narrower than a disk, which hold the flights of their disks side by side.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/lane.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// Side of a cell through which a disk leaves.
enum class Side : std::uint8_t { left, right, lower, upper };

/// Where a disk is: its cell by column and row, and its slot in the cell's storage.
struct Place {
  Index column = 0, row = 0, slot = -1;
};

/// Rows run along x. In a channel the outermost sides are the contact planes of the walls; otherwise the grid closes
/// on itself with the periods L and 1.
class Cells {
 public:
  /// Cells of about `disks_per_cell` disks, never narrower than a diameter.
  Cells(const Scene& scene, double lower, double upper, double length, double disks_per_cell)
      : channel_(scene.geometry == Geometry::channel), lower_(lower), upper_(upper), length_(length) {
    const double height = upper - lower;
    const double side =
        std::max(scene.diameter() * (1 + 1e-9), std::sqrt(disks_per_cell * length * height / scene.particles));
    const auto fit = [side](double extent, Index least) { return std::max(least, static_cast<Index>(extent / side)); };
    columns_ = fit(length, 3);
    rows_ = fit(height, channel_ ? 1 : 3);
    width_ = length / columns_;
    height_ = height / rows_;
    for (std::size_t block = 0; block < inner_.size(); ++block)
      inner_[block] = around({1, 1}, static_cast<Block>(block));
    clear();
  }

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }

  /// Number of a cell, rows first.
  [[nodiscard]] std::size_t number(const Place& place) const { return number(place.column, place.row); }

  /// The cell at a position; one a little outside belongs to the nearest cell.
  [[nodiscard]] Place locate(double x, double y) const {
    const auto clamped = [](double a, Index count) { return std::clamp(static_cast<Index>(a), Index{0}, count - 1); };
    return {clamped(x / width_, columns_), clamped((y - lower_) / height_, rows_)};
  }

  /// Empties all cells.
  void clear() { lines_.assign(size(), Line{}); }

  [[nodiscard]] Flight flight(Index slot) const {
    const auto [line, k] = split(slot);
    return {line->flights.x[k], line->flights.y[k], line->flights.vx[k], line->flights.vy[k], line->flights.time[k]};
  }
  void set(Index slot, const Flight& flight) {
    const auto [found, k] = split(slot);
    Line& line = const_cast<Line&>(*found);
    line.flights.x[k] = flight.x, line.flights.y[k] = flight.y;
    line.flights.vx[k] = flight.vx, line.flights.vy[k] = flight.vy;
    line.flights.time[k] = flight.time;
  }

  /// Puts disk i into the cell of `place` and sets its slot.
  void insert(Place& place, Index i, const Flight& flight) {
    std::size_t line = number(place);
    while (lines_[line].count == lane_width) {
      if (lines_[line].more < 0) {
        lines_[line].more = static_cast<Index>(lines_.size());
        lines_.emplace_back();
      }
      line = static_cast<std::size_t>(lines_[line].more);
    }
    const unsigned free = static_cast<unsigned>(std::countr_one(lines_[line].taken));
    lines_[line].taken |= static_cast<std::uint8_t>(1u << free);
    ++lines_[line].count;
    lines_[line].disks[free] = i;
    place.slot = static_cast<Index>(line) * lane_width + static_cast<Index>(free);
    set(place.slot, flight);
  }

  void remove(const Place& place) {
    Line& line = lines_[static_cast<std::size_t>(place.slot / lane_width)];
    const int k = place.slot % lane_width;
    line.flights.x[k] = std::numeric_limits<double>::quiet_NaN();
    line.taken &= static_cast<std::uint8_t>(~(1u << k));
    --line.count;
  }

  /// When and through which side a disk in free flight leaves its cell.
  struct Exit {
    double time;
    Side side;
    bool wall;
  };

  [[nodiscard]] Exit exit(const Place& place, const Flight& f) const {
    const bool right = f.vx > 0, up = f.vy > 0;
    const bool wall = channel_ && place.row == (up ? rows_ - 1 : 0);
    const double x = (place.column + Index{right}) * width_;
    const double inner = lower_ + (place.row + Index{up}) * height_, outer = up ? upper_ : lower_;
    const double y = wall ? outer : inner;
    const double flight_x = f.vx != 0 ? std::max((x - f.x) / f.vx, 0.0) : never;
    const double flight_y = f.vy != 0 ? std::max((y - f.y) / f.vy, 0.0) : never;
    const bool sideways = flight_x < flight_y;
    const auto side = static_cast<Side>(sideways ? int{right} : 2 + int{up});
    return {f.time + (sideways ? flight_x : flight_y), side, wall && !sideways};
  }

  /// Moves a disk to the cell beyond a side; where the grid closes on itself its coordinate changes by a period,
  /// exactly. Returns whether it did: whether the disk has gone round the box.
  bool cross(Place& place, Index i, Side side) {
    Flight f = flight(place.slot);
    remove(place);
    bool round = false;
    switch (side) {
      case Side::left:
        if (--place.column < 0) place.column += columns_, f.x += length_, round = true;
        break;
      case Side::right:
        if (++place.column == columns_) place.column = 0, f.x -= length_, round = true;
        break;
      case Side::lower:
        if (--place.row < 0) place.row += rows_, f.y += 1, round = true;
        break;
      case Side::upper:
        if (++place.row == rows_) place.row = 0, f.y -= 1, round = true;
        break;
    }
    insert(place, i, f);
    return round;
  }

  /// What a disk looks at: its whole neighbourhood, or what came into reach when it crossed a side of the cell before.
  enum class Block : std::uint8_t { ahead_left, ahead_right, ahead_lower, ahead_upper, all };
  static constexpr Block ahead(Side side) { return static_cast<Block>(side); }

  /// Calls visit(j, contact) for every disk j of a block of cells around `place` that flight `a` will touch.
  /// All cells are asked first, without a branch on the answer; the few disks that will touch are timed afterwards.
  template <class Visit>
  void for_contacts(const Place& place, const Flight& a, Block block, const ContactTime& contact_time,
                    Visit&& visit) const {
    const bool inside = (place.column > 0) & (place.column < columns_ - 1) & (place.row > 0) & (place.row < rows_ - 1);
    Around edge;
    if (!inside) [[unlikely]]
      edge = around(place, block);
    const Around& cells = inside ? inner_[static_cast<std::size_t>(block)] : edge;
    const Line* const home = &lines_[number(place)];
    const auto time_them = [&](const Line& line, unsigned meet, double shift_x, double shift_y) {
      for (; meet != 0; meet &= meet - 1) {
        const int k = std::countr_zero(meet);
        const FlightOf<Lane>& f = line.flights;
        const Flight other{f.x[k], f.y[k], f.vx[k], f.vy[k], f.time[k]};
        visit(line.disks[static_cast<std::size_t>(k)],
              contact_time.contact(contact_time.encounter(a, other, shift_x, shift_y), a.time, other.time));
      }
    };
    std::uint64_t meet = 0;
    Index more = -1;
    for (std::size_t c = 0; c < cells.count; ++c) {
      const Line& line = home[cells.offset[c]];
      const std::uint64_t answer =
          bits(contact_time.encounter(a, line.flights, cells.shift_x[c], cells.shift_y[c]).meet());
      meet |= answer << (lane_width * c);
      more &= line.more;
    }
    for (; meet != 0; meet &= meet - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(meet));
      const std::size_t c = bit / lane_width;
      time_them(home[cells.offset[c]], 1u << (bit % lane_width), cells.shift_x[c], cells.shift_y[c]);
    }
    if (more == -1) [[likely]]
      return;
    for (std::size_t c = 0; c < cells.count; ++c)
      for (Index next = home[cells.offset[c]].more; next >= 0;) {
        const Line& line = lines_[static_cast<std::size_t>(next)];
        const auto encounter = contact_time.encounter(a, line.flights, cells.shift_x[c], cells.shift_y[c]);
        time_them(line, bits(encounter.meet()), cells.shift_x[c], cells.shift_y[c]);
        next = line.more;
      }
  }

 private:
  /// A lane of disks; empty places hold NaN, which meets nobody. More lines are chained to a cell that overflows.
  struct alignas(64) Line {
    FlightOf<Lane> flights{empty, empty, Lane{}, Lane{}, Lane{}};
    std::array<Index, lane_width> disks{};
    Index more = -1;
    std::uint8_t count = 0, taken = 0;

    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    static constexpr Lane empty{nan, nan, nan, nan};
  };

  /// The cells of a block: their numbers relative to its centre and the shifts that bring their disks beside it.
  struct Around {
    std::size_t count = 0;
    std::array<std::ptrdiff_t, 9> offset;
    std::array<double, 9> shift_x, shift_y;
  };

  [[nodiscard]] Around around(const Place& place, Block block) const {
    constexpr std::array<std::array<Index, 4>, 5> extents{
        {{-1, -1, -1, 1}, {1, 1, -1, 1}, {-1, 1, -1, -1}, {-1, 1, 1, 1}, {-1, 1, -1, 1}}};
    const auto [left, right, lower, upper] = extents[static_cast<std::size_t>(block)];
    Around cells;
    for (Index row = place.row + lower; row <= place.row + upper; ++row) {
      const Index row_inside = row < 0 ? row + rows_ : row >= rows_ ? row - rows_ : row;
      if (channel_ && row_inside != row) continue;
      for (Index column = place.column + left; column <= place.column + right; ++column) {
        const Index column_inside = column < 0 ? column + columns_ : column >= columns_ ? column - columns_ : column;
        cells.offset[cells.count] =
            static_cast<std::ptrdiff_t>(number(column_inside, row_inside)) - static_cast<std::ptrdiff_t>(number(place));
        cells.shift_x[cells.count] = column == column_inside ? 0 : column < 0 ? -length_ : length_;
        cells.shift_y[cells.count] = row == row_inside ? 0 : row < 0 ? -1 : 1;
        ++cells.count;
      }
    }
    return cells;
  }

  [[nodiscard]] std::size_t number(Index column, Index row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  struct Split {
    const Line* line;
    int k;
  };
  [[nodiscard]] Split split(Index slot) const {
    return {&lines_[static_cast<std::size_t>(slot) / lane_width],
            static_cast<int>(static_cast<unsigned>(slot) % lane_width)};
  }

  bool channel_;
  double lower_, upper_, length_;
  Index columns_ = 0, rows_ = 0;
  double width_ = 0, height_ = 0;
  std::array<Around, 5> inner_;  ///< of a place away from the edges
  std::vector<Line> lines_;
};

}  // namespace gpf
