// What lane_widths_trace.cpp tells of the engine that it was compiled with.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpf/scene/scene.hpp"

namespace gpf::test {

struct LanesTrace {
  std::uint64_t hash;
  std::vector<std::string> types;  ///< of what is made of lanes
  std::uintptr_t function;         ///< one that returns a lane, whose type is no part of its symbol
};

LanesTrace trace_in_lanes_of_2(const Scene& scene);
LanesTrace trace_in_lanes_of_4(const Scene& scene);

}  // namespace gpf::test
