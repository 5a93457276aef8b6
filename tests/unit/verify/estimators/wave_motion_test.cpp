// The strongest mode of a made structure, when it comes up, and the speed at which it is carried along.
#include "verify/estimators/wave_motion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/measure/tallies.hpp"
#include "unit/verify/fake_run.hpp"
#include "verify/estimators/made_structures.hpp"

using namespace gpf;

namespace {

/// A record of 16 blocks of one time unit, with k = 1, 2; the mode `power` at k is 20 times the noise in `seen` blocks.
Record record(Tally power, int k, const std::vector<std::size_t>& seen) {
  Record r = test::fake_record(
      parse_scene("[scene]\ngeometry = \"channel\"\nparticles = 36\narea_fraction = 0.2\nwidth_over_diameter = 12\n"
                  "normal_restitution = 0.9\nwall_tangential_restitution = 0.5\n[run]\nstart_up = 4\nduration = 16\n"
                  "density_modes = 2\n",
                  "scene.toml"),
      16);
  r.time = 20;
  const TallyLayout layout(r.run);
  using enum Tally;
  for (std::size_t b = 0; b < r.blocks; ++b)
    for (const Tally t : {mode_even, mode_odd, mode_varicose, mode_noise_even, mode_noise_odd, mode_noise_varicose})
      for (std::size_t j = 0; j < layout.extent(t); ++j) r.sums[b * layout.size() + layout.at(t) + j] = 1;
  for (const std::size_t b : seen) r.sums[b * layout.size() + layout.at(power, k - 1)] = 20;
  return r;
}

/// Two snapshots dt apart of a made structure whose disks have all moved by speed dt; they say that they do at `flow`.
Record moving(Structure structure, double speed, double flow, double dt) {
  const double length = 2;
  Record r;
  r.scene.geometry = Geometry::channel;
  r.scene.length_over_width = length;
  State state = made_structure(structure, {.disks = 900, .length = length}, 7);
  state.velocity.assign(state.position.size(), {flow, 0});
  r.snapshots.push_back({5, state});
  for (Vec2& position : state.position) {
    position.x = std::fmod(position.x + speed * dt, length);
    if (position.x < 0) position.x += length;
  }
  r.snapshots.push_back({5 + dt, state});
  return r;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(wave_motion)

BOOST_AUTO_TEST_CASE(the_strongest_mode_is_found) {
  const StrongestMode mode = strongest_mode({{1, 2, 3}, {9, 1, 1}, {1, 8, 1}});
  BOOST_TEST((mode.shape == ModeShape::odd));
  BOOST_TEST(mode.k == 1);
  BOOST_TEST(mode.contrast == 9);
  BOOST_TEST(strongest_mode({{1, 2}, {2, 1}, {1, 8}}).k == 2);
}

BOOST_AUTO_TEST_CASE(onset_is_when_a_mode_becomes_visible_and_stays_so) {
  const auto onset = [](const std::vector<std::size_t>& seen, ModeShape shape, int k) {
    return onset_time(record(Tally::mode_odd, 2, seen), shape, k, 2);
  };
  const std::vector<std::size_t> late{8, 9, 10, 11, 12, 13, 14, 15};
  BOOST_TEST(onset(late, ModeShape::odd, 2).value() == 13);  // blocks 8 and 9: t from 12 to 14
  BOOST_TEST(!onset(late, ModeShape::odd, 1));
  BOOST_TEST(!onset(late, ModeShape::even, 2));
  BOOST_TEST(!onset({2, 3}, ModeShape::odd, 2));                                        // seen once, and gone
  BOOST_TEST(onset({2, 3, 10, 11, 12, 13, 14, 15}, ModeShape::odd, 2).value() == 7.0);  // 4 of 7 windows from there
  BOOST_TEST(onset({0, 1, 10, 11, 12, 13, 14, 15}, ModeShape::odd, 2).value() == 5.0);  // 4 of 8
  BOOST_TEST(onset({0, 1, 12, 13, 14, 15}, ModeShape::odd, 2).value() == 17.0);         // 3 of 8 are too few
  BOOST_TEST(onset({8, 10, 12, 14}, ModeShape::odd, 2).value() == 13.0);                // mean 10.5 of each window
}

BOOST_AUTO_TEST_CASE(speed_is_that_of_the_phase_nearest_to_the_flow) {
  // Whole turns: speeds length/(k dt) = 8 apart for k = 1.
  for (const double speed : {9.0, 10.0, 12.5}) {
    BOOST_TEST(std::abs(*mode_speed(moving(Structure::slug, speed, 10, 0.25), ModeShape::even, 1) - speed) < 1e-9);
    BOOST_TEST(std::abs(*mode_speed(moving(Structure::wave, speed, 10, 0.25), ModeShape::odd, 1) - speed) < 1e-9);
  }
  BOOST_TEST(std::abs(*mode_speed(moving(Structure::slug, 3, 10, 0.125), ModeShape::even, 1) - 3) < 1e-9);
  BOOST_TEST(std::abs(*mode_speed(moving(Structure::slug, 3, 10, 0.25), ModeShape::even, 1) - 11) < 1e-9);
  BOOST_TEST(snapshot_flow(moving(Structure::slug, 2, 10, 0.25)) == 10);
  Record one = moving(Structure::slug, 2, 10, 0.25);
  one.snapshots.pop_back();
  BOOST_TEST(!mode_speed(one, ModeShape::even, 1));
}

BOOST_AUTO_TEST_SUITE_END()
