// One scene under callgrind: what is counted is the engine at work, without its start. See count_instructions.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"
#include "performance/bench_scenes.hpp"

using namespace gpf;

int main(int count, char** arguments) {
  if (count != 4) {
    std::fputs("usage: count_engine periodic N NU | clump N NU | channel NU E_N\n", stderr);
    return 2;
  }
  const double first = std::atof(arguments[2]), second = std::atof(arguments[3]);
  const std::string_view kind = arguments[1];
  Scene scene = kind == "channel" ? performance::channel(first, second)
                                  : performance::periodic(static_cast<std::int32_t>(first), second);
  if (kind == "clump") scene.normal_restitution = 0.5;  // what has crowded stays so
  Engine<> engine(scene, kind == "clump" ? performance::clump(scene) : start_state(scene));
  double time = 0;
  const auto advance_by = [&](std::uint64_t collisions) {
    const std::uint64_t goal = engine.counts().pair_contacts + collisions;
    while (engine.counts().pair_contacts < goal) engine.advance(time += engine.epoch_length() / 16);
  };
  const auto particles = static_cast<std::uint64_t>(scene.particles);
  advance_by(4 * particles);  // away from the lattice
  const std::uint64_t before = engine.counts().pair_contacts;
  CALLGRIND_START_INSTRUMENTATION;
  advance_by(16 * particles);
  CALLGRIND_STOP_INSTRUMENTATION;
  std::printf("%llu\n", static_cast<unsigned long long>(engine.counts().pair_contacts - before));
}
