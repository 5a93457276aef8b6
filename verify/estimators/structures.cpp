// vdf.structures, vdf.structures.profiles, vdf.structures.uy: plug, wave and slug, their mean profiles, and how
// asymmetric their velocity distributions are (thesis figs. 3.12-3.14).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "gpf/base/error.hpp"
#include "verify/estimators/density_structure.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {
namespace {

constexpr Interval positive{0, INFINITY};

/// A channel of the claim, and the structure that the source sees in it; none: shown only.
struct Channel {
  SceneValues scene;
  std::optional<Structure> stated;

  [[nodiscard]] double length() const { return scene.scene().length_over_width; }
  [[nodiscard]] std::string name() const { return fmt::format("L/W {:.3g}", length()); }
  [[nodiscard]] std::string label() const { return fmt::format("{}, {}", name_of(stated), name()); }
};

/// By length. `plug` and `wave` are the L/W that the source gives for them; slugs are above `slug_above`.
std::vector<Channel> channels_of(const Claim& claim, const SceneRecords& records) {
  const double plug = claim.parameter("plug"), wave = claim.parameter("wave"), slug = claim.parameter("slug_above");
  constexpr double rounding = 0.01;  // of L/W, which follows from a whole number of disks
  std::vector<Channel> channels;
  for (SceneValues& scene : by_area_fraction(records)) {
    Channel channel{std::move(scene), std::nullopt};
    if (std::abs(channel.length() - plug) < rounding) channel.stated = Structure::plug;
    if (std::abs(channel.length() - wave) < rounding) channel.stated = Structure::wave;
    if (channel.length() > slug + rounding) channel.stated = Structure::slug;
    channels.push_back(std::move(channel));
  }
  std::sort(channels.begin(), channels.end(),
            [](const Channel& a, const Channel& b) { return a.length() < b.length(); });
  for (const Structure structure : {Structure::plug, Structure::wave, Structure::slug})
    if (std::none_of(channels.begin(), channels.end(), [&](const Channel& c) { return c.stated == structure; }))
      throw InputError(fmt::format("claim {} has no channel with a {}", claim.id, name_of(structure)),
                       "structures are compared with one another", "correct the claim's scenes or parameters");
  return channels;
}

/// Pairs of channels with different stated structures, the shorter one first.
template <class F>
void for_pairs(const std::vector<Channel>& channels, F&& f) {
  for (const Channel& a : channels)
    for (const Channel& b : channels)
      if (a.length() < b.length() && a.stated && b.stated && a.stated != b.stated) f(a, b);
}

void check_classes(const std::vector<Channel>& channels, Evidence& evidence) {
  Series even{.label = "slug mode (even)"}, odd{.label = "wave mode (odd)"};
  for (const Channel& channel : channels) {
    const std::vector<DensityContrast> contrasts = density_contrasts(channel.scene);
    std::vector<std::optional<Structure>> labels;
    for (const DensityContrast& contrast : contrasts) labels.push_back(classify(contrast));
    if (channel.stated)
      evidence.checks.push_back(
          {.label = fmt::format("{}: replicas with a {}", channel.name(), name_of(*channel.stated)),
           .values = per_replica(labels.size(), [&](auto r) { return labels[r] == channel.stated ? 1.0 : 0.0; }),
           .band = majority,
           .x = channel.length(),
           .reference = NAN,
           .share = true});
    const auto first = [&](std::vector<double> DensityContrast::*shape) {
      return per_replica(contrasts.size(), [&](auto r) { return (contrasts[r].*shape)[0]; });
    };
    add_point(even, channel.length(), first(&DensityContrast::even));
    add_point(odd, channel.length(), first(&DensityContrast::odd));
    evidence.notes.push_back(
        fmt::format("{} (N {}): {}. Contrast of the even mode k = 1 {:.2f} ({:.2f}), of the odd one {:.2f} ({:.2f}), "
                    "of the varicose "
                    "one {:.2f}; share of the mean density in the even mode 2|a| = {:.2f}.",
                    channel.name(), channel.scene.scene().particles, tally_of(labels), even.y.back(), even.yerr.back(),
                    odd.y.back(), odd.yerr.back(), over_replicas(first(&DensityContrast::varicose)).mean,
                    2 * std::sqrt(std::max(0.0, over_replicas(channel.scene.of("density_power_even")).mean))));
  }
  const double from = channels.front().length(), to = channels.back().length(), margin = 0.05 * (to - from);
  evidence.plot = {.title = "Density modes along the channel",
                   .xlabel = "L/W",
                   .ylabel = "⟨|a₁|²⟩ over that of independent disks",
                   .logy = true,
                   .xrange = {{from - margin, to + margin}}};
  evidence.plot.series.push_back({.label = "between the classes",
                                  .style = SeriesStyle::band,
                                  .x = {from - margin, to + margin},
                                  .lower = {visible_contrast / clear_factor, visible_contrast / clear_factor},
                                  .upper = {visible_contrast, visible_contrast}});
  evidence.plot.series.push_back(std::move(even));
  evidence.plot.series.push_back(std::move(odd));
}

/// Differences in units of the largest value of the profile in the shorter channel: of the height of a plot.
void check_profiles(const std::vector<Channel>& channels, Interval band, Evidence& evidence) {
  struct Profile {
    const char *quantity, *name;
  };
  for (const Profile& profile :
       {Profile{"mean_velocity", "U"}, Profile{"granular_temperature", "T"}, Profile{"area_fraction", "area fraction"}})
    for_pairs(channels, [&](const Channel& a, const Channel& b) {
      const std::vector<double> means = a.scene.mean_profile(profile.quantity);
      const double largest = *std::max_element(means.begin(), means.end());
      double greatest = 0, relative = 0;
      for (int bin = 0; bin < a.scene.half(); ++bin) {
        std::vector<double> values =
            difference(b.scene.mirrored(profile.quantity, bin), a.scene.mirrored(profile.quantity, bin));
        for (double& value : values) value /= largest;
        const double mean = over_replicas(values).mean;
        if (std::abs(mean) > std::abs(greatest)) greatest = mean;
        const double local = mean * largest / means[static_cast<std::size_t>(bin)];
        if (std::abs(local) > std::abs(relative)) relative = local;
        evidence.checks.push_back({.label = fmt::format("{} less {}, {}: {} over its largest value", b.name(), a.name(),
                                                        bin_names(a.scene, bin), profile.name),
                                   .values = std::move(values),
                                   .band = band,
                                   .x = a.scene.centre(bin)});
      }
      evidence.notes.push_back(fmt::format(
          "{} less {}: {} differs by at most {:+.1f} % of its largest value, and {:+.0f} % of its value in the bin.",
          b.name(), a.name(), profile.name, 100 * greatest, 100 * relative));
    });
}

/// Size of a skewness in each slug less that in each plug and wave, in the shear layer and at the centre: above zero.
void check_asymmetry(const Claim& claim, const std::vector<Channel>& channels,
                     const std::vector<VelocityMoment>& moments, Evidence& evidence) {
  const SceneValues& any = channels.front().scene;
  for (const int bin : {bin_parameter(claim, "shear_bin", any), any.half() - 1})
    for (const VelocityMoment& which : moments) {
      for_pairs(channels, [&](const Channel& a, const Channel& b) {
        if (b.stated == Structure::slug)
          evidence.checks.push_back(
              {.label =
                   fmt::format("{} less {}, {}: size of the {}", b.name(), a.name(), bin_names(any, bin), which.name),
               .values = difference(departure(b.scene, which, bin), departure(a.scene, which, bin)),
               .band = positive,
               .x = any.centre(bin)});
      });
      std::string note = fmt::format("{}, {}:", bin_names(any, bin), which.name);
      for (const Channel& channel : channels) {
        const Estimate e = over_replicas(moment(channel.scene, which, bin));
        note += fmt::format("{} {:.3f} ({:.3f}) at {}", &channel == &channels.front() ? "" : ",", e.mean, e.error,
                            channel.name());
      }
      evidence.notes.push_back(note + ".");
    }
}

}  // namespace

