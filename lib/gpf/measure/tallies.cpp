#include "gpf/measure/tallies.hpp"

#include <fmt/format.h>

#include <array>

namespace gpf {

namespace {

enum class Extent { one, walls, bins, modes, one_with_modes };
struct Entry {
  std::string_view name;
  Extent extent;
};

using enum Extent;
constexpr std::array<Entry, static_cast<std::size_t>(Tally::size_)> entries{{
    {"measured_time", one},
    {"samples", one},
    {"energy", one},
    {"momentum", one},
    {"speed", one},
    {"peculiar_speed", one},
    {"pair_contacts", one},
    {"pair_loss", one},
    {"virial", one},
    {"gravity_work", one},
    {"energy_change", one},
    {"free_paths", one},
    {"free_path", one},
    {"wall_contacts", walls},
    {"wall_normal", walls},
    {"wall_tangential", walls},
    {"wall_loss", walls},
    {"count", Extent::bins},
    {"cx", Extent::bins},
    {"cx2", Extent::bins},
    {"cx3", Extent::bins},
    {"cx4", Extent::bins},
    {"cy", Extent::bins},
    {"cy2", Extent::bins},
    {"cy3", Extent::bins},
    {"cy4", Extent::bins},
    {"cxcy", Extent::bins},
    {"freedom", Extent::bins},
    {"ux2", Extent::bins},
    {"ux3", Extent::bins},
    {"ux4", Extent::bins},
    {"contacts", Extent::bins},
    {"loss", Extent::bins},
    {"stress_xx", Extent::bins},
    {"stress_xy", Extent::bins},
    {"stress_yy", Extent::bins},
    {"mode_even", modes},
    {"mode_odd", modes},
    {"mode_varicose", modes},
    {"mode_noise_even", one_with_modes},
    {"mode_noise_odd", one_with_modes},
    {"mode_noise_varicose", one_with_modes},
    {"band_cos", one_with_modes},
    {"band_sin", one_with_modes},
}};

int count_of(Extent extent, int bins, int density_modes) {
  switch (extent) {
    case one:
      return 1;
    case walls:
      return 2;
    case Extent::bins:
      return bins;
    case modes:
      return density_modes;
    case one_with_modes:
      break;
  }
  return density_modes > 0 ? 1 : 0;
}

}  // namespace

TallyLayout::TallyLayout(int bins, int density_modes) : bins_(bins), density_modes_(density_modes), offset_{0} {
  for (const Entry& entry : entries)
    offset_.push_back(offset_.back() + static_cast<std::size_t>(count_of(entry.extent, bins, density_modes)));
}

std::string_view TallyLayout::name(Tally tally) { return entries[static_cast<std::size_t>(tally)].name; }

std::vector<std::string> TallyLayout::labels() const {
  std::vector<std::string> labels;
  for (int t = 0; t < static_cast<int>(Tally::size_); ++t) {
    const auto tally = static_cast<Tally>(t);
    const Extent kind = entries[static_cast<std::size_t>(t)].extent;
    if (extent(tally) == 1 && (kind == one || kind == one_with_modes))
      labels.emplace_back(name(tally));
    else
      for (std::size_t k = 0; k < extent(tally); ++k) labels.push_back(fmt::format("{}[{}]", name(tally), k));
  }
  return labels;
}

}  // namespace gpf
