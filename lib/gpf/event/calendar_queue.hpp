// The O(1) scheduler: a circular calendar of short unordered lists (Brown, CACM 31 (1988); Paul, J. Comput. Phys. 221
// (2007)), whose later weeks lie in sheaves until they come near.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/fetch.hpp"
#include "gpf/event/huge_pages.hpp"
#include "gpf/event/queue_meter.hpp"

namespace gpf {

/// One scheduled time per disk. A day holds the events of one stretch of time of about one event. This week and the
/// next are near: each of their days has a list. What is scheduled later is written to the end of its week's sheaf, so
/// that nothing waits for the memory of other disks; it is looked at when the week comes near, and dropped if its disk
/// has another time by then.
template <class Meter = NoMeter>
class BasicCalendarQueue {
 public:
  /// Empties the queue for `count` disks and times in [0, horizon]; later ones count as never. `events_per_time` sets
  /// the width of a day: it decides about speed only.
  void reset(std::size_t count, double horizon, double events_per_time) {
    horizon_ = horizon;
    days_per_time_ = std::min(events_per_time, 0x1p40 / horizon);
    // Of few disks nearly all events are near; of many, the heads of the near days should stay in near memory.
    const std::size_t days = count < many ? std::max(2 * count, std::min<std::size_t>(8 * count, 8192)) : 16384;
    const std::size_t near_days = std::bit_ceil(std::max<std::size_t>(days, 64));
    mask_ = static_cast<std::int64_t>(near_days) - 1;
    week_bits_ = std::countr_zero(near_days) - 1;
    first_slot_ = static_cast<Index>(2 * count);
    today_ = foreseen_ = named_ = 0;
    days_ahead_ = 12;
    last_ = day(horizon);
    near_end_ = static_cast<std::int64_t>(near_days);
    open_day_ = near_end_ / 2;
    links_.resize(2 * count + near_days);
    for (std::size_t k = 0; k < links_.size(); ++k) links_[k] = {static_cast<Index>(k), static_cast<Index>(k)};
    for (std::size_t i = 0; i < count; ++i) links_[2 * i + 1] = std::bit_cast<Link>(never);
    const std::int64_t weeks = std::min((last_ >> week_bits_) + 1, most_sheaves);
    sheaves_.assign(std::bit_ceil(static_cast<std::size_t>(weeks)), {});
    chunks_.clear();
    free_chunk_ = none;
  }

  void schedule(Index i, double time) {
    unlink(2 * i);
    at(2 * i + 1) = std::bit_cast<Link>(time);
    put(i, time);
  }

