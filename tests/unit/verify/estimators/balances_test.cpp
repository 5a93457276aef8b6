#include "verify/estimators/balances.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "verify/estimators/limit_scenes.hpp"

using namespace gpf;

namespace {

/// Hides some of the contacts from a measurement.
struct Forgetful {
  Measurement& measurement;
  bool sees_pairs = true, sees_walls = true;
  void on_pair(const PairContact& c) {
    if (sees_pairs) measurement.on_pair(c);
  }
  void on_wall(const WallContact& c) {
    if (sees_walls) measurement.on_wall(c);
  }
};

Balances measured(const Scene& scene, bool sees_pairs = true, bool sees_walls = true) {
  const State start = start_state(scene);
  Engine<> engine(scene, start);
  Measurement measurement(scene, 1);
  measurement.begin(0, start);
  Forgetful observer{measurement, sees_pairs, sees_walls};
  for (const double time : {1.0, 2.0}) {
    engine.advance(time, observer);
    measurement.sample(time, engine.state());
  }
  return balances_of(scene, measurement, start, engine.state());
}

void check_closed(const Balances& b) {
  BOOST_TEST(std::abs(b.energy) < 1e-13);
  BOOST_TEST(std::abs(b.momentum_x) < 1e-13);
  BOOST_TEST(std::abs(b.momentum_y) < 1e-13);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(balances)

BOOST_AUTO_TEST_CASE(they_close_in_a_channel_and_in_a_box) {
  check_closed(measured(limit_channel(40, 6, 0.3, 0.9)));
  check_closed(measured(limit_gas(40, 0.3, 0.9)));
}

BOOST_AUTO_TEST_CASE(losses_that_were_not_seen_show) {
  BOOST_TEST(std::abs(measured(limit_channel(40, 6, 0.3, 0.9), false).energy) > 1e-3);
  BOOST_TEST(std::abs(measured(limit_gas(40, 0.3, 0.9), false).energy) > 1e-3);
}

BOOST_AUTO_TEST_CASE(walls_that_were_not_seen_show) {
  const Balances b = measured(limit_channel(40, 6, 0.3, 0.9), true, false);
  BOOST_TEST(std::abs(b.momentum_x) > 1e-3);
  BOOST_TEST(std::abs(b.momentum_y) > 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
