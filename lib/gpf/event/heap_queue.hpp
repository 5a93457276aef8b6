// The reference scheduler: the implicit binary heap of the thesis (sec. 2.3.3), O(log N).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/plan.hpp"
#include "gpf/event/queue_meter.hpp"

namespace gpf {

/// One scheduled time per disk, and beside it the engine's plan for the disk, which the queue keeps and does not read;
/// reset() forgets both. `heap_` is the thesis' pht, `place_` its inverse pth.
template <class Meter = NoMeter>
class BasicHeapQueue {
 public:
  /// Empties the queue for `count` disks and times in [0, horizon]; later ones count as never.
  void reset(std::size_t count, double horizon, double /*events_per_time*/) {
    horizon_ = horizon;
    time_.assign(count, never);
    plan_.assign(count, {});
    heap_.resize(count);
    place_.resize(count);
    for (std::size_t k = 0; k < count; ++k) heap_[k] = place_[k] = static_cast<Index>(k);
  }

  void schedule(Index i, double time) {
    time_[slot(i)] = time <= horizon_ ? time : never;
    rise(slot(place_[slot(i)]));
    sink(slot(place_[slot(i)]));
  }

  /// The disk with the earliest time, -1 when nothing is scheduled. Of equal times the disk that comes first:
  /// first(a, b) says whether a comes before b.
  template <class First>
  [[nodiscard]] Index earliest(First&& first) const {
    if (heap_.empty() || time(heap_[0]) == never) return -1;
    return first_of_ties(0, heap_[0], first);
  }

  [[nodiscard]] double time(Index i) const { return time_[slot(i)]; }
  Plan& plan(Index i) { return plan_[slot(i)]; }
  [[nodiscard]] const Plan& plan(Index i) const { return plan_[slot(i)]; }

  /// Foresees nothing: what comes after the earliest is not in order here.
  template <class Coming>
  void foresee(Coming&&) const {}
  void fetch_entry(Index) const {}

 private:
  static std::size_t slot(Index i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool before(std::size_t a, std::size_t b) const {
    Meter::step();
    return time(heap_[a]) < time(heap_[b]);
  }

  /// The first of `best` and the disks below place k that share its time: equal times hang together at the top.
  template <class First>
  [[nodiscard]] Index first_of_ties(std::size_t k, Index best, First&& first) const {
    for (const std::size_t child : {2 * k + 1, 2 * k + 2}) {
      if (child >= heap_.size() || time(heap_[child]) != time(heap_[0])) continue;
      if (first(heap_[child], best)) best = heap_[child];
      best = first_of_ties(child, best, first);
    }
    return best;
  }

  void exchange(std::size_t a, std::size_t b) {
    std::swap(heap_[a], heap_[b]);
    place_[slot(heap_[a])] = static_cast<Index>(a);
    place_[slot(heap_[b])] = static_cast<Index>(b);
  }

  void rise(std::size_t k) {
    for (; k > 0 && before(k, (k - 1) / 2); k = (k - 1) / 2) exchange(k, (k - 1) / 2);
  }

  void sink(std::size_t k) {
    for (std::size_t child = 2 * k + 1; child < heap_.size(); k = child, child = 2 * k + 1) {
      if (child + 1 < heap_.size() && before(child + 1, child)) ++child;
      if (!before(child, k)) return;
      exchange(k, child);
    }
  }

  double horizon_ = 0;
  std::vector<double> time_;
  std::vector<Plan> plan_;
  std::vector<Index> heap_, place_;
};
using HeapQueue = BasicHeapQueue<>;

}  // namespace gpf
