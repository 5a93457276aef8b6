// The cell grid: equal rectangles no narrower than a disk, which hold the flights of their disks side by side.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "gpf/event/cell_lines.hpp"
#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/huge_pages.hpp"
#include "gpf/event/near_cells.hpp"
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
  template <int width>
  using Lines = std::vector<CellLine<width>, HugePages<CellLine<width>>>;

  /// Calls work(lines) for the lines that this grid has.
  template <class Work>
  decltype(auto) on_lines(Work&& work) {
    return wide_cells_ ? work(wide_) : work(narrow_);
  }
  template <class Work>
  decltype(auto) on_lines(Work&& work) const {
    return wide_cells_ ? work(wide_) : work(narrow_);
  }
  template <class Lines>
  static constexpr int width_of = std::remove_cvref_t<Lines>::value_type::width;
  template <class Lines>
  static auto& line_of(Lines& lines, Index slot) {
    return lines[static_cast<std::size_t>(slot) / std::size_t{width_of<Lines>}];
  }
  template <class Lines>
  static unsigned place_in_line(const Lines&, Index slot) {
    return static_cast<unsigned>(slot) % unsigned{width_of<Lines>};
  }

 public:
  /// Cells of about `disks_per_cell` disks, never narrower than a diameter.
  Cells(const Scene& scene, double lower, double upper, double length, double disks_per_cell)
      : channel_(scene.geometry == Geometry::channel), lower_(lower), upper_(upper), length_(length) {
    const double height = upper - lower;
    const double side =
        std::max(scene.diameter() * (1 + 1e-9), std::sqrt(disks_per_cell * length * height / scene.particles));
    wide_cells_ = scene.particles * side * side > 1.2 * length * height;
    const auto fit = [side](double extent, Index least) { return std::max(least, static_cast<Index>(extent / side)); };
    columns_ = fit(length, 3);
    rows_ = fit(height, channel_ ? 1 : 3);
    width_ = length / columns_;
    height_ = height / rows_;
    near_columns_ = {columns_, 1, length};
    near_rows_ = {rows_, columns_, channel_ ? 0.0 : 1.0};
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
  void clear() {
    narrow_.assign(wide_cells_ ? 0 : size(), CellLine<2>{});
    wide_.assign(wide_cells_ ? size() : 0, CellLine<4>{});
  }

  [[nodiscard]] Flight flight(Index slot) const {
    return on_lines([slot](const auto& lines) {
      const auto& flights = line_of(lines, slot).flights;
      const auto k = place_in_line(lines, slot);
      return Flight{flights.x[k], flights.y[k], flights.vx[k], flights.vy[k], flights.time[k]};
    });
  }
  void set(Index slot, const Flight& flight) {
    on_lines([&](auto& lines) {
      auto& flights = line_of(lines, slot).flights;
      const auto k = place_in_line(lines, slot);
      flights.x[k] = flight.x, flights.y[k] = flight.y;
      flights.vx[k] = flight.vx, flights.vy[k] = flight.vy;
      flights.time[k] = flight.time;
    });
  }

  /// Puts disk i into the cell of `place` and sets its slot.
  void insert(Place& place, Index i, const Flight& flight) {
    on_lines([&](auto& lines) {
      constexpr int width = width_of<decltype(lines)>;
      std::size_t line = number(place);
      if (lines[line].count == width) ++lines[line].beyond;
      while (lines[line].count == width) {
        if (lines[line].more < 0) {
          lines[line].more = static_cast<Index>(lines.size());
          lines.emplace_back();
        }
        line = static_cast<std::size_t>(lines[line].more);
      }
      const auto free = static_cast<unsigned>(std::countr_one(lines[line].taken));
      lines[line].taken |= static_cast<std::uint8_t>(1u << free);
      ++lines[line].count;
      lines[line].disks[free] = i;
      place.slot = static_cast<Index>(line) * width + static_cast<Index>(free);
    });
    set(place.slot, flight);
  }

  void remove(const Place& place) {
    on_lines([&](auto& lines) {
      auto& line = line_of(lines, place.slot);
      const auto k = place_in_line(lines, place.slot);
      line.flights.x[k] = std::numeric_limits<double>::quiet_NaN();
      line.taken &= static_cast<std::uint8_t>(~(1u << k));
      --line.count;
      auto& home = lines[number(place)];
      if (&home != &line) --home.beyond;
    });
  }

  /// When and through which side a disk in free flight leaves its cell.
  struct Exit {
    double time;
    Side side;
    bool wall;
  };

  [[nodiscard]] Exit exit(const Place& place, const Flight& f) const {
    const bool right = f.vx > 0, up = f.vy > 0;
    const Index edge_x = place.column + Index{right}, edge_y = place.row + Index{up};
    const double x = edge_x == columns_ ? length_ : edge_x * width_;
    const double y = edge_y == rows_ ? upper_ : lower_ + edge_y * height_;
    const bool wall = channel_ && (edge_y == 0 || edge_y == rows_);
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

  /// Fetches what for_contacts() will read.
  void prefetch(const Place& place, Block block) const {
    const auto [columns, rows] = near(place, block);
    on_lines([&, &columns = columns, &rows = rows](const auto& lines) {
      for (std::size_t r = 0; r < rows.count; ++r)
        for (std::size_t c = 0; c < columns.count; ++c) {
          const auto* const line = &lines[number(place)] + rows.offset[r] + columns.offset[c];
          for (std::size_t byte = 0; byte < sizeof *line; byte += 64)
            __builtin_prefetch(reinterpret_cast<const char*>(line) + byte);
        }
    });
  }

  /// Calls visit(j, contact) for every disk j of a block of cells around `place` that flight `a` will touch.
  /// All cells are asked first, without a branch on the answer; the few disks that will touch are timed afterwards.
  template <bool a_is_latest = false, class Visit>
  void for_contacts(const Place& place, const Flight& a, Block block, const ContactTime& contact_time,
                    Visit&& visit) const {
    const auto [columns, rows] = near(place, block);
    on_lines([&, &columns = columns, &rows = rows](const auto& lines) {
      const auto* const home = &lines[number(place)];
      if (columns.count == 1)
        ask<a_is_latest, 1, width_of<decltype(lines)>>(lines, home, a, columns, rows, contact_time, visit);
      else
        ask<a_is_latest, 3, width_of<decltype(lines)>>(lines, home, a, columns, rows, contact_time, visit);
    });
  }

 private:
  struct Near {
    const NearCells &columns, &rows;
  };
  [[nodiscard]] Near near(const Place& place, Block block) const {
    using enum NearCellsOfAxis::Which;
    static constexpr std::array columns{before, after, both, both, both}, rows{both, both, before, after, both};
    const auto k = static_cast<std::size_t>(block);
    return {near_columns_(place.column, columns[k]), near_rows_(place.row, rows[k])};
  }

  /// for_contacts() of a block `wide` cells wide.
  template <bool a_is_latest, std::size_t wide, int width, class Visit>
  void ask(const Lines<width>& lines, const CellLine<width>* home, const Flight& a, const NearCells& columns,
           const NearCells& rows, const ContactTime& contact_time, Visit&& visit) const {
    Survey<a_is_latest, width> survey(a, contact_time);
    const auto cell = [&](std::size_t r, std::size_t c) { return home + rows.offset[r] + columns.offset[c]; };
    if constexpr (width == 4) {
      for (std::size_t r = 0; r < rows.count; ++r)
#pragma GCC unroll 3
        for (std::size_t c = 0; c < wide; ++c) survey.ask(*cell(r, c), columns.shift[c], rows.shift[r]);
    } else {
      // The first two columns in pairs along the rows, the last in pairs along the column.
      const auto [x0, x1, x2] = columns.shift;
      const auto [y0, y1, y2] = rows.shift;
      const Lane along{x0, x0, x1, x1}, across{y0, y0, y1, y1};
      constexpr std::size_t last = wide - 1;
      if constexpr (wide == 3)
        for (std::size_t r = 0; r < rows.count; ++r)
          survey.ask(*cell(r, 0), *cell(r, 1), along, Lane{} + rows.shift[r]);
      if (rows.count == 1)
        survey.ask(*cell(0, last), columns.shift[last], y0);
      else if (rows.count > 1)
        survey.ask(*cell(0, last), *cell(1, last), Lane{} + columns.shift[last], across);
      if (rows.count == 3) survey.ask(*cell(2, last), columns.shift[last], y2);
    }
    survey.time_them(visit);
    if (!survey.more()) return;
    for (std::size_t r = 0; r < rows.count; ++r)
      for (std::size_t c = 0; c < wide; ++c)
        for (Index more = cell(r, c)->beyond == 0 ? -1 : cell(r, c)->more; more >= 0;) {
          const auto& line = lines[static_cast<std::size_t>(more)];
          Survey<a_is_latest, width> chained(a, contact_time);
          chained.ask(line, columns.shift[c], rows.shift[r]);
          chained.time_them(visit);
          more = line.more;
        }
  }

  [[nodiscard]] std::size_t number(Index column, Index row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  bool channel_, wide_cells_;
  double lower_, upper_, length_;
  Index columns_ = 0, rows_ = 0;
  double width_ = 0, height_ = 0;
  NearCellsOfAxis near_columns_, near_rows_;
  Lines<2> narrow_;  // of cells of about one disk
  Lines<4> wide_;    // of larger cells
};

}  // namespace gpf
