// The question that one disk puts to all disks of the cells around it: whom shall I touch first?
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

namespace gpf {

/// What a cell keeps: the numbers of up to six disks. A cell that overflows is continued in another line.
struct alignas(32) CellLine {
  static constexpr std::uint32_t room = 6;

  std::array<Index, room> disks{};
  std::uint32_t count = 0;
  std::uint32_t next = 0;  ///< number of the line that continues this one; 0: none

  /// A bit for each place that holds disk i.
  [[nodiscard]] std::uint32_t places_of(Index i) const {
    std::uint32_t places = 0;
    for (std::uint32_t k = 0; k < room; ++k) places |= std::uint32_t{disks[k] == i} << k;
    return places & ((1u << count) - 1);
  }
};
static_assert(sizeof(CellLine) == 32);

/// A contact that a disk has found.
struct FoundContact {
  double time = never;
  Index partner = -1;
};

/// Disks gathered from cells, and asked four at a time without a branch on their number or their answers. With
/// `shifted` each is taken in an image of its own.
template <bool shifted>
class Neighbourhood {
 public:
  /// Room for nine lines. They are copied whole, though only their first disks count: that costs less than a branch on
  /// their number.
  void gather(const CellLine& line, double shift_x, double shift_y) {
    std::memcpy(&numbers_[count_], &line, sizeof line);
    if constexpr (shifted)
      for (unsigned k = 0; k < CellLine::room; ++k) shift_x_[count_ + k] = shift_x, shift_y_[count_ + k] = shift_y;
    count_ += line.count;
  }

  /// The earliest of the contact that disk `a` knows of and those with the disks gathered; of equal times the one with
  /// the lowest id. A disk that has found an earlier contact for itself is no partner: it will collide before.
  /// disks[nobody] meets nobody, because its position is not a number. Calls fail() when a disk overlaps deeper than
  /// round-off explains.
  template <bool a_is_latest, class Fail>
  FoundContact earliest(const Flight& a, FoundContact known, const Disk* disks, Index nobody,
                        const ContactTime& contact_time, Fail&& fail) {
    for (unsigned k = 0; k + 1 < lane_width; ++k) numbers_[count_ + k] = nobody;
    std::array<Lane, capacity / lane_width + 1> times;
    Lane least = Lane{} + known.time;
    decltype(least < least) overlap{};
    for (unsigned k = 0; k < count_; k += lane_width) {
      const auto disk = [&](unsigned place) -> const Disk& {
        return disks[static_cast<std::uint32_t>(numbers_[k + place])];
      };
      const Disk &b0 = disk(0), &b1 = disk(1), &b2 = disk(2), &b3 = disk(3);
      const FlightOf<Lane> b = abreast(b0.flight, b1.flight, b2.flight, b3.flight);
      const Encounter<Lane> e = contact_time.encounter<a_is_latest>(a, b, lane(shift_x_, k), lane(shift_y_, k));
      const ContactOf<Lane> contact = contact_time.contact<a_is_latest>(e, a.time, b.time);
      const Lane theirs{b0.contact, b1.contact, b2.contact, b3.contact};
      const Lane time = (e.meet() & (contact.time <= theirs)) ? contact.time : Lane{} + never;
      times[k / lane_width] = time;
      least = time < least ? time : least;
      overlap |= e.meet() & contact.overlap;
    }
    if (bits(overlap) != 0) [[unlikely]]
      fail();
    const double time = std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
    if (time == never) return known;
    std::uint64_t equal = 0;
    for (unsigned k = 0; k < count_; k += lane_width) equal |= std::uint64_t{bits(times[k / lane_width] == time)} << k;
    if (time < known.time) known.partner = -1;
    for (; equal != 0; equal &= equal - 1) {
      const Index j = numbers_[static_cast<unsigned>(std::countr_zero(equal))];
      if (known.partner < 0 || disks[j].id < disks[known.partner].id) known.partner = j;
    }
    return {time, known.partner};
  }

 private:
  static constexpr unsigned capacity = 9 * CellLine::room;
  static_assert(capacity < 64, "a word has a bit for each");
  using Shifts = std::array<double, shifted ? capacity + lane_width : 1>;

  static Lane lane(const Shifts& shifts, unsigned k) {
    Lane four = Lane{} - 0.0;  // adds nothing, not even an instruction
    if constexpr (shifted) std::memcpy(&four, &shifts[k], sizeof four);
    return four;
  }

  unsigned count_ = 0;
  std::array<Index, capacity + lane_width + 2> numbers_;
  Shifts shift_x_, shift_y_;
};

}  // namespace gpf
