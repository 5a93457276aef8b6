// What must not matter to a trajectory, to the last bit: cells, queue, how far each call advances, a stop and a resume,
// and how late it is.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "gpf/event/crowding.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/event/heap_queue.hpp"
#include "gpf/scene/start.hpp"
#include "support/contact_log.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

void require_same(const EngineState& a, const EngineState& b) {
  BOOST_REQUIRE(a.trace_hash == b.trace_hash);
  BOOST_REQUIRE(a.counts.pair_contacts == b.counts.pair_contacts);
  BOOST_REQUIRE(a.counts.wall_contacts == b.counts.wall_contacts);
  BOOST_REQUIRE(a.epoch == b.epoch);
  BOOST_REQUIRE(a.frame_velocity == b.frame_velocity);
  BOOST_REQUIRE(a.frame_offset == b.frame_offset);
  BOOST_REQUIRE((a.x == b.x));
  BOOST_REQUIRE((a.y == b.y));
  BOOST_REQUIRE((a.vx == b.vx));
  BOOST_REQUIRE((a.vy == b.vy));
  BOOST_REQUIRE((a.last_contact == b.last_contact));
}

struct Case {
  Scene scene;
  int epochs;
};

/// Dense and dilute (disks lap the box between contacts), channels, inelastic with and without active TC.
std::vector<Case> cases() {
  Case tc_active{test::channel(120, 0.5, 9.3, 0.6), 40};
  tc_active.scene.tc_time *= 300;
  return {{test::gas(200, 0.7), 20},
          {test::gas(10, 0.002), 400},
          {test::gas(2, 0.01), 1000},
          {test::gas(200, 0.2, 0.7), 10},
          {test::channel(300, 0.3, 13), 40},
          {test::channel(12, 0.2, 1.5), 100},
          {test::smooth_channel(100, 0.05, 9.3), 60},
          tc_active};
}