// vdf.structures. The class of each channel (share of the replicas that have it; fig. 3.12); the skewness of u_x, about
// either mean, is larger in size in every slug than in plug and wave, in `shear_bin` and at the centre (fig. 3.14a).
Evidence estimate_structures(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<Channel> channels = channels_of(claim, records);
  Evidence evidence;
  check_classes(channels, evidence);
  check_asymmetry(claim, channels, {skewness_x, skewness_x_long_time}, evidence);
  evidence.notes.push_back(fmt::format(
      "a_k = (1/N) sum exp(2 pi i k x/L) phi(y/W), phi = 1 (even), sqrt2 sin 2 pi (y/W - 1/2) (odd), sqrt2 cos 2 pi "
      "(y/W - "
      "1/2) (varicose); contrast: mean power over (1/N^2) sum phi^2, that of independent disks. Plug: no mode above "
      "{:.2f}; wave: the odd one, slug: the even one above {:.2f} and above twice the others (a slug has a varicose "
      "part "
      "too).",
      visible_contrast / clear_factor, visible_contrast));
  return evidence;
}

// vdf.structures.profiles. U, T and area fraction of channels of different class differ in no bin by more than the
// tolerance, in units of the largest value of the profile (fig. 3.13).
Evidence estimate_structure_profiles(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<Channel> channels = channels_of(claim, records);
  Evidence evidence;
  check_profiles(channels, band_about(0, claim.tolerance_total()), evidence);
  evidence.plot = {.title = "Granular temperature in a plug, a wave and slugs",
                   .xlabel = "y/W",
                   .ylabel = "T/(gW)",
                   .xrange = {{0, 1}}};
  for (const Channel& channel : channels) {
    if (!channel.stated) continue;
    Series points{.label = channel.label()};
    for (int bin = 0; bin < channel.scene.bins(); ++bin)
      add_point(points, channel.scene.centre(bin),
                channel.scene.mirrored("granular_temperature", std::min(bin, channel.scene.bins() - 1 - bin)));
    evidence.plot.series.push_back(std::move(points));
  }
  return evidence;
}

// vdf.structures.uy. As the last part of vdf.structures, for the skewness of u_y (fig. 3.14b).
Evidence estimate_structures_y(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<Channel> channels = channels_of(claim, records);
  Evidence evidence;
  check_asymmetry(claim, channels, {skewness_y}, evidence);
  evidence.plot = {.title = "Skewness of u_y in a plug, a wave and slugs",
                   .xlabel = "y/W",
                   .ylabel = "skewness of u_y",
                   .xrange = {{0, 1}},
                   .series = {{.style = SeriesStyle::line, .x = {0, 1}, .y = {0, 0}}}};
  for (const Channel& channel : channels)
    if (channel.stated) evidence.plot.series.push_back(moment_profile(channel.scene, skewness_y, channel.label()));
  return evidence;
}

}  // namespace gpf
