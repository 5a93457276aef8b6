// How the engine begins and ends: epochs, states, checkpoints, and its refusals to go on.
#include "gpf/event/engine_setup.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "gpf/event/heap_queue.hpp"
#include "gpf/scene/start.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

bool mentions(const Error& error, const std::string& text) {
  return std::string(error.what()).find(text) != std::string::npos;
}

/// Gives the latest event first: what a scheduler with a fault could do.
struct BackwardQueue : HeapQueue {
  void reset(std::size_t count, double horizon, double rate) {
    HeapQueue::reset(count, horizon, rate);
    count_ = static_cast<Index>(count);
  }
  template <class... Arguments>
  [[nodiscard]] Index earliest(Arguments&&...) const {
    Index latest = -1;
    for (Index i = 0; i < count_; ++i)
      if (time(i) != never && (latest < 0 || time(i) > time(latest))) latest = i;
    return latest;
  }
  Index count_ = 0;
};

/// Loses all events of the first epoch.
struct DeafQueue : HeapQueue {
  void reset(std::size_t count, double horizon, double events_per_time) {
    HeapQueue::reset(count, horizon, events_per_time);
    ++epochs_;
  }
  void schedule(Index i, double time) {
    if (epochs_ > 1) HeapQueue::schedule(i, time);
  }

 private:
  int epochs_ = 0;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(engine_setup)

BOOST_AUTO_TEST_CASE(epochs_are_powers_of_two_below_32_mean_free_times_and_two_crossings) {
  for (const Scene& scene : {test::gas(2, 0.001), test::gas(100, 0.05), test::gas(1000, 0.7),
                             test::channel(900, 0.3, 31), test::channel(20, 0.01, 9)}) {
    const double length = Engine<>::epoch_length(scene);
    const double bound = std::min(32 / scene.reference_collision_rate(), 2 / scene.velocity_scale());
    BOOST_TEST(length <= bound);
    BOOST_TEST(2 * length > bound);
    BOOST_TEST(std::exp2(std::round(std::log2(length))) == length);
  }
  Scene scene = test::channel(900, 0.3, 31);
  const double length = Engine<>::epoch_length(scene);
  scene.gravity *= 4;
  BOOST_TEST(Engine<>::epoch_length(scene) == length / 2);
}

BOOST_AUTO_TEST_CASE(time_is_counted_in_epochs) {
  const Scene scene = test::gas(50, 0.3);
  Engine<> engine(scene, start_state(scene));
  const double epoch = engine.epoch_length();
  BOOST_TEST(engine.at_epoch_start());
  BOOST_TEST(engine.epoch_end() == epoch);
  engine.advance(2.5 * epoch);
  BOOST_TEST(!engine.at_epoch_start());
  BOOST_TEST(engine.time() == 2.5 * epoch);
  BOOST_TEST(engine.epoch_end() == 3 * epoch);
  engine.advance(3 * epoch);
  BOOST_TEST(engine.at_epoch_start());
  BOOST_TEST(engine.epoch_end() == 4 * epoch);
}

BOOST_AUTO_TEST_CASE(the_start_is_given_back) {
  for (const Scene& scene : {test::gas(50, 0.3), test::channel(50, 0.3, 7)}) {
    const State start = start_state(scene);
    const State now = Engine<>(scene, start).state();
    const double half = PositionGrid(scene.length(), 1).quantum() / 2;
    for (std::size_t i = 0; i < 50; ++i) {
      // Positions go to the nearest multiple of the quantum, velocities stay.
      BOOST_TEST(std::abs(now.position[i].x - start.position[i].x) <= half);
      BOOST_TEST(std::abs(now.position[i].y - start.position[i].y) <= half);
      BOOST_TEST((now.velocity[i] == start.velocity[i]));
    }
  }
}

BOOST_AUTO_TEST_CASE(states_of_other_scenes_and_outside_the_box_are_refused) {
  const Scene scene = test::channel(50, 0.3, 7);
  State start = start_state(scene);
  BOOST_CHECK_THROW(Engine<>(test::channel(51, 0.3, 7), start), InputError);
  start.position[17].y = 0.03;
  BOOST_CHECK_EXCEPTION(Engine<>(scene, start), InputError, [](auto& e) { return mentions(e, "disk 17: "); });
  Scene tight = test::gas(2, 0.1);
  tight.length_over_width = 2 * tight.diameter();
  BOOST_CHECK_THROW(Engine<>(tight, State{{{0, 0}, {0.1, 0.5}}, {{0, 0}, {0, 0}}}), InputError);
}

BOOST_AUTO_TEST_CASE(a_start_that_overlaps_is_refused_however_the_disks_move) {
  const Scene scene = test::gas(50, 0.3);
  for (const Vec2 v : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 0}, Vec2{0, 1}}) {
    State start = start_state(scene);
    start.position[31] = start.position[7] + Vec2{0.9 * scene.diameter(), 0};
    if (start.position[31].x > scene.length()) start.position[31].x -= scene.length();
    start.velocity[7] = {0, 0};
    start.velocity[31] = v;
    BOOST_CHECK_EXCEPTION(Engine<>(scene, start), PhysicsError, [](auto& error) {
      return mentions(error, "overlap") && mentions(error, "disk 7: x ") && mentions(error, "disk 31: x ");
    });
  }
}

