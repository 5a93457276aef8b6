#include "gpf/scene/scene_size.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace gpf {
namespace {

constexpr std::array<std::string_view, 4> size_keys{"particles", "area_fraction", "width_over_diameter",
                                                    "length_over_width"};

std::vector<std::string_view> keys_given(const KeyValues& values, bool given) {
  std::vector<std::string_view> names;
  for (const std::string_view key : size_keys)
    if (values.has(key) == given) names.push_back(key);
  return names;
}

InputError error_at_size(const KeyValues& values, std::string_view problem, std::string why, std::string remedy) {
  return values.error({size_keys[0], size_keys[1], size_keys[2], size_keys[3]}, problem, std::move(why),
                      std::move(remedy));
}

void require_three(const KeyValues& values) {
  const auto given = keys_given(values, true);
  if (given.size() >= 3) return;
  const std::string_view only = given.empty() ? "none of the four size keys is given" : "";
  throw error_at_size(values,
                      only.empty() ? fmt::format("of the four size keys only {} {} given", fmt::join(given, " and "),
                                                 given.size() == 1 ? "is" : "are")
                                   : std::string(only),
                      fmt::format("three of {} fix a scene", fmt::join(size_keys, ", ")),
                      fmt::format("add {} of {}",
                                  given.size() == 2   ? "one"
                                  : given.size() == 1 ? "two"
                                                      : "three",
                                  fmt::join(keys_given(values, false), ", ")));
}

void check_side(const KeyValues& values, std::string_view what, double diameters, double least) {
  if (diameters >= least && diameters <= longest_side) return;
  throw error_at_size(values, fmt::format("{} is {:.6g} diameters", what, diameters),
                      diameters < least ? "the cells that find neighbours would meet themselves round the period"
                                        : "coordinates would lose the digits that keep contacts sharp",
                      fmt::format("make it {} ... {} diameters by the values of {}", least, longest_side,
                                  fmt::join(keys_given(values, true), ", ")));
}

void check_derived(const KeyValues& values, std::string_view key, double value, double least, double most) {
  if (value >= least && value <= most) return;
  std::vector<std::string> given;
  for (const std::string_view name : keys_given(values, true))
    given.push_back(name == "particles" ? fmt::format("{} = {}", name, *values.integer(name))
                                        : fmt::format("{} = {}", name, *values.real(name)));
  throw error_at_size(values, fmt::format("{} give {} = {:.6g}", fmt::join(given, ", "), key, value),
                      fmt::format("it must lie in [{}, {}]", least, most), "change one of these values");
}

void check_agreement(const KeyValues& values, std::int32_t particles, double nu, double wd, double lw) {
  const double computed = 4 * nu * lw * wd * wd / std::numbers::pi;
  // Half a disk is the rounding of N; the rest is that of the four numbers themselves, some 1e-16 each.
  if (std::abs(particles - computed) <= 0.5 + 1e-12 * particles) return;
  throw error_at_size(
      values, fmt::format("particles = {} contradicts the other size keys", particles),
      fmt::format("area_fraction = {}, width_over_diameter = {} and length_over_width = {} make it {:.7g}", nu, wd, lw,
                  computed),
      fmt::format("drop one of the four, or correct it: particles = {:.0f}, or area_fraction = {:.6g}, or "
                  "length_over_width = {:.6g}",
                  computed, nu * (particles / computed), lw * (particles / computed)));
}

}  // namespace

SceneSize resolve_size(const KeyValues& values, Geometry geometry) {
  using std::numbers::pi;
  require_three(values);
  const auto given_particles = values.integer("particles");
  const auto nu = values.real("area_fraction");
  const auto wd = values.real("width_over_diameter"), lw = values.real("length_over_width");

  SceneSize size{static_cast<std::int32_t>(given_particles.value_or(0)), wd.value_or(0), lw.value_or(0)};
  if (!given_particles) {
    const double particles = 4 * *nu * *lw * *wd * *wd / pi;
    check_derived(values, "particles", particles, 0.5, 1e7);
    size.particles = static_cast<std::int32_t>(std::floor(particles + 0.5));
  } else if (!wd) {
    size.width_over_diameter = std::sqrt(pi * size.particles / (4 * *nu * *lw));
    check_derived(values, "width_over_diameter", size.width_over_diameter, narrowest_channel, longest_side);
  } else if (!lw) {
    size.length_over_width = pi * size.particles / (4 * *nu * (*wd * *wd));
  } else if (nu) {
    check_agreement(values, size.particles, *nu, *wd, *lw);
  }

  if (geometry == Geometry::periodic)
    check_side(values, "the period across", size.width_over_diameter, shortest_period);
  check_side(values, "the period along x", size.length_over_width * size.width_over_diameter, shortest_period);
  return size;
}

}  // namespace gpf
