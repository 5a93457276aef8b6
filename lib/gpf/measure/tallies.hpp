// The sums that a run collects: their names, and where each stands in a row of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/scene/scene.hpp"

namespace gpf {

/// Sums over time (contacts) or over samples (fields). Everything that a report shows is derived from these.
enum class Tally : int {
  // one number each
  measured_time,   ///< length of time
  samples,         ///< number of samples
  energy,          ///< samples: kinetic energy of all disks
  momentum,        ///< samples: sum of c_x
  speed,           ///< samples: sum of |c|
  peculiar_speed,  ///< samples: sum of |u|, u about the instantaneous bin mean
  pair_contacts,   ///< number
  pair_loss,       ///< energy lost in them
  virial,          ///< sum of r_12 . J
  gravity_work,    ///< work of gravity
  energy_change,   ///< kinetic energy gained
  free_paths,      ///< number of completed free paths (two per pair contact, once a disk has had one)
  free_path,       ///< sum of the laboratory displacement between successive pair contacts of a disk
  // one number for each wall
  wall_contacts,    ///< number
  wall_normal,      ///< normal impulse given to the wall (outward positive)
  wall_tangential,  ///< tangential impulse given to the wall (along +x positive)
  wall_loss,        ///< energy lost at the wall
  // one number for each bin; c laboratory velocity, u = c - instantaneous mean of the bin
  count,  ///< disks
  cx,
  cx2,
  cx3,
  cx4,  ///< powers of c_x
  cy,
  cy2,
  cy3,
  cy4,      ///< powers of c_y
  cxcy,     ///< c_x c_y
  freedom,  ///< disks less one: what a variance about the instantaneous mean is divided by
  ux2,
  ux3,
  ux4,       ///< powers of u_x
  contacts,  ///< pair contacts whose line's middle lies in the bin
  loss,      ///< energy lost in them
  stress_xx,
  stress_xy,
  stress_yy,  ///< J_a r_b, shared along the line of contact
  // one number for each streamwise wavenumber k = 1 ... run.density_modes; samples: |a_k|^2, see density_modes.hpp
  mode_even,
  mode_odd,
  mode_varicose,
  // one number each where density_modes > 0; samples: what |a_k|^2 is on average for independent disks
  mode_noise_even,
  mode_noise_odd,
  mode_noise_varicose,
  // one number each where density_modes > 0; samples: mean of cos and sin of 2 pi (y - 1/2) over the disks
  band_cos,
  band_sin,
  size_  ///< number of tallies
};

/// Rows of tallies for a number of bins, and of density modes. Without density modes a row ends with the stresses.
class TallyLayout {
 public:
  explicit TallyLayout(int bins, int density_modes = 0);
  explicit TallyLayout(const Run& run) : TallyLayout(run.bins, run.density_modes) {}

  [[nodiscard]] int bins() const { return bins_; }
  [[nodiscard]] int density_modes() const { return density_modes_; }
  [[nodiscard]] std::size_t size() const { return offset_.back(); }  ///< numbers in a row
  /// Place of entry `k` (wall, bin, or wavenumber less one) of a tally.
  [[nodiscard]] std::size_t at(Tally tally, int k = 0) const {
    return offset_[static_cast<std::size_t>(tally)] + static_cast<std::size_t>(k);
  }
  [[nodiscard]] std::size_t extent(Tally tally) const {
    return offset_[static_cast<std::size_t>(tally) + 1] - offset_[static_cast<std::size_t>(tally)];
  }
  static std::string_view name(Tally tally);
  /// "name" or "name[k]" for each place of a row.
  [[nodiscard]] std::vector<std::string> labels() const;

 private:
  int bins_, density_modes_;
  std::vector<std::size_t> offset_;
};

}  // namespace gpf