template <class Queue>
EngineState run(const Case& c, double disks_per_cell) {
  Engine<Queue> engine(c.scene, start_state(c.scene), disks_per_cell);
  engine.advance(c.epochs * engine.epoch_length());
  return engine.checkpoint();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(invariance)

BOOST_AUTO_TEST_CASE(cells_and_queue_do_not_matter) {
  for (const Case& c : cases()) {
    const EngineState reference = run<CalendarQueue>(c, 0);
    BOOST_TEST(reference.counts.pair_contacts > 300u);
    for (const double disks_per_cell : {0.1, 0.7, 1.0, 1.7, 3.0, 8.0, 50.0}) {
      require_same(run<CalendarQueue>(c, disks_per_cell), reference);
      require_same(run<HeapQueue>(c, disks_per_cell), reference);
    }
  }
}

BOOST_AUTO_TEST_CASE(cells_that_shrink_where_disks_crowd_do_not_matter) {
  // A clump that flies apart: a fifteenth of the box at first, all of it in the end.
  const Scene scene = test::gas(400, 0.05, 0.8);
  State start = start_state(scene);
  const double apart = 1.05 * scene.diameter();
  for (int i = 0; i < 400; ++i)
    start.position[static_cast<std::size_t>(i)] = {0.3 + apart * (i % 20), 0.3 + apart * (i / 20)};
  Engine<> whole(scene, start);
  const double epoch = whole.epoch_length();
  const auto crowded = [&](const EngineState& state) {
    std::vector<Flight> flights;
    for (std::size_t i = 0; i < state.x.size(); ++i) flights.push_back({state.x[i], state.y[i], 0, 0, 0});
    return crowding(flights, scene.length(), 0, 1);
  };
  BOOST_TEST(crowded(whole.checkpoint()) > 8);
  whole.advance(epoch);
  const EngineState stopped = whole.checkpoint();
  whole.advance(3 * epoch);
  const EngineState reference = whole.checkpoint();
  BOOST_TEST(crowded(reference) < 2);
  BOOST_TEST(reference.counts.pair_contacts > 300u);
  for (const double disks_per_cell : {0.1, 1.0, 20.0, 400.0}) {
    Engine<HeapQueue> other(scene, start, disks_per_cell);
    other.advance(3 * epoch);
    require_same(other.checkpoint(), reference);
  }
  Engine<> resumed(scene, stopped);
  resumed.advance(3 * epoch);
  require_same(resumed.checkpoint(), reference);
  // The size of cells is a function of the state alone, so that a resume does not even show in the work done.
  BOOST_TEST(resumed.checkpoint().counts.crossings == reference.counts.crossings);
  BOOST_TEST(resumed.checkpoint().counts.stale == reference.counts.stale);
}

BOOST_AUTO_TEST_CASE(memory_that_is_fetched_ahead_does_not_matter) {
  // So many disks that the calendar foresees what events will read; the heap foresees nothing. Some rest at first.
  // The third and the fourth are so narrow that they have one row of cells; in the third and the last cells are not
  // roomy.
  for (const Scene& scene :
       {test::channel(50'000, 0.3, 150), test::gas(50'000, 0.05, 0.9), test::channel(50'000, 0.3, 1.8),
        test::channel(50'000, 0.2, 2.5), test::gas(50'000, 0.6)}) {
    State start = start_state(scene);
    for (std::size_t i = 0; i < start.velocity.size(); i += 3) start.velocity[i] = {};
    Engine<CalendarQueue> foreseeing(scene, start);
    Engine<HeapQueue> other(scene, start);
    const double time = 1.05 * foreseeing.epoch_length();
    foreseeing.advance(time);
    other.advance(time);
    BOOST_TEST(foreseeing.counts().pair_contacts > 50'000u);
    BOOST_TEST(foreseeing.trace_hash().value() == other.trace_hash().value());
  }
}

BOOST_AUTO_TEST_CASE(a_copy_in_the_middle_of_an_epoch_goes_the_same_way_by_itself) {
  for (const Scene& scene : {test::channel(300, 0.4, 9.3), test::gas(50'000, 0.3)}) {
    Engine<> engine(scene, start_state(scene));
    engine.advance(0.4 * engine.epoch_length());
    Engine<> copy = engine;
    engine.advance(engine.epoch_length());
    BOOST_TEST(copy.trace_hash().value() != engine.trace_hash().value());
    copy.advance(copy.epoch_length());
    require_same(copy.checkpoint(), engine.checkpoint());
  }
}

BOOST_AUTO_TEST_CASE(steps_do_not_matter) {
  for (const Case& c : cases()) {
    Engine<> whole(c.scene, start_state(c.scene)), parts(c.scene, start_state(c.scene));
    const double end = 5 * whole.epoch_length();
    whole.advance(end);
    // Steps of uneven length, some across the ends of epochs, some of no length.
    for (double t = 0, step = 0.013 * end; t < end; t += step, step = std::fmod(2.7 * step, 0.31 * end)) {
      parts.advance(t);
      parts.advance(t);
      BOOST_REQUIRE(parts.time() == t);
    }
    parts.advance(end);
    require_same(parts.checkpoint(), whole.checkpoint());
  }
}

BOOST_AUTO_TEST_CASE(a_stop_and_a_resume_at_any_epoch_do_not_matter) {
  for (const Case& c : cases()) {
    Engine<> whole(c.scene, start_state(c.scene));
    const double epoch = whole.epoch_length();
    const int epochs = 12;
    std::vector<EngineState> states;
    for (int k = 0; k <= epochs; ++k) {
      whole.advance(k * epoch);
      states.push_back(whole.checkpoint());
    }
    for (int k = 0; k < epochs; ++k) {
      Engine<> resumed(c.scene, states[static_cast<std::size_t>(k)]);
      BOOST_TEST(resumed.time() == k * epoch);
      resumed.advance(epochs * epoch);
      require_same(resumed.checkpoint(), states.back());
    }
    // Stopped at every epoch, each time resumed with other cells and the other queue.
    EngineState state = states[0];
    for (int k = 1; k <= epochs; ++k) {
      if (k % 2 == 0) {
        Engine<HeapQueue> engine(c.scene, state, k);
        engine.advance(k * epoch);
        state = engine.checkpoint();
      } else {
        Engine<CalendarQueue> engine(c.scene, state, 1.0 / k);
        engine.advance(k * epoch);
        state = engine.checkpoint();
      }
      require_same(state, states[static_cast<std::size_t>(k)]);
    }
  }
}

BOOST_AUTO_TEST_CASE(observers_are_told_the_same_in_any_case) {
  // All that an observer is told of each contact, in order, so that what is measured cannot depend on it either.
  struct Log {
    std::vector<double> told;
    void on_pair(const PairContact& c) {
      told.insert(told.end(), {c.time, 1.0 * c.first, 1.0 * c.second, c.position.x, c.position.y, c.r_12.x, c.r_12.y,
                               c.velocity_1.x, c.velocity_1.y, c.velocity_2.x, c.velocity_2.y, c.impulse.x, c.impulse.y,
                               c.energy_loss});
      BOOST_REQUIRE(c.first < c.second);
    }
    void on_wall(const WallContact& c) {
      told.insert(told.end(), {c.time, 1.0 * c.disk, static_cast<double>(c.wall), c.position.x, c.position.y,
                               c.velocity_before.x, c.velocity_before.y, c.velocity_after.x, c.velocity_after.y});
    }
  };
  for (const Case& c : cases()) {
    const State start = start_state(c.scene);
    Engine<> whole(c.scene, start), first_half(c.scene, start, 7);
    Engine<HeapQueue> heap(c.scene, start, 0.3);
    const double epoch = whole.epoch_length();
    Log of_whole, of_heap, of_halves;
    whole.advance(6 * epoch, of_whole);
    heap.advance(6 * epoch, of_heap);
    first_half.advance(3 * epoch, of_halves);
    Engine<>(c.scene, first_half.checkpoint()).advance(6 * epoch, of_halves);
    BOOST_TEST(!of_whole.told.empty());
    BOOST_TEST((of_whole.told == of_heap.told));
    BOOST_TEST((of_whole.told == of_halves.told));
  }
}

BOOST_AUTO_TEST_CASE(late_epochs_are_as_precise_as_the_first) {
  // After 10^9 epochs (10^9 to 10^13 contacts) the same state moves on to the same bits: times are kept within epochs.
  for (const Case& c : cases()) {
    Engine<> warm_up(c.scene, start_state(c.scene));
    const double epoch = warm_up.epoch_length();
    warm_up.advance(3 * epoch);
    EngineState early = warm_up.checkpoint(), late = early;
    early.epoch = 0;
    late.epoch = 1'000'000'000;
    Engine<> soon(c.scene, early), then(c.scene, late);
    test::ContactLog soon_log, then_log;
    soon.advance(10 * epoch, soon_log);
    then.advance(1'000'000'010 * epoch, then_log);
    EngineState a = soon.checkpoint(), b = then.checkpoint();
    BOOST_TEST(b.epoch == 1'000'000'010);
    BOOST_TEST(a.trace_hash != b.trace_hash);  // it knows the epoch
    b.epoch = a.epoch, b.trace_hash = a.trace_hash;
    require_same(a, b);
    BOOST_REQUIRE(soon_log.contacts.size() == then_log.contacts.size());
    for (std::size_t k = 0; k < soon_log.contacts.size(); ++k) {
      BOOST_REQUIRE(soon_log.contacts[k].a == then_log.contacts[k].a);
      BOOST_REQUIRE(soon_log.contacts[k].b == then_log.contacts[k].b);
      // Observers are told absolute times, which a double holds to 2^-52 of 10^9 epochs.
      BOOST_REQUIRE(std::abs(then_log.contacts[k].time - 1e9 * epoch - soon_log.contacts[k].time) < 2.3e-7 * epoch);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_seed_gives_a_run_and_another_seed_another) {
  Case c = cases()[4];
  const EngineState first = run<CalendarQueue>(c, 0);
  require_same(run<CalendarQueue>(c, 0), first);
  c.scene.seed = 2;
  BOOST_TEST(run<CalendarQueue>(c, 0).trace_hash != first.trace_hash);
}

BOOST_AUTO_TEST_SUITE_END()
