// One engine's trajectory. This file is compiled twice, for processors with and without AVX, under two names.
#include "lane_widths_trace.hpp"

#include <typeinfo>

#include "gpf/event/engine.hpp"
#include "gpf/scene/start.hpp"

namespace gpf::test {

LanesTrace NAME_OF_THE_TRACE(const Scene& scene) {
  static_assert(lane_width == LANES);
  Engine<> engine(scene, start_state(scene));
  engine.advance(0.5);
  return {engine.trace_hash().value(),
          {typeid(engine).name(), typeid(Cells).name(), typeid(Neighbourhood<true>).name(), typeid(Abreast).name()},
          reinterpret_cast<std::uintptr_t>(&alike)};
}

}  // namespace gpf::test
