// Runs a small channel with the simulate() that the dynamic linker chose, and prints the hash of its trajectory.
#include <fmt/format.h>

#include "verify/simulate.hpp"

int main() {
  const gpf::SceneFile file = gpf::parse_scene(R"(
[scene]
geometry = "channel"
particles = 200
area_fraction = 0.4
width_over_diameter = 15
normal_restitution = 0.9
wall_tangential_restitution = 0.9
seed = 1
[run]
start_up = 1
duration = 2
)",
                                               "the channel");
  fmt::print("{:016x}\n", gpf::simulate(file)->trace_hash);
}
