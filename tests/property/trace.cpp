// Prints the trace hash of some small scenes: one line "name contacts hash" each, or reference/traces.toml with --toml.
#include <cinttypes>
#include <cstdio>
#include <string_view>

#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

struct Trace {
  const char* name;
  Scene scene;
  int epochs;
};

Scene with_walls(Scene scene, double normal, double lower_tangential, double upper_tangential) {
  scene.wall_normal_restitution = normal;
  scene.wall_tangential_restitution = {lower_tangential, upper_tangential};
  return scene;
}

Scene with_tc(Scene scene, double mean_free_times) {
  scene.tc_time = mean_free_times / scene.reference_collision_rate();
  return scene;
}

const Trace traces[] = {
    {"periodic-dilute", test::gas(500, 0.05), 12},
    {"periodic-dense", test::gas(500, 0.7), 4},
    {"periodic-cooling", test::gas(300, 0.3, 0.8), 40},
    {"periodic-two-disks", test::gas(2, 0.01), 2000},
    {"channel-smooth", test::smooth_channel(300, 0.3, 13), 8},
    {"channel-rough", test::channel(300, 0.56, 17, 0.99), 6},
    {"channel-inelastic", test::channel(300, 0.56, 17, 0.8), 16},
    {"channel-tc-active", with_tc(test::channel(300, 0.3, 17, 0.5), 0.1), 20},
    {"channel-crystal", test::channel(400, 0.85, 21, 0.9), 6},
    {"channel-long", test::channel(400, 0.015, 31), 60},
    {"channel-odd-walls", with_walls(test::channel(200, 0.2, 11), 0.6, -0.5, 0), 30},
    {"channel-one-disk", with_walls(test::channel(1, 0.01, 7), 1, 0.9, 0.6), 3000},
};

}  // namespace

int main(int count, char** arguments) {
  const bool toml = count > 1 && std::string_view(arguments[1]) == "--toml";
  if (toml)
    std::puts(
        "# Trace hashes of small scenes (tests/property/trace.cpp): every compiler, level and CPU must give these "
        "bits.\n"
        "# They change only with physics_version; then this file is the output of the program `trace --toml`.");
  for (const Trace& trace : traces) {
    Engine<> engine(trace.scene, start_state(trace.scene));
    engine.advance(trace.epochs * engine.epoch_length());
    const std::uint64_t contacts = engine.counts().pair_contacts + engine.counts().wall_contacts;
    std::printf(toml ? "\n[[trace]]\nname = \"%s\"\ncontacts = %" PRIu64 "\nhash = \"%016" PRIx64 "\"\n"
                     : "%s %" PRIu64 " %016" PRIx64 "\n",
                trace.name, contacts, engine.trace_hash().value());
  }
}
