// The engine's beginnings and ends: construction, states, checkpoints and the ways in which it refuses to go on.
#pragma once

#include <fmt/format.h>

#include "gpf/event/engine.hpp"

namespace gpf {

template <class Queue, class Physics>
double Engine<Queue, Physics>::epoch_length(const Scene& scene) {
  double length = 32 / scene.reference_collision_rate();
  if (scene.gravity > 0) length = std::min(length, 2 / scene.velocity_scale());
  return std::ldexp(1.0, std::ilogb(length));
}

namespace detail {

/// Overlap that round-off can explain, a length: 2^-46 of the longest side, a few hundred ulp of a coordinate.
inline double deepest_round_off(const Scene& scene) { return std::max(scene.length(), 1.0) * 0x1p-46; }

/// Measured optimum on N = 10^3 ... 10^6 (tests/performance): large cells when dilute, small ones when dense.
inline double best_disks_per_cell(double area_fraction) { return std::clamp(0.9 / std::sqrt(area_fraction), 1.0, 4.0); }

}  // namespace detail

template <class Queue, class Physics>
Engine<Queue, Physics>::Engine(const Scene& scene, const EngineState& state, double disks_per_cell)
    : scene_(scene),
      physics_(scene),
      channel_(scene.geometry == Geometry::channel),
      grid_(scene.length(), 1),
      length_(grid_.round(scene.length())),
      lower_(channel_ ? grid_.round(scene.diameter() / 2) : 0),
      upper_(1 - lower_),
      gravity_(scene.gravity),
      epoch_length_(epoch_length(scene)),
      contact_time_(scene.diameter(), detail::deepest_round_off(scene)),
      cells_(scene, lower_, upper_, length_,
             disks_per_cell > 0 ? disks_per_cell : detail::best_disks_per_cell(scene.area_fraction())),
      epoch_(state.epoch),
      frame_velocity_(state.frame_velocity),
      frame_offset_(state.frame_offset),
      events_per_time_(2 * scene.particles * scene.reference_collision_rate()),
      trace_(state.trace_hash),
      counts_(state.counts) {
  const auto count = static_cast<std::size_t>(scene.particles);
  for (const auto* values : {&state.x, &state.y, &state.vx, &state.vy, &state.last_contact})
    if (values->size() != count)
      throw InputError(fmt::format("the state has {} disks, the scene {}", values->size(), count),
                       "they belong to different scenes", "start from a state of this scene");
  plans_.resize(count);
  std::vector<Flight> flights(count);
  for (std::size_t i = 0; i < count; ++i) {
    flights[i] = {grid_.round(state.x[i]), grid_.round(state.y[i]), state.vx[i], state.vy[i], 0};
    plans_[i].last_contact = state.last_contact[i];
    plans_[i].id = static_cast<Index>(i);
  }
  begin_epoch(flights);
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
  State state;
  state.position.resize(plans_.size());
  state.velocity.resize(plans_.size());
  for (const Plan& plan : plans_) {
    const Flight f = cells_.flight(plan.place.slot);
    Vec2 r = lab_position(f, now_);
    r.x -= length_ * std::floor(r.x / length_);
    if (!channel_) r.y -= std::floor(r.y);
    state.position[static_cast<std::size_t>(plan.id)] = r;
    state.velocity[static_cast<std::size_t>(plan.id)] = {f.vx + frame_velocity_at(now_), f.vy};
  }
  return state;
}

template <class Queue, class Physics>
EngineState Engine<Queue, Physics>::checkpoint() const {
  if (now_ != 0)
    throw InputError("a checkpoint was asked for within an epoch", "disks are at different times there",
                     "advance to epoch_end() first");
  EngineState state{epoch_, frame_velocity_, frame_offset_, {}, {}, {}, {}, {}, trace_.value(), counts_};
  for (auto* values : {&state.x, &state.y, &state.vx, &state.vy, &state.last_contact}) values->resize(plans_.size());
  for (const Plan& plan : plans_) {
    const auto id = static_cast<std::size_t>(plan.id);
    const Flight f = cells_.flight(plan.place.slot);
    state.x[id] = f.x, state.y[id] = f.y;
    state.vx[id] = f.vx, state.vy[id] = f.vy;
    state.last_contact[id] = plan.last_contact;
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
void Engine<Queue, Physics>::fail_overlap(Index i, Index j) const {
  const auto describe = [&](Index k) {
    const Plan& plan = plans_[static_cast<std::size_t>(k)];
    const Flight f = cells_.flight(plan.place.slot);
    return fmt::format("disk {}: x {:.17g} y {:.17g} vx {:.17g} vy {:.17g} time {:.17g} cell ({}, {})", plan.id, f.x,
                       f.y, f.vx, f.vy, f.time, plan.place.column, plan.place.row);
  };
  throw PhysicsError(fmt::format("two disks overlap beyond round-off and approach, epoch {} ({}; {})", epoch_,
                                 describe(i), describe(j)),
                     "a contact was missed or the start state overlaps",
                     "check the start state; if gpf made it, this is a bug: report it with the scene and this message");
}

}  // namespace gpf
