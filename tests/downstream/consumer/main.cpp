// What a user of the library writes first: a scene file is read, its flow starts, the trajectory is fingerprinted.
#include <cstdio>

#include "gpf/base/hash.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"

int main(int, char** arguments) {
  const gpf::Scene scene = gpf::load_scene(arguments[1]).scene;
  gpf::Engine<> engine(scene, gpf::start_state(scene));
  engine.advance(1);
  std::printf("area fraction %.4f, trace %s\n", scene.area_fraction(),
              gpf::hexadecimal(engine.trace_hash().value()).c_str());
}
