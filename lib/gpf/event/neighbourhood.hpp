// The question that a disk puts to all disks of the cells around it: whom shall I touch first?
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/lane.hpp"
#include "gpf/event/near_cells.hpp"

namespace gpf {

/// What a cell keeps: the numbers of up to six disks. A cell that overflows is continued in another line.
struct alignas(32) CellLine {
  static constexpr std::uint32_t room = 6;
  using Numbers = Index __attribute__((vector_size(32)));  ///< the whole line

  std::array<Index, room> disks{};
  std::uint32_t count = 0;
  std::uint32_t next = 0;  ///< number of the line that continues this one; 0: none

  /// A bit for each place that holds disk i.
  [[nodiscard]] std::uint32_t places_of(Index i) const {
    Numbers line;
    std::memcpy(&line, this, sizeof line);
    return bits(line == i) & ((1u << count) - 1);
  }
};
static_assert(sizeof(CellLine) == 32);

/// A contact that a disk has found.
struct FoundContact {
  double time = never;
  Index partner = -1;
};

/// The disks of the cells around one that asks, which are asked a lane at a time without a branch on their number or
/// their answers. With `shifted` each is taken in an image of its own.
template <bool shifted>
class GPF_LANES Neighbourhood {
 public:
  /// First: the cells to whose lines gather() refers.
  void surround(const NearCells& near) { near_ = &near; }

  /// A line of the cell of that number. Room for nine; they are copied whole, though only their first disks count: that
  /// costs less than a branch on their number.
  void gather(const CellLine& line, std::size_t cell) {
    Line copy;
    std::memcpy(&copy, &line, sizeof copy);
    std::memcpy(&numbers_[count_], &copy, sizeof copy);
    if constexpr (shifted) {
      const std::uint64_t all_of_it = 0x0101010101010101 * cell;
      std::memcpy(&cells_[count_], &all_of_it, sizeof all_of_it);
    }
    count_ += line.count;
  }

  [[nodiscard]] unsigned count() const { return count_; }

  /// After the last line: begins with the contact that the asking disk knows of. From count() up to the lane of place
  /// `end` disks[nobody] is asked, who meets nobody, because its position is not a number.
  void begin(double known_time, Index nobody, unsigned end) {
    const Line nobodies = Line{} + nobody;
    for (unsigned k = count_; k < end + lane_width - 1; k += line_size) {
      std::memcpy(&numbers_[k], &nobodies, sizeof nobodies);
      if constexpr (shifted) std::memset(&cells_[k], 0, line_size);
    }
    least_ = alike(known_time);
  }

  /// Asks the disks in the lane from place k on when they touch disk `a`. One that has found an earlier contact for
  /// itself is no partner: it will collide before.
  template <bool a_is_latest>
  [[gnu::always_inline]] void ask(std::size_t k, const Flight& a, const Disk* disks, const ContactTime& contact_time) {
    const auto disk = [&](unsigned place) -> const Disk& {
      return disks[static_cast<std::uint32_t>(numbers_[k + place])];
    };
    const Abreast b = abreast(disk);
    const auto [shift_x, shift_y] = shifts(k);
    const Encounter<Lane> e = contact_time.encounter<a_is_latest>(a, b.flight, shift_x, shift_y);
    const Lane contact = contact_time.contact<a_is_latest>(e, a.time, b.flight.time);
    const Lane time = (e.meet() & (contact <= b.contact)) ? contact : alike(never);
    times_[k / lane_width] = time;
    least_ = time < least_ ? time : least_;
  }

  /// Makes of the contact that the disk knows of the earliest of it and those that were found; of equal times the one
  /// with the lowest id.
  void choose(FoundContact& known, const Disk* disks) const {
    double time = least_[0];
    for (unsigned k = 1; k < lane_width; ++k) time = std::min(time, least_[k]);
    if (time == never) return;
    std::uint64_t equal = 0;
    for (unsigned k = 0; k < count_; k += lane_width) equal |= std::uint64_t{bits(times_[k / lane_width] == time)} << k;
    Index partner = time < known.time ? -1 : known.partner;
    for (; equal != 0; equal &= equal - 1) {
      const Index j = numbers_[static_cast<unsigned>(std::countr_zero(equal))];
      if (partner < 0 || disks[j].id < disks[partner].id) partner = j;
    }
    known = {time, partner};
  }

 private:
  static constexpr unsigned capacity = 9 * CellLine::room;
  static_assert(capacity < 64, "a word has a bit for each");
  using Line = CellLine::Numbers;
  static constexpr unsigned line_size = sizeof(Line) / sizeof(Index), room = capacity + lane_width + line_size;

  /// Of the disks in the lane from place k on, along x and y. One by one from what gather() has written: its pieces
  /// overlap, and a processor waits when it is to read from several pieces at once that are not in memory yet.
  [[nodiscard]] std::array<Lane, 2> shifts(std::size_t k) const {
    if constexpr (shifted) {
      return columns([&](unsigned place) { return &near_->cells[cells_[k + place]].shift; });
    } else {
      return {-Lane{}, -Lane{}};  // adds nothing, not even an instruction
    }
  }

  const NearCells* near_ = nullptr;
  unsigned count_ = 0;
  std::array<Index, room> numbers_;
  std::array<std::uint8_t, shifted ? room : 1> cells_;
  std::array<Lane, capacity / lane_width + 1> times_;
  Lane least_;
};

}  // namespace gpf
