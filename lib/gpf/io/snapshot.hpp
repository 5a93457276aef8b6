// A picture of one state: the disks of the channel, and the power spectrum of their density beside them.
#pragma once

#include <string>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// An SVG document with a circle for each disk - x to the right, the lower wall below, lengths to scale - under `title`
/// (shown as it is: it may come from anywhere), and below it the spectrum (density_spectrum.hpp) for 0 <= kx <= 8 and
/// |ky| <= 4: squares from white, the noise of independent disks and less, to black, ten thousand times that and more.
/// In a long channel circles are no smaller than half a pixel.
std::string snapshot_svg(const Scene& scene, const State& state, const std::string& title);

}  // namespace gpf
