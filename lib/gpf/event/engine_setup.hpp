// The engine's beginnings and ends: construction, states, checkpoints and the ways in which it refuses to go on.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <vector>

#include "gpf/event/engine.hpp"
#include "gpf/event/state_check.hpp"

namespace gpf {

template <class Queue, class Physics>
double Engine<Queue, Physics>::epoch_length(const Scene& scene) {
  return std::ldexp(1.0, std::ilogb(std::min(32 / scene.reference_collision_rate(), 2 / scene.velocity_scale())));
}

template <class Queue, class Physics>
Engine<Queue, Physics>::Engine(const Scene& scene, const EngineState& state, double disks_per_cell)
    : scene_(scene),
      physics_(scene),
      channel_(scene.geometry == Geometry::channel),
      foresees_(scene.particles >= fits_near_memory),
      grid_(scene.length(), 1),
      length_(grid_.round(scene.length())),
      lower_(channel_ ? grid_.round(scene.diameter() / 2) : 0),
      upper_(1 - lower_),
      gravity_(scene.gravity),
      epoch_length_(epoch_length(scene)),
      disks_per_cell_(disks_per_cell > 0 ? disks_per_cell : best_disks_per_cell),
      contact_time_(scene.diameter()),
      most_depth_(2 * scene.diameter() * detail::deepest_round_off(scene)),
      cells_(scene, lower_, upper_, length_, disks_per_cell_),
      epoch_(state.epoch),
      frame_velocity_(state.frame_velocity),
      frame_offset_(state.frame_offset),
      events_per_time_(2 * scene.particles * scene.reference_collision_rate()),
      trace_(state.trace_hash),
      counts_(state.counts) {
  detail::require_room(scene);
  detail::require_inside(scene, state);
  detail::require_apart(scene, state);
  const auto count = static_cast<std::size_t>(scene.particles);
  disks_.resize(count + 1);
  disks_.back().flight.x = disks_.back().flight.y = std::numeric_limits<double>::quiet_NaN();
  start_ = {std::vector<Flight>(count), std::vector<Plan>(count), std::vector<Index>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    start_.flights[i] = {grid_.round(state.x[i]), grid_.round(state.y[i]), state.vx[i], state.vy[i], 0};
    start_.plans[i].last_contact = state.last_contact[i];
    start_.ids[i] = static_cast<Index>(i);
  }
  begin_epoch();
}

namespace detail {

inline EngineState from_laboratory(const State& start) {
  EngineState state;
  for (const Vec2 r : start.position) state.x.push_back(r.x), state.y.push_back(r.y);
  for (const Vec2 v : start.velocity) state.vx.push_back(v.x), state.vy.push_back(v.y);
  state.last_contact.assign(start.position.size(), -never);
  return state;
}

}  // namespace detail

template <class Queue, class Physics>
Engine<Queue, Physics>::Engine(const Scene& scene, const State& start, double disks_per_cell)
    : Engine(scene, detail::from_laboratory(start), disks_per_cell) {}

template <class Queue, class Physics>
Vec2 Engine<Queue, Physics>::lab_position(const Flight& f, double t) const {
  const double lapse = t - f.time;
  return {f.x + f.vx * lapse + (frame_offset_ + t * (frame_velocity_ + 0.5 * gravity_ * t)), f.y + f.vy * lapse};
}

template <class Queue, class Physics>
State Engine<Queue, Physics>::state() const {
  const auto inside = [](double a, double period) {
    const double folded = a - period * std::floor(a / period);
    return folded < period ? folded : 0;  // a hair below zero would fold to the period itself
  };
  State state;
  state.position.resize(disks_.size() - 1);
  state.velocity.resize(disks_.size() - 1);
  for (Index i = 0; i < count(); ++i) {
    const Flight& f = disk(i).flight;
    const auto id = static_cast<std::size_t>(disk(i).id);
    Vec2 r = lab_position(f, now_);
    r.x = inside(r.x, length_);
    if (!channel_) r.y = inside(r.y, 1);
    state.position[id] = r;
    state.velocity[id] = {f.vx + frame_velocity_at(now_), f.vy};
  }
  return state;
}

template <class Queue, class Physics>
EngineState Engine<Queue, Physics>::checkpoint() const {
  if (now_ != 0)
    throw InputError("a checkpoint was asked for within an epoch", "disks are at different times there",
                     "advance to epoch_end() first");
  EngineState state{epoch_, frame_velocity_, frame_offset_, {}, {}, {}, {}, {}, trace_.value(), counts_};
  for (auto* values : {&state.x, &state.y, &state.vx, &state.vy, &state.last_contact})
    values->resize(disks_.size() - 1);
  for (Index i = 0; i < count(); ++i) {
    const auto id = static_cast<std::size_t>(disk(i).id);
    const Flight& f = disk(i).flight;
    state.x[id] = f.x, state.y[id] = f.y;
    state.vx[id] = f.vx, state.vy[id] = f.vy;
    state.last_contact[id] = plan(i).last_contact;
  }
  return state;
}

/// Stops a run whose collisions no longer advance time: 2^16 of them in a ten-millionth of the time that a gas needs.
template <class Queue, class Physics>
void Engine<Queue, Physics>::watch_for_collapse(double t) {
  const double expected = 2 * 0x1p16 / (scene_.particles * scene_.reference_collision_rate());
  if (watched_ >= 0 && t - watched_ < 1e-7 * expected)
    throw PhysicsError(fmt::format("inelastic collapse at time {:.6g}: 65536 collisions within {:.3g}",
                                   epoch_start() + t, t - watched_),
                       "disks collide ever faster and time comes to a stop",
                       "set tc_time (the default prevents it) or raise normal_restitution");
  watched_ = t;
}

template <class Queue, class Physics>
std::string Engine<Queue, Physics>::describe(Index i) const {
  const Place place = plan(i).place();
  const Flight& f = disk(i).flight;
  return fmt::format("disk {}: x {:.17g} y {:.17g} vx {:.17g} vy {:.17g} time {:.17g} cell ({}, {})", disk(i).id, f.x,
                     f.y, f.vx, f.vy, f.time, place.column, place.row);
}

template <class Queue, class Physics>
void Engine<Queue, Physics>::fail_backwards(Index i) const {
  throw PhysicsError(fmt::format("time runs backwards, from {:.17g} to {:.17g} in epoch {} ({})", now_, queue_.time(i),
                                 epoch_, describe(i)),
                     "an event was found too late", "this is a bug: report it with the scene and this message");
}

template <class Queue, class Physics>
void Engine<Queue, Physics>::fail_overlap(Index i) const {
  std::string others;
  for (Index j = 0; j < count(); ++j)
    for (const double shift_x : {-length_, 0.0, length_})
      for (const double shift_y : {-1.0, 0.0, 1.0}) {
        if (channel_ && shift_y != 0) continue;
        const Flight &a = disk(i).flight, &b = disk(j).flight;
        const Encounter<double> e = contact_time_.encounter(a, b, shift_x, shift_y);
        if (e.meet() && -e.gap > most_depth_) others += "; " + describe(j);
      }
  throw PhysicsError(
      fmt::format("two disks overlap beyond round-off and approach, epoch {} ({}{})", epoch_, describe(i), others),
      "a contact was missed or the start state overlaps",
      "check the start state; if gpf made it, this is a bug: report it with the scene and this message");
}

}  // namespace gpf
