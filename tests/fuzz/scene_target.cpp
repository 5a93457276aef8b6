// What must hold for every text: parse_scene gives a scene or throws an InputError that can be acted upon, and a scene
// that it gives is sound: its canonical text reads back to it, and a small one can be started.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/check.hpp"
#include "gpf/base/error.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"

namespace {

using gpf::fuzz::require;

void check_sound(const gpf::SceneFile& file) {
  const std::string canonical = canonical_text(file.scene);
  const gpf::SceneFile again = gpf::parse_scene(canonical + "[run]\nduration = 1\n", "canonical");
  require(canonical_text(again.scene) == canonical, "the canonical text does not read back");
  require(std::isfinite(file.scene.reference_collision_rate()), "the collision rate is not finite");
  require(file.run.duration > 0 || file.run.collisions_per_particle > 0, "the run has no end");
  require(file.run.sample_interval > 0 && file.run.start_up >= 0 && file.run.bins > 0, "the run is not positive");
  if (file.scene.particles > 2000) return;
  for (const gpf::Vec2 v : start_state(file.scene).velocity)
    require(std::isfinite(v.x + v.y), "a velocity is not finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    check_sound(gpf::parse_scene(text, "fuzz"));
  } catch (const gpf::InputError& error) {
    const std::string_view message = error.what();
    require(message.substr(0, 5) == "fuzz:", "an error without its place");
    gpf::fuzz::require_usable(error, "fuzz:");
  }
  return 0;
}
