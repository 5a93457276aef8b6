#include "verify/audit/trace.hpp"

#include <fmt/format.h>

#include <bit>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"

namespace gpf {
namespace {

Engine<> engine_of(const Scene& scene, const std::optional<EngineState>& from) {
  return from ? Engine<>(scene, *from) : Engine<>(scene, start_state(scene));
}

std::uint64_t state_hash(const EngineState& state) {
  std::uint64_t hash = 0;
  const auto add = [&hash](double x) { hash = mix(hash ^ std::bit_cast<std::uint64_t>(x)); };
  for (const auto* numbers : {&state.x, &state.y, &state.vx, &state.vy})
    for (const double x : *numbers) add(x);
  add(state.frame_velocity);
  add(state.frame_offset);
  return hash;
}

EpochMark mark_of(const Engine<>& engine) {
  const EngineState state = engine.checkpoint();
  return {state.epoch, state.trace_hash, state.counts.pair_contacts + state.counts.wall_contacts, state_hash(state)};
}

struct ContactRecorder {
  std::vector<TracedContact> contacts;

  void on_pair(const PairContact& c) {
    contacts.push_back({c.time, c.first, c.second, {c.velocity_1.x, c.velocity_1.y, c.velocity_2.x, c.velocity_2.y}});
  }
  void on_wall(const WallContact& c) {
    contacts.push_back(
        {c.time, c.disk, c.wall == Wall::lower ? -1 : -2, {c.velocity_after.x, c.velocity_after.y, 0, 0}});
  }
};

}  // namespace

void trace_epochs(const Scene& scene, const std::optional<EngineState>& from, std::int64_t epochs,
                  const std::function<void(const EpochMark&)>& tell) {
  Engine<> engine = engine_of(scene, from);
  tell(mark_of(engine));
  for (std::int64_t k = 0; k < epochs; ++k) {
    engine.advance(engine.epoch_end());
    tell(mark_of(engine));
  }
}

std::vector<TracedContact> trace_contacts(const Scene& scene, const std::optional<EngineState>& from,
                                          std::int64_t epoch) {
  const std::int64_t first = from ? from->epoch + 1 : 1;
  if (epoch < first)
    throw InputError(fmt::format("there is no epoch {} to trace", epoch),
                     fmt::format("the first after the start is {}", first), "choose that or a later one");
  Engine<> engine = engine_of(scene, from);
  engine.advance(static_cast<double>(epoch - 1) * engine.epoch_length());
  // Observers are told the time since the start of the run, which has fewer bits than the one within the epoch. Called
  // epoch 0, the same epoch gives the same contacts with times that lose nothing.
  EngineState state = engine.checkpoint();
  state.epoch = 0;
  Engine<> replay(scene, state);
  ContactRecorder recorder;
  replay.advance(replay.epoch_end(), recorder);
  return std::move(recorder.contacts);
}

}  // namespace gpf
