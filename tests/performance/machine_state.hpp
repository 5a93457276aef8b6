// How fast the machine is right now: a fixed piece of work that has nothing to do with the engine.
#pragma once

#include <ctime>

namespace gpf::performance {

/// CPU time of this thread, in nanoseconds.
inline double cpu_nanoseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

/// Nanoseconds for one step of a chain of a multiplication, an addition and a division, each waiting for the last.
/// About constant on an idle machine; larger when the clock is low or the core is shared.
inline double calibration_step() {
  constexpr int steps = 2'000'000;
  const double began = cpu_nanoseconds();
  double x = 0.5;
  for (int k = 0; k < steps; ++k) x = 1 / (1 + x * 0.75);
  return (cpu_nanoseconds() - began) / steps + (x > 1 ? 1 : 0);  // x is below one; naming it keeps the work
}

}  // namespace gpf::performance
