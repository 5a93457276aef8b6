// Strong dissipation: without the TC model collisions pile up until time stands still, and the engine says so; with it
// the run goes on.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "gpf/event/engine.hpp"
#include "gpf/event/heap_queue.hpp"
#include "gpf/scene/start.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

bool is_collapse(const PhysicsError& error) {
  const std::string what = error.what();
  return what.find("inelastic collapse") != what.npos && what.find("tc_time") != what.npos;
}

std::vector<Scene> collapsing_scenes() {
  return {test::channel(900, 0.3, 31, 0.3), test::channel(900, 0.56, 31, 0.3), test::channel(900, 0.85, 31, 0.8),
          test::channel(60, 0.5, 1.5, 0.3), test::gas(400, 0.56, 0.3),         test::gas(400, 0.7, 0.1)};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(collapse)

BOOST_AUTO_TEST_CASE(without_the_tc_model_a_collapse_is_an_error_within_seconds) {
  for (Scene scene : collapsing_scenes()) {
    scene.tc_time = 0;
    const auto began = std::chrono::steady_clock::now();
    Engine<> engine(scene, start_state(scene));
    BOOST_CHECK_EXCEPTION(engine.advance(50), PhysicsError, is_collapse);
    const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - began;
    BOOST_TEST_MESSAGE("collapse at " << engine.time() << " after " << engine.counts().pair_contacts << " contacts, "
                                      << lasted.count() << " s");
    BOOST_TEST(lasted.count() < 20);
    Engine<HeapQueue> heap(scene, start_state(scene));
    BOOST_CHECK_EXCEPTION(heap.advance(50), PhysicsError, is_collapse);
  }
}

BOOST_AUTO_TEST_CASE(with_the_tc_model_the_same_scenes_run_on) {
  for (Scene scene : collapsing_scenes()) {
    scene.tc_time = 1e-4 / scene.reference_collision_rate();
    Engine<> engine(scene, start_state(scene));
    BOOST_CHECK_NO_THROW(engine.advance(1.5));
    BOOST_TEST(engine.time() == 1.5);
    BOOST_TEST(engine.deepest_overlap() < 1e-12 * scene.diameter());
  }
}

BOOST_AUTO_TEST_CASE(a_column_jammed_between_the_walls_is_an_error_not_a_hang) {
  // Three disks fill the width to the last bit: elastic contacts without end, in no time.
  Scene scene = test::smooth_channel(3, 0.1, 3);
  scene.width_over_diameter = 3;
  scene.length_over_width = 2;
  const double d = scene.diameter();
  const State start{{{0.5, d / 2}, {0.5, 0.5}, {0.5, 1 - d / 2}}, {{0, 0}, {0, 1}, {0, 0}}};
  Engine<> engine(scene, start);
  BOOST_CHECK_EXCEPTION(engine.advance(1), PhysicsError, is_collapse);
}

BOOST_AUTO_TEST_CASE(mild_dissipation_needs_no_tc_model) {
  // Measured with an independent code: e = .8 runs on at area fraction .56.
  Scene scene = test::channel(900, 0.56, 31, 0.8);
  scene.tc_time = 0;
  Engine<> engine(scene, start_state(scene));
  BOOST_CHECK_NO_THROW(engine.advance(3));
  BOOST_TEST(engine.counts().pair_contacts > 100000u);
}

BOOST_AUTO_TEST_SUITE_END()
