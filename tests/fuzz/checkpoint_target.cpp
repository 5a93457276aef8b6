// What must hold for all bytes, sealed as a checkpoint's are, so that they reach HDF5: read_checkpoint gives a
// checkpoint or throws an error that can be acted upon, and so does the engine or the measurement that is to go on from
// it.
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>

#include "fuzz/check.hpp"
#include "fuzz/memory_file.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/io/checkpoint.hpp"
#include "gpf/io/hdf5_seal.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/scene/scene_file.hpp"

namespace {

/// That of the corpus.
constexpr const char* small_scene = R"([scene]
geometry = "channel"
particles = 5
area_fraction = 0.1
width_over_diameter = 6
normal_restitution = 0.9
wall_tangential_restitution = 0.9
seed = 1
[run]
start_up = 1
duration = 1
bins = 2
density_modes = 1
snapshots = [0.5]
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gpf::SceneFile file = gpf::parse_scene(small_scene, "small");
  const std::string content(data, data + size);
  const gpf::fuzz::MemoryFile checkpoint(gpf::hdf5::seal(content) + content);
  try {
    const gpf::Checkpoint read = gpf::read_checkpoint(file.scene, file.run, checkpoint.path());
    gpf::Measurement(file.scene, file.run).restore(read.measurement);
    const gpf::Engine<> engine(file.scene, read.engine);
    static_cast<void>(engine.state());
  } catch (const gpf::Error& error) {
    gpf::fuzz::require_usable(error, "");
  } catch (const std::bad_alloc&) {  // HDF5 asks for as much as a file claims to need
  }
  return 0;
}
