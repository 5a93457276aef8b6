// The state in which a run begins: a lattice and Gaussian velocities.
#pragma once

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// place_on_lattice(scene) with velocities gaussian_pair(seed, disk), shifted to zero mean and scaled to
/// sum |v|^2/(2N) = velocity_scale()^2, both to round-off: the temperature is that of the scene, not of the sample.
/// A single disk cannot have zero mean and that temperature: it keeps the temperature, in the direction that was drawn.
/// A function of (scene, seed) alone, to the last bit on every machine. Throws InputError if no lattice fits.
[[nodiscard]] State start_state(const Scene& scene);

}  // namespace gpf
