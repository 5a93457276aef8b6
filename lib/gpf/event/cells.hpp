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
#include "gpf/event/huge_pages.hpp"
#include "gpf/event/lane.hpp"
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
    if (lines_[line].count == lane_width) ++lines_[line].beyond;
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
    Line& home = lines_[number(place)];
    if (&home != &line) --home.beyond;
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
    const Line* const home = &lines_[number(place)];
    for (std::size_t r = 0; r < rows.count; ++r)
      for (std::size_t c = 0; c < columns.count; ++c) {
        const auto* const line = reinterpret_cast<const char*>(&home[rows.offset[r] + columns.offset[c]]);
        for (std::size_t byte = 0; byte < sizeof(Line); byte += alignof(Line)) __builtin_prefetch(line + byte);
      }
  }

  /// Calls visit(j, contact) for every disk j of a block of cells around `place` that flight `a` will touch.
  /// All cells are asked first, without a branch on the answer; the few disks that will touch are timed afterwards.
  template <bool a_is_latest = false, class Visit>
  void for_contacts(const Place& place, const Flight& a, Block block, const ContactTime& contact_time,
                    Visit&& visit) const {
    const auto [columns, rows] = near(place, block);
    if (columns.count == 1)
      ask<a_is_latest, 1>(place, a, columns, rows, contact_time, visit);
    else
      ask<a_is_latest, 3>(place, a, columns, rows, contact_time, visit);
  }

 private:
  /// A lane of disks; empty places hold NaN, which meets nobody. More lines are chained to a cell that overflows.
  struct alignas(64) Line {
    FlightOf<Lane> flights{empty, empty, Lane{}, Lane{}, Lane{}};
    std::array<Index, lane_width> disks{};
    Index more = -1;
    std::uint8_t count = 0, taken = 0;
    std::uint32_t beyond = 0;  ///< disks of the cell in the lines chained to its first

    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    static constexpr Lane empty{nan, nan, nan, nan};
  };

  struct Near {
    const NearCells &columns, &rows;
  };
  [[nodiscard]] Near near(const Place& place, Block block) const {
    using enum NearCellsOfAxis::Which;
    static constexpr std::array columns{before, after, both, both, both}, rows{both, both, before, after, both};
    const auto k = static_cast<std::size_t>(block);
    return {near_columns_(place.column, columns[k]), near_rows_(place.row, rows[k])};
  }

  /// for_contacts() of a block `width` cells wide.
  template <bool a_is_latest, std::size_t width, class Visit>
  void ask(const Place& place, const Flight& a, const NearCells& columns, const NearCells& rows,
           const ContactTime& contact_time, Visit&& visit) const {
    const auto encounter = [&](const Line& line, std::size_t r, std::size_t c) {
      return contact_time.encounter<a_is_latest>(a, line.flights, columns.shift[c], rows.shift[r]);
    };
    const Line* const home = &lines_[number(place)];
    std::array<const Line*, 9> asked;
    std::array<Encounter<Lane>, 9> answers;
    std::uint64_t meet = 0;
    std::uint32_t beyond = 0;
    for (std::size_t r = 0; r < rows.count; ++r)
#pragma GCC unroll 3
      for (std::size_t c = 0; c < width; ++c) {
        const std::size_t k = width * r + c;
        const Line& line = home[rows.offset[r] + columns.offset[c]];
        asked[k] = &line;
        answers[k] = encounter(line, r, c);
        meet |= std::uint64_t{bits(answers[k].meet())} << (lane_width * k);
        beyond |= line.beyond;
      }
    const auto time_it = [&](const Line& line, const Encounter<Lane>& e, unsigned k) {
      const Encounter<double> one{e.rx[k], e.ry[k], e.approach[k], e.discriminant[k]};
      visit(line.disks[k], contact_time.contact(one, a.time, line.flights.time[k]));
    };
    for (; meet != 0; meet &= meet - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(meet));
      time_it(*asked[bit / lane_width], answers[bit / lane_width], bit % lane_width);
    }
    if (beyond == 0) return;
    for (std::size_t r = 0; r < rows.count; ++r)
      for (std::size_t c = 0; c < width; ++c) {
        const Line& first = *asked[width * r + c];
        for (Index more = first.beyond == 0 ? -1 : first.more; more >= 0;) {
          const Line& line = lines_[static_cast<std::size_t>(more)];
          const auto answer = encounter(line, r, c);
          for (unsigned some = bits(answer.meet()); some != 0; some &= some - 1)
            time_it(line, answer, static_cast<unsigned>(std::countr_zero(some)));
          more = line.more;
        }
      }
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
  NearCellsOfAxis near_columns_, near_rows_;
  std::vector<Line, HugePages<Line>> lines_;
};

}  // namespace gpf