  /// The disk with the earliest time, -1 when nothing is scheduled. Of equal times the disk that comes first:
  /// first(a, b) says whether a comes before b.
  template <class First>
  [[nodiscard]] Index earliest(First&& first) {
    for (; today_ <= last_; ++today_) {
      if (today_ == open_day_) [[unlikely]]
        open_sheaf();
      const Index head = slot(today_);
      Index best = -1;
      double best_time = never;
      Meter::step();
      for (Index entry = at(head).next; entry != head; entry = at(entry).next) {
        Meter::step();
        const Index i = entry / 2;
        if (time(i) < best_time || (time(i) == best_time && best >= 0 && first(i, best))) {
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

  /// Names the disks whose events are coming, each once and some twelve events ahead, so that what they need can be
  /// fetched from memory meanwhile; coming(i).
  template <class Coming>
  void foresee(Coming&& coming) {
    while (foreseen_ < today_ + days_ahead_) {
      fetch(&at(at(slot(foreseen_ + 4)).next));
      const Index head = slot(foreseen_);
      for (Index entry = at(head).next; entry != head; entry = at(entry).next) {
        coming(entry / 2);
        ++named_;
      }
      if (++foreseen_ % days_counted == 0) [[unlikely]] {
        days_ahead_ = 12 * days_counted / std::clamp(named_, days_counted / 8, days_counted * 2);
        named_ = 0;
      }
    }
  }
  void fetch_entry(Index i) { fetch(&at(2 * i)); }
  /// Fetches what the entry of disk i is linked to.
  void fetch_links(Index i) {
    fetch(&at(at(2 * i).next));
    fetch(&at(at(2 * i).previous));
  }

 private:
  /// The entries of a day's disks and its head form a ring; an entry that is in no day is a ring of its own. Rings are
  /// linked and unlinked without a branch. The entry of disk i is link 2 i; its time lies beside it, in the place of
  /// link 2 i + 1.
  struct Link {
    Index next, previous;
  };
  /// Part of a sheaf: disks, and the times by which they are known to be scheduled still.
  struct Chunk {
    struct Entry {
      double time;
      Index disk;
    };
    static constexpr std::uint32_t room = 31;
    std::array<Entry, room> entries;
    Index next;
  };
  struct Sheaf {
    Index chunk = none;                 ///< the one that is being filled; those behind it are full
    std::uint32_t count = Chunk::room;  ///< of entries in it
  };
  static constexpr Index none = -1;
  static constexpr std::size_t many = 50'000;
  static constexpr std::int64_t most_sheaves = 4096;
  static constexpr std::int64_t days_counted = 1024;  ///< to know how many events a day has: a guess at first

  [[nodiscard]] std::int64_t day(double time) const { return static_cast<std::int64_t>(time * days_per_time_); }
  [[nodiscard]] Index slot(std::int64_t day) const { return first_slot_ + static_cast<Index>(day & mask_); }
  Link& at(Index i) { return links_[static_cast<std::size_t>(i)]; }
  Chunk& chunk_at(Index i) { return chunks_[static_cast<std::size_t>(i)]; }
  /// Of the week of a day. Weeks share a sheaf when there are very many.
  Sheaf& sheaf(std::int64_t day) {
    return sheaves_[static_cast<std::size_t>(day >> week_bits_) & (sheaves_.size() - 1)];
  }

  void put(Index i, double time) {
    if (time > horizon_) return;
    const std::int64_t its_day = std::max(day(time), today_);
    if (its_day < near_end_)
      link(2 * i, slot(its_day));
    else
      lay_up(i, time, sheaf(its_day));
  }

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

  [[gnu::noinline]] void lay_up(Index i, double time, Sheaf& sheaf) {
    if (sheaf.count == Chunk::room) {
      if (free_chunk_ == none) {
        free_chunk_ = static_cast<Index>(chunks_.size());
        chunks_.emplace_back().next = none;
      }
      const Index chunk = std::exchange(free_chunk_, chunk_at(free_chunk_).next);
      chunk_at(chunk).next = std::exchange(sheaf.chunk, chunk);
      sheaf.count = 0;
    }
    chunk_at(sheaf.chunk).entries[sheaf.count++] = {time, i};
  }

  /// With the first day of a week the next one comes near.
  [[gnu::noinline]] void open_sheaf() {
    Sheaf open = std::exchange(sheaf(near_end_), {});
    open_day_ += (mask_ + 1) / 2;
    near_end_ += (mask_ + 1) / 2;
    for (; open.chunk != none; open.count = Chunk::room) {
      const Chunk chunk = chunk_at(open.chunk);
      chunk_at(open.chunk).next = std::exchange(free_chunk_, open.chunk);
      open.chunk = chunk.next;
      for (std::uint32_t k = 0; k < open.count; ++k) fetch(&at(2 * chunk.entries[k].disk));
      for (std::uint32_t k = 0; k < open.count; ++k) {
        const auto& [time, i] = chunk.entries[k];
        if (this->time(i) == time && at(2 * i).next == 2 * i) put(i, time);
      }
    }
  }

  double horizon_ = 0, days_per_time_ = 1;
  std::int64_t mask_ = 0, today_ = 0, last_ = 0, near_end_ = 0, open_day_ = 0;
  std::int64_t foreseen_ = 0, days_ahead_ = 0, named_ = 0;  // days before it have been named; disks since a count
  int week_bits_ = 0;
  Index first_slot_ = 0;
  std::vector<Link, HugePages<Link>> links_;  // entries and times of the disks, then heads of the near days
  std::vector<Sheaf> sheaves_;
  std::vector<Chunk, HugePages<Chunk>> chunks_;
  Index free_chunk_ = none;
};
using CalendarQueue = BasicCalendarQueue<>;

}  // namespace gpf
