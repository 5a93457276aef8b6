// How a run came to its steady state: kinetic energy and granular temperature against time, in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/scene/state.hpp"

namespace gpf {

/// Energy per disk E = <c.c>/2 and global granular temperature T = <u.u>/2 (u about the instantaneous bin mean) of one
/// state.
struct Moment {
  double energy, temperature;
};
Moment moment_of(const State& state, int bins);

/// Keeps every stride-th moment offered; the stride doubles when `most_moments` are held.
class History {
 public:
  static constexpr std::size_t most_moments = 2048;

  void offer(double now, const State& state, int bins);

  std::uint64_t stride = 1, offered = 0;
  std::vector<double> time, energy, temperature;
};

}  // namespace gpf
