#include "verify/estimators/density_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"
#include "gpf/measure/tallies.hpp"
#include "gpf/stats/proportion.hpp"

namespace gpf {
namespace {

double greatest(std::span<const double> contrasts) {
  return contrasts.empty() ? 0 : *std::max_element(contrasts.begin(), contrasts.end());
}

InputError no_modes(const std::string& where) {
  return InputError("no density modes in " + where, "its [run] does not ask for them",
                    "add density_modes = 4 to the scene file and run it again");
}

/// Sums of the blocks whose middle lies within from <= t < to.
std::vector<double> sums_between(const Record& record, double from, double to) {
  const TallyLayout layout(record.run);
  if (layout.density_modes() == 0) throw no_modes("the record");
  const BlockTimes block = block_times(record);
  std::vector<double> sums(layout.size());
  bool any = false;
  for (std::size_t b = 0; b < record.blocks; ++b) {
    const double middle = block.start + (static_cast<double>(b) + 0.5) * block.length;
    if (middle < from || middle >= to) continue;
    any = true;
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += record.sums[b * sums.size() + k];
  }
  if (!any)
    throw InputError(fmt::format("nothing was measured from t = {} to {}", from, to),
                     fmt::format("the run measured from {} to {}", record.run.start_up, record.time),
                     "correct the claim's window, or the scene's start_up and duration");
  return sums;
}

double second_greatest(std::vector<double> contrasts) {
  if (contrasts.size() < 2) return 0;
  std::nth_element(contrasts.begin(), contrasts.begin() + 1, contrasts.end(), std::greater<>());
  return contrasts[1];
}

bool stands_out(double mode, double others) { return mode >= visible_contrast && mode > clear_factor * others; }

/// Of all k > 1.
double greatest_of_short(const std::vector<double>& contrasts) { return greatest(std::span(contrasts).subspan(1)); }

}  // namespace

DensityContrast density_contrast_between(const Record& record, double from, double to) {
  const TallyLayout layout(record.run);
  const std::vector<double> sums = sums_between(record, from, to);
  const auto contrast = [&](Tally power, Tally noise) {
    std::vector<double> values;
    for (int k = 0; k < layout.density_modes(); ++k)
      values.push_back(sums[layout.at(power, k)] / sums[layout.at(noise)]);
    return values;
  };
  using enum Tally;
  return {contrast(mode_even, mode_noise_even), contrast(mode_odd, mode_noise_odd),
          contrast(mode_varicose, mode_noise_varicose)};
}

double highest_peak_between(const Record& record, double from, double to) {
  const TallyLayout layout(record.run);
  const std::vector<double> sums = sums_between(record, from, to);
  using enum Tally;
  double highest = 0;
  for (const Tally power : {mode_even, mode_odd, mode_varicose})
    for (int k = 0; k < layout.density_modes(); ++k) highest = std::max(highest, sums[layout.at(power, k)]);
  const double sampled = sums[layout.at(Tally::samples)];
  return highest * sampled / (square(sums[layout.at(band_cos)]) + square(sums[layout.at(band_sin)]));
}

std::vector<DensityContrast> density_contrasts(const SceneValues& scene) {
  const int modes = scene.records().front().run.density_modes;
  if (modes == 0) throw no_modes("the records of " + scene.name());
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
  const double even = greatest(c.even), odd = greatest(c.odd), varicose = greatest(c.varicose),
               short_even = greatest_of_short(c.even);
  if (std::max({even, odd, varicose}) <= visible_contrast / clear_factor) return Structure::plug;
  if (stands_out(odd, std::max({even, varicose, second_greatest(c.odd)}))) return Structure::wave;
  if (stands_out(varicose, std::max(odd, varicose_of_a_lump * even))) return Structure::varicose;
  if (stands_out(c.even[0], std::max(odd, short_even))) return Structure::slug;
  if (stands_out(short_even, odd) && c.even[0] <= std::sqrt(clear_factor) * short_even) return Structure::clumps;
  return std::nullopt;
}

bool is_one_of(std::span<const Structure> wanted, const DensityContrast& contrast) {
  const auto has = [&](Structure s) { return std::find(wanted.begin(), wanted.end(), s) != wanted.end(); };
  if (const auto label = classify(contrast)) return has(*label);
  return has(Structure::slug) && has(Structure::clumps) && stands_out(greatest(contrast.even), greatest(contrast.odd));
}

std::string name_of(Structure structure) {
  switch (structure) {
    case Structure::plug:
      return "plug";
    case Structure::wave:
      return "wave";
    case Structure::varicose:
      return "varicose wave";
    case Structure::slug:
      return "slug";
    case Structure::clumps:
      break;
  }
  return "clumps";
}

std::vector<Structure> structures_named(const std::string& text) {
  std::vector<Structure> named;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(" or ", from), text.size());
    const std::string word = text.substr(from, to - from);
    const auto found =
        std::find_if(structures.begin(), structures.end(), [&](Structure s) { return name_of(s) == word; });
    if (found == structures.end())
      throw InputError(fmt::format("unknown structure '{}'", word), "a claim's [structures] names another",
                       "write plug, wave, varicose wave, slug or clumps, or several with ' or ' between");
    named.push_back(*found);
    from = to + 4;
  }
  return named;
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
