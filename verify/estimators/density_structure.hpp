// Plug, wave or slug: how the disks of a channel are arranged along it, from the density modes of a run.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/estimators/scene_values.hpp"

namespace gpf {

enum class Structure { plug, wave, slug };
inline constexpr std::array structures{Structure::plug, Structure::wave, Structure::slug};

/// Contrast of each density mode: the mean of |a_k|^2 over samples in units of what independent disks at the same
/// heights have (density_modes.hpp). 1 for an ideal gas, less for disks that exclude one another. No units. [k - 1]
struct DensityContrast {
  std::vector<double> even, odd, varicose;
};

/// One replica's, from the density powers and noise of derive_quantities.
std::vector<DensityContrast> density_contrasts(const SceneValues& scene);

/// The power of a mode of many independent disks is distributed exponentially about its mean: 1 % of snapshots exceed
/// ln 100 = 4.6 means. That is where one snapshot begins to show something. A mode of contrast C, with the same
/// distribution, exceeds it in exp(-ln 100/C) of the snapshots: in half of them when C = ln 100/ln 2.
inline constexpr double visible_contrast = 6.643856189774724;
/// Contrasts that are to differ do so by this factor: the abstain zone. A mode of visible_contrast/2 is seen in a
/// quarter of the snapshots.
inline constexpr double clear_factor = 2;

/// Plug: no mode is seen (contrast at most visible_contrast/clear_factor). Wave, the thesis' one-humped one: the odd
/// mode k = 1 is visible and exceeds clear_factor times every other mode. Slug: the even mode k = 1 is visible and
/// exceeds clear_factor times every odd mode, and every even one of k > 1; a slug of finite height has the varicose
/// mode too. Nothing between the classes. Varicose waves and clumps (k > 1) are in none of them.
std::optional<Structure> classify(const DensityContrast& contrast);

std::string name_of(Structure structure);
std::string name_of(const std::optional<Structure>& structure);  ///< "between the classes" for none

/// "5 wave, 3 between the classes", and ": bistable" when two classes are each significantly (5 %) above a tenth of all
/// replicas.
std::string tally_of(std::span<const std::optional<Structure>> labels);

}  // namespace gpf
