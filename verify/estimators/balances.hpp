// The exact identities of a run: what energy and momentum must add up to, whatever the disks do.
#pragma once

#include "gpf/measure/measurement.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// Relative errors of the balances over a measured window; only round-off may remain.
struct Balances {
  /// (work of gravity - losses in pairs and at walls - kinetic energy gained)/(all that turned over: the work, or the
  /// energy at the start where that is more).
  double energy = 0;
  /// Along x: momentum gained less what gravity gave and the walls took, over what gravity gave, or over N times the
  /// velocity scale where that is more. Along y: what the walls gave, over what they gave without sign (channels).
  double momentum_x = 0, momentum_y = 0;
};

/// Of a measurement that began with `start` and whose last sample is `end`.
Balances balances_of(const Scene& scene, const Measurement& measurement, const State& start, const State& end);

}  // namespace gpf
