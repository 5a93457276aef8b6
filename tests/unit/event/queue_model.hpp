// What every queue must do, told by an ordered set; shared by the tests of the queues.
#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "gpf/base/random.hpp"
#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/plan.hpp"

namespace gpf::test {

/// Of equal times the highest index comes first: not an order in which any queue would come upon them by itself.
template <class Queue>
Index earliest(Queue& queue) {
  return queue.earliest([](Index a, Index b) { return a > b; });
}

/// The queue beside its model, through random schedules.
template <class Queue>
class QueueModel {
 public:
  QueueModel(std::size_t count, double horizon, double events_per_time)
      : horizon_(horizon), time_(count, never), count_(count) {
    queue_.reset(count, horizon, events_per_time);
    for (Index i = 0; i < static_cast<Index>(count); ++i) queue_.plan(i) = {-1.0 * i, i, 7, Side::upper};
  }

  /// That each plan is as it was given; after a reset none is.
  void check_plans() {
    for (Index i = 0; i < static_cast<Index>(count_); ++i)
      BOOST_REQUIRE((queue_.plan(i).last_contact == -i && queue_.plan(i).place() == Place{i, 7} &&
                     queue_.plan(i).side == Side::upper));
    queue_.reset(count_, horizon_, 1);
    for (Index i = 0; i < static_cast<Index>(count_); ++i) BOOST_REQUIRE(queue_.plan(i).last_contact == -never);
  }

  void schedule(Index i, double time) {
    auto& known = time_[static_cast<std::size_t>(i)];
    model_.erase({known, -i});
    known = time <= horizon_ ? time : never;
    if (known != never) model_.insert({known, -i});
    queue_.schedule(i, time);
  }

  /// The earliest disk, after a check of it against the model.
  Index earliest() {
    const Index expected = model_.empty() ? -1 : -model_.begin()->second;
    const Index found = test::earliest(queue_);
    // What it foresees must exist and may change nothing.
    queue_.foresee([this](Index i) { BOOST_REQUIRE((i >= 0 && i < static_cast<Index>(count_))); });
    BOOST_REQUIRE(found == expected);
    if (found >= 0) BOOST_REQUIRE(queue_.time(found) == model_.begin()->first);
    return found;
  }

  /// As an engine would: the earliest is rescheduled later, others now and then, earlier or later, some never; times
  /// are multiples of `step`, so that with a coarse one many are equal.
  void run(int events, std::uint64_t seed, double mean_wait, double step) {
    const auto rounded = [step](double t) { return step > 0 ? step * std::floor(t / step) : t; };
    double now = 0;
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(events); ++k) {
      const auto words = random_words(seed, 1, k);
      const auto uniform = [&](std::size_t w) { return (words[w] + 0.5) * 0x1p-32; };
      const Index i = earliest();
      if (i >= 0) now = queue_.time(i);
      const auto other = static_cast<Index>(words[0] % count_);
      const double later = now - mean_wait * std::log(uniform(1));
      if (words[2] % 8 == 0) schedule(other, words[3] % 4 == 0 ? never : rounded(later));
      if (words[2] % 16 == 1) schedule(other, now);
      if (i >= 0)
        schedule(i, words[2] % 64 == 2 ? never : std::max(now, rounded(now - mean_wait * std::log(uniform(3)))));
    }
  }

 private:
  double horizon_;
  std::vector<double> time_;
  std::size_t count_;
  Queue queue_;
  std::set<std::pair<double, Index>> model_;  // by time, then -index
};

template <class Queue>
void queue_follows_its_model(double events_per_time) {
  for (const std::size_t count : {1u, 2u, 3u, 7u, 64u, 1000u})
    for (const double step : {0.0, 0.125}) {
      QueueModel<Queue> model(count, 64, events_per_time);
      for (Index i = 0; i < static_cast<Index>(count); ++i) model.schedule(i, step * i + 0.01 * (i % 5));
      model.run(20000, 17 + count, 0.5, step);
      model.check_plans();
    }
}

template <class Queue>
void queue_without_disks_or_events_has_no_earliest() {
  Queue queue;
  queue.reset(0, 1, 100);
  BOOST_TEST(earliest(queue) == -1);
  queue.reset(3, 1, 100);
  BOOST_TEST(earliest(queue) == -1);
  for (Index i = 0; i < 3; ++i) queue.schedule(i, never);
  BOOST_TEST(earliest(queue) == -1);
  queue.schedule(1, 0.5);
  BOOST_TEST(earliest(queue) == 1);
  queue.schedule(1, never);
  BOOST_TEST(earliest(queue) == -1);
}

template <class Queue>
void queue_forgets_what_lies_beyond_its_horizon() {
  Queue queue;
  queue.reset(2, 0.5, 100);
  queue.schedule(0, std::nextafter(0.5, 1.0));
  BOOST_TEST(earliest(queue) == -1);
  queue.schedule(1, 0.5);
  BOOST_TEST(earliest(queue) == 1);
  queue.schedule(1, 0.75);
  BOOST_TEST(earliest(queue) == -1);
}

template <class Queue>
void queue_takes_times_before_the_earliest_it_has_given() {
  Queue queue;
  queue.reset(3, 1, 1000);
  queue.schedule(0, 0.9);
  BOOST_TEST(earliest(queue) == 0);
  queue.schedule(1, 0.95);
  queue.schedule(2, 0.1);
  BOOST_TEST(earliest(queue) == 2);
  BOOST_TEST(queue.time(2) == 0.1);
  queue.schedule(2, never);
  BOOST_TEST(earliest(queue) == 0);
}

template <class Queue>
void queue_lets_the_caller_order_equal_times() {
  // All of many, then without the first, and so on to none; one earlier and one later take no part.
  constexpr Index count = 50;
  Queue queue;
  queue.reset(count + 2, 1, 40);
  queue.schedule(count, 0.25);
  queue.schedule(count + 1, 0.75);
  for (Index k = 0; k < count; ++k) queue.schedule(k * 29 % count, 0.5);
  BOOST_TEST(earliest(queue) == count);
  queue.schedule(count, never);
  for (Index k = count - 1; k >= 0; --k) {
    BOOST_TEST(earliest(queue) == k);
    queue.schedule(k, never);
  }
  BOOST_TEST(earliest(queue) == count + 1);
}

template <class Queue>
void queue_is_empty_after_a_reset() {
  Queue queue;
  queue.reset(5, 1, 10);
  for (Index i = 0; i < 5; ++i) queue.schedule(i, 0.1 * i);
  queue.reset(4, 2, 20);
  BOOST_TEST(earliest(queue) == -1);
  queue.schedule(3, 1.5);
  BOOST_TEST(earliest(queue) == 3);
}

}  // namespace gpf::test
