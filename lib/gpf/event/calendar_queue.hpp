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
#include "gpf/event/plan.hpp"
#include "gpf/event/queue_meter.hpp"

namespace gpf {

/// One scheduled time per disk, and beside it the engine's plan for the disk, which the queue keeps and does not read;
/// reset() forgets both. A day holds the events of one stretch of time of about one event. This week and the
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
    const std::size_t days = count < many ? std::max(2 * count, std::min<std::size_t>(8 * count, 8192)) : 4096;
    const std::size_t near_days = std::bit_ceil(std::max<std::size_t>(days, 64));
    mask_ = static_cast<std::int64_t>(near_days) - 1;
    week_bits_ = std::countr_zero(near_days) - 1;
    first_slot_ = link_of(static_cast<Index>(count));
    today_ = foreseen_ = named_ = 0;
    days_ahead_ = events_ahead;
    last_ = day(horizon);
    near_end_ = static_cast<std::int64_t>(near_days);
    open_day_ = near_end_ / 2;
    memory_.resize(count + near_days * sizeof(Link) / sizeof(Entry));
    for (Index i = 0; i < static_cast<Index>(count); ++i) entry(i) = {{link_of(i), link_of(i)}, never, {}};
    Link* const heads = &at(first_slot_);
    for (Index k = 0; k < static_cast<Index>(near_days); ++k) heads[k] = {first_slot_ + k, first_slot_ + k};
    const std::int64_t weeks = std::min((last_ >> week_bits_) + 1, most_sheaves);
    sheaves_.assign(std::bit_ceil(static_cast<std::size_t>(weeks)), {});
    chunks_.clear();
    free_chunk_ = none;
  }

  void schedule(Index i, double time) {
    unlink(link_of(i));
    entry(i).time = time;
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
      for (Index link = at(head).next; link != head; link = at(link).next) {
        Meter::step();
        const Index i = disk_of(link);
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

  [[nodiscard]] double time(Index i) const { return entry(i).time; }
  Plan& plan(Index i) { return entry(i).plan; }
  [[nodiscard]] const Plan& plan(Index i) const { return entry(i).plan; }

  /// Names the disks whose events are coming, each once and some fifteen events ahead, so that what they need can be
  /// fetched from memory meanwhile; coming(i).
  template <class Coming>
  void foresee(Coming&& coming) {
    while (foreseen_ < today_ + days_ahead_) {
      fetch(&at(at(slot(foreseen_ + 4)).next));
      const Index head = slot(foreseen_);
      for (Index link = at(head).next; link != head; link = at(link).next) {
        coming(disk_of(link));
        ++named_;
      }
      if (++foreseen_ % days_counted == 0) [[unlikely]] {
        days_ahead_ = events_ahead * days_counted / std::clamp(named_, days_counted / 8, days_counted * 2);
        named_ = 0;
      }
    }
  }
  /// Fetches the time and the plan of disk i.
  void fetch_entry(Index i) const { fetch(&entry(i)); }

 private:
  /// The links of a day's disks and its head form a ring; one that is in no day is a ring of its own. Rings are linked
  /// and unlinked without a branch: they name links by their place in memory, whether these are parts of an entry or
  /// the heads of the near days, which lie close together behind all entries, for they should stay in near memory.
  struct Link {
    Index next, previous;
  };
  /// Of a disk: half a line.
  struct alignas(32) Entry {
    Link link;
    double time;
    Plan plan;
  };
  static_assert(sizeof(Entry) == 32 && offsetof(Entry, link) == 0 && sizeof(Entry) % sizeof(Link) == 0);
  struct alignas(Entry) Storage {
    std::array<std::byte, sizeof(Entry)> bytes;
  };
  /// Part of a sheaf: disks, and the times by which they are known to be scheduled still.
  struct Chunk {
    struct Item {
      double time;
      Index disk;
    };
    static constexpr std::uint32_t room = 31;
    std::array<Item, room> items;
    Index next;
  };
  struct Sheaf {
    Index chunk = none;                 ///< the one that is being filled; those behind it are full
    std::uint32_t count = Chunk::room;  ///< of items in it
  };
  static constexpr Index none = -1;
  static constexpr std::size_t many = 50'000;
  static constexpr std::int64_t most_sheaves = 4096;
  static constexpr std::int64_t events_ahead = 15;
  static constexpr std::int64_t days_counted = 1024;  ///< to know how many events a day has: a guess at first

  [[nodiscard]] std::int64_t day(double time) const { return static_cast<std::int64_t>(time * days_per_time_); }
  [[nodiscard]] Index slot(std::int64_t day) const { return first_slot_ + static_cast<Index>(day & mask_); }
  static Index link_of(Index disk) { return disk * static_cast<Index>(sizeof(Entry) / sizeof(Link)); }
  static Index disk_of(Index link) { return link / static_cast<Index>(sizeof(Entry) / sizeof(Link)); }
  [[nodiscard]] std::byte* address(Index i, std::size_t size) {
    return reinterpret_cast<std::byte*>(memory_.data()) + static_cast<std::size_t>(i) * size;
  }
  Entry& entry(Index disk) { return *reinterpret_cast<Entry*>(address(disk, sizeof(Entry))); }
  Link& at(Index link) { return *reinterpret_cast<Link*>(address(link, sizeof(Link))); }
  [[nodiscard]] const Entry& entry(Index disk) const { return const_cast<BasicCalendarQueue*>(this)->entry(disk); }
  Chunk& chunk_at(Index i) { return chunks_[static_cast<std::size_t>(i)]; }
  /// Of the week of a day. Weeks share a sheaf when there are very many.
  Sheaf& sheaf(std::int64_t day) {
    return sheaves_[static_cast<std::size_t>(day >> week_bits_) & (sheaves_.size() - 1)];
  }

  void put(Index i, double time) {
    if (time > horizon_) return;
    const std::int64_t its_day = std::max(day(time), today_);
    if (its_day < near_end_)
      link(link_of(i), slot(its_day));
    else
      lay_up(i, time, sheaf(its_day));
  }

  void unlink(Index mine) {
    const Link link = at(mine);
    at(link.next).previous = link.previous;
    at(link.previous).next = link.next;
    at(mine) = {mine, mine};
  }
  void link(Index mine, Index head) {
    const Index next = at(head).next;
    at(mine) = {next, head};
    at(next).previous = mine;
    at(head).next = mine;
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
    chunk_at(sheaf.chunk).items[sheaf.count++] = {time, i};
  }

  /// With the first day of a week the next one comes near. Its chunks are fetched two ahead, and their disks one ahead.
  [[gnu::noinline]] void open_sheaf() {
    Sheaf open = std::exchange(sheaf(near_end_), {});
    open_day_ += (mask_ + 1) / 2;
    near_end_ += (mask_ + 1) / 2;
    fetch_disks(open.chunk, open.count);
    for (; open.chunk != none; open.count = Chunk::room) {
      const Index next = chunk_at(open.chunk).next;
      fetch_disks(next, Chunk::room);
      for (std::uint32_t k = 0; k < open.count; ++k) {
        const auto [time, i] = chunk_at(open.chunk).items[k];
        if (this->time(i) == time && entry(i).link.next == link_of(i)) put(i, time);
      }
      chunk_at(open.chunk).next = std::exchange(free_chunk_, open.chunk);
      open.chunk = next;
    }
  }
  /// Fetches the entries that the first items of a chunk name, and the chunk after it.
  void fetch_disks(Index chunk, std::uint32_t items) {
    if (chunk == none) return;
    for (std::uint32_t k = 0; k < items; ++k) fetch_entry(chunk_at(chunk).items[k].disk);
    const Index next = chunk_at(chunk).next;
    if (next == none) return;
    const auto* const bytes = reinterpret_cast<const std::byte*>(&chunk_at(next));
    for (std::size_t line = 0; line < sizeof(Chunk); line += 64) fetch(bytes + line);
  }

  double horizon_ = 0, days_per_time_ = 1;
  std::int64_t mask_ = 0, today_ = 0, last_ = 0, near_end_ = 0, open_day_ = 0;
  std::int64_t foreseen_ = 0, days_ahead_ = 0, named_ = 0;  // days before it have been named; disks since a count
  int week_bits_ = 0;
  Index first_slot_ = 0;
  std::vector<Storage, HugePages<Storage>> memory_;  // of the entries, then of the heads
  std::vector<Sheaf> sheaves_;
  std::vector<Chunk, HugePages<Chunk>> chunks_;
  Index free_chunk_ = none;
};
using CalendarQueue = BasicCalendarQueue<>;

}  // namespace gpf
