// The O(1) scheduler: a circular calendar of short unordered lists (Brown, CACM 31 (1988); Paul, J. Comput. Phys. 221
// (2007)).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
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
    const std::size_t slots = std::bit_ceil(std::max<std::size_t>(4 * count, 64));
    mask_ = static_cast<std::int64_t>(slots) - 1;
    today_ = foreseen_ = 0;
    scheduled_ = 0;
    front_.assign(slots, -1);
    entries_.assign(count, Entry{});
  }

  void schedule(Index i, double time) {
    Entry& entry = at(i);
    if (entry.previous != out) unlink(entry);
    entry.time = time;
    entry.previous = out;
    if (!(time <= horizon_)) return;
    const std::int64_t slot = std::max(day(time), today_) & mask_;
    Index& front = front_of(slot);
    entry.next = front;
    entry.previous = first_of(slot);
    if (front >= 0) at(front).previous = i;
    front = i;
    ++scheduled_;
  }

  /// The disk with the earliest time, -1 when nothing is scheduled. Of equal times the disk that comes first:
  /// first(a, b) says whether a comes before b.
  template <class First>
  [[nodiscard]] Index earliest(First&& first) {
    if (scheduled_ == 0) return -1;
    for (;; ++today_) {
      Index best = -1;
      double best_time = never;
      Meter::step();
      for (Index i = front_of(today_); i >= 0; i = at(i).next) {
        Meter::step();
        if (day(at(i).time) <= today_ &&
            (at(i).time < best_time || (at(i).time == best_time && best >= 0 && first(i, best)))) {
          best = i;
          best_time = at(i).time;
        }
      }
      if (best >= 0) return best;
    }
  }

  [[nodiscard]] double time(Index i) const { return entries_[static_cast<std::size_t>(i)].time; }

  /// Names disks whose events are coming (and some others), each first to far(i), later to near(i) and last to
  /// next(i), so that what they need can be fetched from memory meanwhile.
  template <class Far, class Near, class Next>
  void foresee(Far&& far, Near&& near, Next&& next) {
    for (; foreseen_ < today_; ++foreseen_) {
      const Index front = front_of(foreseen_ + 40);
      if (front >= 0) __builtin_prefetch(&at(front));
      for (Index i = front_of(foreseen_ + 24); i >= 0; i = at(i).next) far(i);
      for (Index i = front_of(foreseen_ + 12); i >= 0; i = at(i).next) near(i);
      for (Index i = front_of(foreseen_ + 6); i >= 0; i = at(i).next) next(i);
    }
  }

 private:
  static constexpr Index out = std::numeric_limits<Index>::min();  ///< `previous` of one that is not in the calendar

  struct Entry {
    double time = never;
    Index next = -1;
    Index previous = out;  ///< or first_of(slot)
  };

  static Index first_of(std::int64_t slot) { return static_cast<Index>(~slot); }
  [[nodiscard]] std::int64_t day(double time) const { return static_cast<std::int64_t>(time * days_per_time_); }
  [[nodiscard]] Index& front_of(std::int64_t day) { return front_[static_cast<std::size_t>(day & mask_)]; }
  Entry& at(Index i) { return entries_[static_cast<std::size_t>(i)]; }

  void unlink(const Entry& entry) {
    if (entry.next >= 0) at(entry.next).previous = entry.previous;
    if (entry.previous >= 0)
      at(entry.previous).next = entry.next;
    else
      front_of(~entry.previous) = entry.next;
    --scheduled_;
  }

  double horizon_ = 0, days_per_time_ = 1;
  std::int64_t mask_ = 0, today_ = 0, foreseen_ = 0;
  std::size_t scheduled_ = 0;
  std::vector<Index, HugePages<Index>> front_;
  std::vector<Entry, HugePages<Entry>> entries_;
};
using CalendarQueue = BasicCalendarQueue<>;

}  // namespace gpf
