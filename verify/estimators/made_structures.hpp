// Configurations whose structure is known, as one would draw them: what the classifier is tested on.
#pragma once

#include <cstdint>

#include "gpf/scene/state.hpp"
#include "verify/estimators/density_structure.hpp"

namespace gpf {

/// What a configuration is drawn from.
struct MadeChannel {
  int disks;
  double length;                ///< in units of W
  double shift = 0;             ///< of the structure toward the upper wall
  double strength = 1;          ///< of what varies along the channel: 0 is a plug
  bool uniform_across = false;  ///< plug only: a gas that fills the channel
};

/// Independent disks in a channel, drawn from a density:
/// - plug: a band of half height .2;
/// - wave: the band's middle swings by .12 strength cos(2 pi x/L);
/// - varicose: the band's half height is .2 (1 + .8 strength cos(2 pi x/L)), with as many disks everywhere;
/// - slug: the share .9 strength of the disks is in a third of the period;
/// - clumps: the share .9 strength of the disks is in five places, each L/50 wide.
/// The structure's place along the channel is random, as is all else: a function of the seed. Velocities are zero.
State made_structure(Structure structure, const MadeChannel& channel, std::uint64_t seed);

/// Contrasts of `snapshots` independent configurations, averaged as those of a run are.
DensityContrast made_contrast(Structure structure, const MadeChannel& channel, int modes, int snapshots,
                              std::uint64_t seed);

}  // namespace gpf
