// How a density structure comes up and moves: its strongest mode, the time of its onset, its speed along the channel.
#pragma once

#include <optional>

#include "gpf/measure/density_modes.hpp"
#include "verify/estimators/density_structure.hpp"

namespace gpf {

struct StrongestMode {
  ModeShape shape;
  int k;
  double contrast;
};

/// The mode of the highest contrast.
StrongestMode strongest_mode(const DensityContrast& contrast);

/// Middle of the first window of `window` blocks in which the mode is visible (visible_contrast) and in half of the
/// windows after it too; nothing when there is none. Units of the scene's time.
std::optional<double> onset_time(const Record& record, ModeShape shape, int k, std::size_t window);

/// Speed of the mode between the last two snapshots of a record, from the advance of its phase, which is known but for
/// whole turns: of the speeds L/(k dt) apart the one nearest to the mean velocity of the disks. In units of W over the
/// scene's unit of time; nothing when the record has less than two snapshots, or two of one time.
std::optional<double> mode_speed(const Record& record, ModeShape shape, int k);

/// Mean velocity of all disks in the last snapshot but one, what mode_speed() compares with.
double snapshot_flow(const Record& record);

}  // namespace gpf
