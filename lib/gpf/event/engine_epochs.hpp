// The engine's epochs: at the start of each all disks are brought to one time, the frame is boosted to the mean flow,
// the disks are put in the order of their cells, and everything is predicted anew.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/event/crowding.hpp"
#include "gpf/event/engine.hpp"

namespace gpf {

template <class Queue, class Physics>
template <class Observer>
void Engine<Queue, Physics>::advance(double time, Observer&& observer) {
  while (time >= epoch_end()) {
    run_until(epoch_length_, observer);
    next_epoch();
  }
  if (time > this->time()) run_until(time - epoch_start(), observer);
}

template <class Queue, class Physics>
void Engine<Queue, Physics>::next_epoch() {
  for (Index i = 0; i < count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    start_.flights[k] = flown(disk(i).flight, epoch_length_);
    start_.flights[k].time = 0;
    start_.plans[k] = plan(i);
    start_.plans[k].last_contact -= epoch_length_;
    start_.ids[k] = disk(i).id;
  }
  frame_offset_ += epoch_length_ * (frame_velocity_ + 0.5 * gravity_ * epoch_length_);
  frame_offset_ -= length_ * std::floor(frame_offset_ / length_);
  frame_velocity_ = frame_velocity_at(epoch_length_);
  events_per_time_ = static_cast<double>(counts_.examined() - events_before_) / epoch_length_;
  watched_ = -1;
  ++epoch_;
  boost();
  begin_epoch();
}

/// Takes the frame to the mean flow, less half of the coming fall, so that disks cross few cells. The mean is summed in
/// fixed point: exact in any order.
template <class Queue, class Physics>
void Engine<Queue, Physics>::boost() {
  if (gravity_ == 0) return;
  auto& flights = start_.flights;
  const double unit = scene_.velocity_scale() * 0x1p-30;
  std::int64_t sum = 0;
  for (const Flight& f : flights) sum += static_cast<std::int64_t>(f.vx / unit);
  const double mean = static_cast<double>(sum) / static_cast<double>(flights.size()) * unit;
  const double step = mean - 0.5 * gravity_ * epoch_length_;
  for (Flight& f : flights) f.vx -= step;
  frame_velocity_ += step;
}

template <class Queue, class Physics>
void Engine<Queue, Physics>::begin_epoch() {
  now_ = 0;
  events_before_ = counts_.examined();
  settle();
  const Cells::Around anywhere = cells_.around({}, Block::all);
  coming_.fill({.around = anywhere, .partner_around = anywhere});
  for (Index i = 0; i < count(); ++i) look<true>(std::array{i}, Block::all);
}

/// Puts the disks into their cells, and neighbours beside each other in memory: disks are renumbered along the cells,
/// in the queue, which is empty then, too. Changes no trajectory, for they keep their ids.
template <class Queue, class Physics>
void Engine<Queue, Physics>::settle() {
  auto& [flights, plans, ids] = start_;
  const double crowded = std::max(1.0, crowding(flights, length_, lower_, upper_));
  cells_.divide(disks_per_cell_ / std::min(square(crowded), most_shrinking));
  std::vector<Index> first(cells_.orders() + 1, 0);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    plans[k].move_to(cells_.locate(flights[k]));
    ++first[cells_.order(plans[k].place()) + 1];
  }
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  queue_.reset(ids.size(), epoch_length_, events_per_time_);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Index i = first[cells_.order(plans[k].place())]++;
    plan(i) = plans[k];
    disk(i).begin(flights[k]);
    disk(i).events = 0;
    disk(i).id = ids[k];
    cells_.insert(plans[k].place(), i);
  }
}

}  // namespace gpf
