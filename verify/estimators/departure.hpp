// How fast two trajectories from one state part, when they are computed in different precision.
#pragma once

#include <vector>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// Root mean square over the disks of the distance between their places in two states, in diameters; nearest images.
double distance_between(const Scene& scene, const State& a, const State& b);

/// The nearest numbers of single precision.
State rounded_to_float(State state);

/// Distances from a trajectory in long double, at equal steps of time.
struct Departure {
  std::vector<double> contacts;                 ///< per disk, of the trajectory in long double
  std::vector<double> single, twofold, engine;  ///< of the O(N) search in float and double, and of the engine

  /// Contacts per disk until a distance has passed `threshold` diameters; NaN when it has not.
  [[nodiscard]] double contacts_to(double threshold, const std::vector<double>& distance) const;
  /// Growth of ln(distance) per contact of a disk: straight line through those at the times when `guide`, one of the
  /// distances, lies between `from` and `to` diameters. NaN with less than three.
  [[nodiscard]] double rate(const std::vector<double>& distance, const std::vector<double>& guide, double from,
                            double to) const;
};

/// From `start`, whose numbers must be those of single precision so that all begin alike, until the trajectories in
/// double have parted by `threshold` diameters, or for `most` mean free times of the scene at the most.
Departure departure_from(const Scene& scene, const State& start, double threshold, int most);

}  // namespace gpf
