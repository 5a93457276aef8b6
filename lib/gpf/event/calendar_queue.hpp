// The O(1) scheduler: a circular calendar of short unordered lists (Brown, CACM 31 (1988); Paul, J. Comput. Phys. 221
// (2007)).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/fetch.hpp"
#include "gpf/event/huge_pages.hpp"
#include "gpf/event/queue_meter.hpp"

namespace gpf {

/// One scheduled time per disk. A day holds the events of one stretch of time of about one event; days further ahead
/// than the calendar is long share its slots and are told apart by their number.
template <class Meter = NoMeter>
class BasicCalendarQueue {
 public:
  /// Empties the queue for `count` disks and times in [0, horizon]; later ones count as never. `events_per_time` sets
  /// the width of a day: it decides about speed only.
  void reset(std::size_t count, double horizon, double events_per_time) {
    horizon_ = horizon;
    days_per_time_ = std::min(events_per_time, 0x1p40 / horizon);
    const std::size_t slots = std::bit_ceil(std::max<std::size_t>(2 * count, 64));
    mask_ = static_cast<std::int64_t>(slots) - 1;
    first_slot_ = static_cast<Index>(2 * count);
    today_ = foreseen_ = 0;
    last_ = day(horizon);
    links_.resize(2 * count + slots);
    for (std::size_t k = 0; k < links_.size(); ++k) links_[k] = {static_cast<Index>(k), static_cast<Index>(k)};
    for (std::size_t i = 0; i < count; ++i) links_[2 * i + 1] = std::bit_cast<Link>(never);
  }

  void schedule(Index i, double time) {
    unlink(2 * i);
    at(2 * i + 1) = std::bit_cast<Link>(time);
    link(2 * i, time <= horizon_ ? slot(std::max(day(time), today_)) : 2 * i);
  }

  /// The disk with the earliest time, -1 when nothing is scheduled. Of equal times the disk that comes first:
  /// first(a, b) says whether a comes before b.
  template <class First>
  [[nodiscard]] Index earliest(First&& first) {
    for (; today_ <= last_; ++today_) {
      const Index head = slot(today_);
      Index best = -1;
      double best_time = never;
      Meter::step();
      for (Index entry = at(head).next; entry != head; entry = at(entry).next) {
        Meter::step();
        const Index i = entry / 2;
        if (day(time(i)) <= today_ && (time(i) < best_time || (time(i) == best_time && best >= 0 && first(i, best)))) {
          best = i;
          best_time = time(i);
        }
      }
      if (best >= 0) return best;
    }
    today_ = last_;
    return -1;
  }

  [[nodiscard]] double time(Index i) const {
    return std::bit_cast<double>(links_[2 * static_cast<std::size_t>(i) + 1]);
  }

  /// Names disks whose events are coming (and some others), each to the four stages in turn, so that what they need can
  /// be fetched from memory meanwhile; stage(number, i).
  template <class Stage>
  void foresee(Stage&& stage) {
    for (; foreseen_ < today_; ++foreseen_) {
      fetch(&at(slot(foreseen_ + 40)));
      fetch(&at(at(slot(foreseen_ + 32)).next));
      for (int number = 0; number < 4; ++number) {
        const Index head = slot(foreseen_ + 24 - std::int64_t{6} * number);
        for (Index entry = at(head).next; entry != head; entry = at(entry).next) stage(number, entry / 2);
      }
    }
  }
  /// Fetches what the entry of disk i is linked to.
  void fetch_links(Index i) {
    fetch(&at(at(2 * i).next));
    fetch(&at(at(2 * i).previous));
  }

 private:
  /// The entries of a slot's disks and its head form a ring; an entry that is not scheduled is a ring of its own. Rings
  /// are linked and unlinked without a branch. The entry of disk i is link 2 i; its time lies beside it, in the place
  /// of link 2 i + 1.
  struct Link {
    Index next, previous;
  };

  [[nodiscard]] std::int64_t day(double time) const { return static_cast<std::int64_t>(time * days_per_time_); }
  [[nodiscard]] Index slot(std::int64_t day) const { return first_slot_ + static_cast<Index>(day & mask_); }
  Link& at(Index i) { return links_[static_cast<std::size_t>(i)]; }

  void unlink(Index entry) {
    const Link link = at(entry);
    at(link.next).previous = link.previous;
    at(link.previous).next = link.next;
    at(entry) = {entry, entry};
  }
  void link(Index entry, Index head) {
    const Index next = at(head).next;
    at(entry) = {next, head};
    at(next).previous = entry;
    at(head).next = entry;
  }

  double horizon_ = 0, days_per_time_ = 1;
  std::int64_t mask_ = 0, today_ = 0, last_ = 0, foreseen_ = 0;
  Index first_slot_ = 0;
  std::vector<Link, HugePages<Link>> links_;  // entries and times of the disks, then heads of the slots
};
using CalendarQueue = BasicCalendarQueue<>;

}  // namespace gpf
