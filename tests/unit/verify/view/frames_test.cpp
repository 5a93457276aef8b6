// The frames of gpf view: what is simulated, and how it is packed.
#include "verify/view/frames.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"
#include "verify/view/base64.hpp"
#include "verify/view/colouring.hpp"
#include "verify/view/packed_frames.hpp"

using namespace gpf;

namespace {

SceneFile small_scene() {
  return parse_scene(
      "[scene]\ngeometry = \"channel\"\nparticles = 100\narea_fraction = 0.2\nwidth_over_diameter = 15\n"
      "normal_restitution = 0.9\nwall_tangential_restitution = 0.9\n[run]\nduration = 1\n",
      "test");
}

/// The k-th of the unsigned numbers of that type in the bytes.
template <class T>
T number(const std::string& bytes, std::size_t k) {
  T value;
  std::memcpy(&value, bytes.data() + k * sizeof(T), sizeof(T));
  return value;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(frames)

// Values of RFC 4648, section 10.
BOOST_AUTO_TEST_CASE(base64_is_that_of_its_standard) {
  BOOST_TEST(base64("").empty());
  BOOST_TEST(base64("f") == "Zg==");
  BOOST_TEST(base64("fo") == "Zm8=");
  BOOST_TEST(base64("foo") == "Zm9v");
  BOOST_TEST(base64("foobar") == "Zm9vYmFy");
  BOOST_TEST(base64("\xff\xfe") == "//4=");
}

BOOST_AUTO_TEST_CASE(frames_are_the_engines_states_whatever_the_interval) {
  const Scene scene = small_scene().scene;
  const Snapshot start{7, start_state(scene)};
  Engine<> engine(scene, start.state);
  int shown = 0;
  const double interval = 0.3;  // no power of two, and longer than an epoch
  const std::uint64_t hash = run_frames(scene, start, {.count = 9, .interval = interval}, [&](const Snapshot& frame) {
    engine.advance(shown * interval);
    BOOST_TEST(frame.time == 7 + shown * interval);
    BOOST_TEST((frame.state.position[5].x == engine.state().position[5].x));
    ++shown;
  });
  BOOST_TEST(shown == 9);
  BOOST_TEST(hash == engine.trace_hash().value());
}

BOOST_AUTO_TEST_CASE(the_default_interval_follows_the_velocity) {
  BOOST_TEST(default_interval({{{0, 0}, {0, 0}}, {{1, 0}, {0, -1}}}) == 0x1p-5);
  BOOST_TEST(default_interval({{{0, 0}, {0, 0}}, {{9, 12}, {15, 0}}}) == 0x1p-9);
  BOOST_TEST(default_interval({{{0, 0}}, {{0, 0}}}) > 0);
}

BOOST_AUTO_TEST_CASE(a_signal_stops_them) {
  const Scene scene = small_scene().scene;
  const volatile std::sig_atomic_t stop = 1;
  const auto interrupted = [](const Error& error) { return error.status() == ExitStatus::interrupted; };
  BOOST_CHECK_EXCEPTION(run_frames(scene, {0, start_state(scene)}, {.count = 2, .interval = 0.1, .stop = &stop},
                                   [](const Snapshot&) { BOOST_ERROR("a frame was shown"); }),
                        Error, interrupted);
}

BOOST_AUTO_TEST_CASE(packed_positions_and_velocities_are_within_their_steps) {
  const SceneFile file = small_scene();
  const State state = start_state(file.scene);
  PackedFrames packed(file.scene, file.run.bins, 3);
  packed.add(state);
  packed.add(state);
  const std::size_t n = state.position.size();
  BOOST_REQUIRE(packed.positions.size() == 2 * n * 4);
  BOOST_REQUIRE(packed.velocities.size() == 2 * n * 2);
  // Half a step of 2^-16, and a little for round-off.
  for (std::size_t i = 0; i < n; ++i) {
    const double x = (number<std::uint16_t>(packed.positions, i) + 0.5) / 65536 * file.scene.length(),
                 y = (number<std::uint16_t>(packed.positions, n + i) + 0.5) / 65536;
    BOOST_TEST(std::abs(x - state.position[i].x) < file.scene.length() / 131000);
    BOOST_TEST(std::abs(y - state.position[i].y) < 1.0 / 131000);
    const double low = number<float>(packed.velocity_ranges, 2), high = number<float>(packed.velocity_ranges, 3);
    const double vy = low + number<std::uint8_t>(packed.velocities, n + i) / 255.0 * (high - low);
    BOOST_TEST(std::abs(vy - state.velocity[i].y) < 0.501 * (high - low) / 255);
  }
  const auto bins = static_cast<std::size_t>(file.run.bins);
  BOOST_TEST(packed.density_modes.size() == sizeof(float) * 2 * 3 * 3);
  BOOST_TEST(packed.profiles.size() == sizeof(float) * 2 * 3 * bins);
  double area = 0;  // the mean of the bins is that of the scene
  for (std::size_t b = 0; b < bins; ++b) area += number<float>(packed.profiles, 2 * bins + b);
  BOOST_TEST(std::abs(area / file.run.bins - file.scene.area_fraction()) < 1e-6);
}

BOOST_AUTO_TEST_CASE(fluctuations_are_taken_from_the_mean_of_the_bin) {
  const State state{{{0.1, 0.2}, {0.5, 0.3}, {0.1, 0.8}}, {{1, 0}, {3, 0}, {5, 1}}};
  BOOST_TEST(shown_values(state, Colouring::fluctuation, 2) == (std::vector<double>{1, 1, 0}),
             boost::test_tools::per_element());
  BOOST_TEST(shown_values(state, Colouring::speed, 2)[1] == 3);
  BOOST_TEST(shown_values(state, Colouring::one, 2)[2] == 0);
}

BOOST_AUTO_TEST_SUITE_END()