BOOST_AUTO_TEST_CASE(a_missed_contact_is_noticed_and_both_disks_are_described) {
  // Contact at d = 1/8 after 1.9 of the 2 units of time in an epoch; at its end the disks overlap by .01.
  Scene scene = test::gas(2, 0.01);
  scene.width_over_diameter = 8;
  const State start{{{0.3, 0.5}, {0.3 + 0.125 + 0.19, 0.5}}, {{0.1, 0}, {0, 0}}};
  Engine<DeafQueue> engine(scene, start);
  BOOST_TEST(engine.epoch_length() == 2);
  BOOST_CHECK_EXCEPTION(engine.advance(3), PhysicsError, [](auto& error) {
    return mentions(error, "overlap beyond round-off") && mentions(error, "epoch 1") &&
           mentions(error, "disk 0: x 0.5 ") && mentions(error, "disk 1: x 0.6");
  });
}

BOOST_AUTO_TEST_CASE(time_that_runs_backwards_is_noticed) {
  const Scene scene = test::gas(50, 0.3);
  Engine<BackwardQueue> engine(scene, start_state(scene));
  BOOST_CHECK_EXCEPTION(engine.advance(engine.epoch_length()), PhysicsError,
                        [](auto& error) { return mentions(error, "time runs backwards"); });
}

BOOST_AUTO_TEST_CASE(a_checkpoint_within_an_epoch_is_refused) {
  const Scene scene = test::gas(50, 0.3);
  Engine<> engine(scene, start_state(scene));
  engine.advance(0.75 * engine.epoch_length());
  BOOST_CHECK_THROW((void)engine.checkpoint(), InputError);
}

BOOST_AUTO_TEST_CASE(a_checkpoint_of_a_resumed_engine_is_the_same_to_the_bit) {
  for (const Scene& scene : {test::gas(50, 0.3), test::channel(50, 0.3, 7)}) {
    Engine<> engine(scene, start_state(scene));
    engine.advance(5 * engine.epoch_length());
    const EngineState a = engine.checkpoint(), b = Engine<>(scene, a).checkpoint();
    BOOST_TEST(a.epoch == 5);
    BOOST_TEST(a.epoch == b.epoch);
    BOOST_TEST((a.x == b.x && a.y == b.y && a.vx == b.vx && a.vy == b.vy));
    BOOST_TEST((a.last_contact == b.last_contact));
    BOOST_TEST(a.frame_velocity == b.frame_velocity);
    BOOST_TEST(a.frame_offset == b.frame_offset);
    BOOST_TEST(a.trace_hash == b.trace_hash);
    BOOST_TEST(a.counts.pair_contacts == b.counts.pair_contacts);
    BOOST_TEST(a.counts.wall_contacts == b.counts.wall_contacts);
    for (const double time : a.last_contact) BOOST_TEST(time <= 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
