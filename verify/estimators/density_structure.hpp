// Plug, wave, varicose wave, slug or clumps: how the disks of a channel are arranged along it, from its density modes.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/estimators/scene_values.hpp"

namespace gpf {

enum class Structure { plug, wave, varicose, slug, clumps };
inline constexpr std::array structures{Structure::plug, Structure::wave, Structure::varicose, Structure::slug,
                                       Structure::clumps};

/// Contrast of each density mode: the mean of |a_k|^2 over samples in units of what independent disks at the same
/// heights have (density_modes.hpp). 1 for an ideal gas, less for disks that exclude one another. No units. [k - 1]
struct DensityContrast {
  std::vector<double> even, odd, varicose;
};

/// One replica's, from the density powers and noise of derive_quantities.
std::vector<DensityContrast> density_contrasts(const SceneValues& scene);
/// The blocks of a run whose middle lies within from <= t < to, t counted from the start of the run. Throws InputError
/// when there is none, or no density modes.
DensityContrast density_contrast_between(const Record& record, double from, double to);
/// The strongest of all modes in the same blocks, |a_k|^2 over |a|^2 of the plug, the size of the mean of
/// exp(2 pi i (y - 1/2)): how high the highest peak along the channel is beside the plug's in a plot of the spectrum.
double highest_peak_between(const Record& record, double from, double to);

/// The power of a mode of many independent disks is distributed exponentially about its mean: 1 % of snapshots exceed
/// ln 100 = 4.6 means. That is where one snapshot begins to show something. A mode of contrast C, with the same
/// distribution, exceeds it in exp(-ln 100/C) of the snapshots: in half of them when C = ln 100/ln 2.
inline constexpr double visible_contrast = 6.643856189774724;
/// Contrasts that are to differ do so by this factor: the abstain zone. A mode of visible_contrast/2 is seen in a
/// quarter of the snapshots.
inline constexpr double clear_factor = 2;

/// Disks that gather somewhere along the channel, at whatever height and in whatever shape, have a varicose mode too:
/// for a narrow lump in the middle of the channel its power is twice that of the even mode, else less; in units of
/// their noises no more than that either. A varicose wave moves no disks along the channel: it has the mode alone.
inline constexpr double varicose_of_a_lump = 2;

/// Plug: no mode is seen (no contrast above visible_contrast/clear_factor): whatever varies across the channel, nothing
/// varies along it. Every other class has a visible mode that exceeds clear_factor times whatever speaks against it:
/// - wave: an odd mode, against all others: the band winds, k humps to a period. The thesis' one-humped wave has k = 1;
/// - varicose: a varicose mode, against the odd and, times varicose_of_a_lump, the even ones: the band swells and
/// shrinks;
/// - slug: the even mode k = 1, against the odd modes and the even ones of k > 1: one lump;
/// - clumps: an even mode of k > 1, against the odd modes, that the even mode k = 1 exceeds by less than half of
///   clear_factor's distance: several lumps, or a short one. The even modes k = 1 and 2 of one lump that takes the part
///   f of the period have the ratio cos^2 pi f: it is a slug from f = 1/4 on, among the clumps up to f = 0.18.
/// Nothing between the classes.
std::optional<Structure> classify(const DensityContrast& contrast);

/// Whether it is one of the wanted ones. Between slug and clumps it is one of these two, whichever: where both are
/// wanted an even mode has to exceed the odd ones only.
bool is_one_of(std::span<const Structure> wanted, const DensityContrast& contrast);

std::string name_of(Structure structure);
/// "slug", or several: "slug or clumps". Throws InputError for an unknown one.
std::vector<Structure> structures_named(const std::string& text);
std::string name_of(const std::optional<Structure>& structure);  ///< "between the classes" for none

/// "5 wave, 3 between the classes", and ": bistable" when two classes are each significantly (5 %) above a tenth of all
/// replicas.
std::string tally_of(std::span<const std::optional<Structure>> labels);

}  // namespace gpf
