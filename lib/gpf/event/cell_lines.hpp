// What a cell keeps of its disks, and the question that one disk puts to all of them: shall we touch?
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/lane.hpp"

namespace gpf {

/// The flights of up to `width` disks side by side. Empty places hold NaN, which meets nobody. More lines are chained
/// to the line of a cell that overflows.
template <int width_>
struct alignas(LaneOf<width_>::alignment) CellLine {
  static constexpr int width = width_;
  using Real = typename LaneOf<width>::Real;

  FlightOf<Real> flights{LaneOf<width>::nobody, LaneOf<width>::nobody, Real{}, Real{}, Real{}};
  std::array<Index, std::size_t{width}> disks{};
  Index more = -1;
  std::uint8_t count = 0, taken = 0;
  std::uint16_t beyond = 0;  ///< disks of the cell in the lines chained to its first
};
static_assert(sizeof(CellLine<2>) == 96 && sizeof(CellLine<4>) == 192);

/// Asks lanes of disks whether flight `a` will touch them, without a branch on the answers; the few that will are
/// timed afterwards.
template <bool a_is_latest, int width>
class Survey {
 public:
  using Line = CellLine<width>;

  Survey(const Flight& a, const ContactTime& contact_time) : a_(a), contact_time_(contact_time) {}

  /// Disks are taken in the image displaced by the shifts.
  void ask(const CellLine<4>& line, double shift_x, double shift_y) {
    asked_[lanes_] = &line;
    beyond_ |= line.beyond;
    keep(contact_time_.encounter<a_is_latest>(a_, line.flights, shift_x, shift_y));
  }
  /// Two lines make a lane.
  void ask(const CellLine<2>& low, const CellLine<2>& high, Lane shift_x, Lane shift_y) {
    asked_[2 * lanes_] = &low, asked_[2 * lanes_ + 1] = &high;
    beyond_ |= low.beyond | high.beyond;
    const FlightOf<HalfLane>&a = low.flights, &b = high.flights;
    const FlightOf<Lane> both{join(a.x, b.x), join(a.y, b.y), join(a.vx, b.vx), join(a.vy, b.vy), join(a.time, b.time)};
    keep(contact_time_.encounter<a_is_latest>(a_, both, shift_x, shift_y));
  }
  void ask(const CellLine<2>& line, double shift_x, double shift_y) {
    static constexpr CellLine<2> nobody;
    ask(line, nobody, Lane{} + shift_x, Lane{} + shift_y);
  }

  /// Whether a cell that was asked has lines chained to it.
  [[nodiscard]] bool more() const { return beyond_ != 0; }

  /// Calls visit(j, contact) for every disk that will be touched.
  template <class Visit>
  void time_them(Visit&& visit) const {
    for (std::uint64_t meet = meet_; meet != 0; meet &= meet - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(meet));
      const Line& line = *asked_[bit / unsigned{width}];
      const Encounter<Lane>& e = answers_[bit / unsigned{lane_width}];
      const unsigned k = bit % unsigned{lane_width}, place = bit % unsigned{width};
      visit(line.disks[place], contact_time_.contact({e.rx[k], e.ry[k], e.approach[k], e.discriminant[k]}, a_.time,
                                                     line.flights.time[place]));
    }
  }

 private:
  void keep(const Encounter<Lane>& answer) {
    answers_[lanes_] = answer;
    meet_ |= std::uint64_t{bits(answer.meet())} << (unsigned{lane_width} * lanes_);
    ++lanes_;
  }

  const Flight& a_;
  const ContactTime& contact_time_;
  std::size_t lanes_ = 0;
  std::uint64_t meet_ = 0;
  std::uint32_t beyond_ = 0;
  std::array<const Line*, 10> asked_;
  std::array<Encounter<Lane>, 9> answers_;
};

}  // namespace gpf
