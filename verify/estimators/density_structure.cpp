#include "verify/estimators/density_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "gpf/base/error.hpp"
#include "gpf/stats/proportion.hpp"

namespace gpf {
namespace {

double greatest(std::span<const double> contrasts) {
  return contrasts.empty() ? 0 : *std::max_element(contrasts.begin(), contrasts.end());
}

/// Of all k > 1.
double greatest_of_short(const std::vector<double>& contrasts) { return greatest(std::span(contrasts).subspan(1)); }

}  // namespace

std::vector<DensityContrast> density_contrasts(const SceneValues& scene) {
  const int modes = scene.records().front().run.density_modes;
  if (modes == 0)
    throw InputError(fmt::format("no density modes in the records of {}", scene.name()),
                     "its [run] does not ask for them", "add density_modes = 4 to the scene file and run it again");
  std::vector<DensityContrast> contrasts(scene.replicas());
  const auto take = [&](const std::string& shape, std::vector<double> DensityContrast::*member) {
    const std::vector<double> noise = scene.of("density_noise_" + shape);
    for (int k = 0; k < modes; ++k) {
      const std::vector<double> power = scene.of("density_power_" + shape, k);
      for (std::size_t r = 0; r < power.size(); ++r) (contrasts[r].*member).push_back(1 + power[r] / noise[r]);
    }
  };
  take("even", &DensityContrast::even);
  take("odd", &DensityContrast::odd);
  take("varicose", &DensityContrast::varicose);
  return contrasts;
}

std::optional<Structure> classify(const DensityContrast& c) {
  const double varicose = greatest(c.varicose), short_even = greatest_of_short(c.even),
               short_odd = greatest_of_short(c.odd);
  if (std::max({greatest(c.even), greatest(c.odd), varicose}) <= visible_contrast / clear_factor)
    return Structure::plug;
  const auto stands_out = [](double mode, double others) {
    return mode >= visible_contrast && mode > clear_factor * others;
  };
  if (stands_out(c.odd[0], std::max({greatest(c.even), varicose, short_odd}))) return Structure::wave;
  if (stands_out(c.even[0], std::max(greatest(c.odd), short_even))) return Structure::slug;
  return std::nullopt;
}

std::string name_of(Structure structure) {
  switch (structure) {
    case Structure::plug:
      return "plug";
    case Structure::wave:
      return "wave";
    case Structure::slug:
      break;
  }
  return "slug";
}

std::string name_of(const std::optional<Structure>& structure) {
  return structure ? name_of(*structure) : "between the classes";
}

std::string tally_of(std::span<const std::optional<Structure>> labels) {
  constexpr double seldom = 0.1, significant = 0.05;
  std::map<std::string, std::size_t> count;
  for (const auto& label : labels) ++count[name_of(label)];
  std::string text;
  int common = 0;
  for (const auto& [name, n] : count) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, name);
    if (name != name_of(std::nullopt) && outside_band_p_value(Share{n, labels.size()}, {0, seldom}) <= significant)
      ++common;
  }
  return common > 1 ? text + ": bistable" : text;
}

}  // namespace gpf
