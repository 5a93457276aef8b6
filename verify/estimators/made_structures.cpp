#include "verify/estimators/made_structures.hpp"

#include <cmath>
#include <numbers>

#include "gpf/base/random.hpp"
#include "gpf/measure/density_modes.hpp"

namespace gpf {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double half_height = 0.2, swing = 0.12, swelling = 0.8, gathered = 0.9, slug_length = 1.0 / 3;
constexpr int places = 5;

/// Four numbers in [0, 1).
std::array<double, 4> uniform(std::uint64_t key, std::uint64_t stream, std::uint64_t index) {
  std::array<double, 4> numbers{};
  const auto words = random_words(key, stream, index);
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = std::ldexp(static_cast<double>(words[k]), -32);
  return numbers;
}

double fraction(double x) { return x - std::floor(x); }

/// x in units of the period, and how the band lies there.
struct Place {
  double x, middle = 0, half = half_height;
};

Place place_of(Structure structure, double strength, std::uint64_t seed, std::array<double, 4> u) {
  const double start = uniform(seed, 1, 0)[0];
  const bool lies_within = u[1] < gathered * strength;
  switch (structure) {
    case Structure::plug:
      return {u[0]};
    case Structure::wave:
      return {u[0], swing * strength * std::cos(turn * (u[0] - start))};
    case Structure::varicose:
      return {u[0], 0, half_height * (1 + swelling * strength * std::cos(turn * (u[0] - start)))};
    case Structure::slug:
      return {lies_within ? fraction(start + slug_length * u[0]) : u[0]};
    case Structure::clumps:
      break;
  }
  const auto place = static_cast<std::uint64_t>(places * u[3]);
  return {lies_within ? fraction(uniform(seed, 1, 1 + place)[0] + u[0] / (10 * places)) : u[0]};
}

}  // namespace

State made_structure(Structure structure, const MadeChannel& channel, std::uint64_t seed) {
  State state;
  for (int i = 0; i < channel.disks; ++i) {
    const auto u = uniform(seed, 0, static_cast<std::uint64_t>(i));
    const Place place = place_of(structure, channel.strength, seed, u);
    const double y = channel.uniform_across ? u[2] : 0.5 + channel.shift + place.middle + (2 * u[2] - 1) * place.half;
    state.position.push_back({channel.length * place.x, y});
  }
  state.velocity.assign(state.position.size(), {});
  return state;
}

DensityContrast made_contrast(Structure structure, const MadeChannel& channel, int modes, int snapshots,
                              std::uint64_t seed) {
  std::array<std::vector<double>, 3> power;
  for (auto& p : power) p.assign(static_cast<std::size_t>(modes), 0);
  std::array<double, 3> noise{};
  for (int n = 0; n < snapshots; ++n) {
    const State state = made_structure(structure, channel, replica_seed(seed, static_cast<std::uint64_t>(n)));
    const DensityModes one = density_modes(state, channel.length, modes);
    for (std::size_t s = 0; s < power.size(); ++s) {
      noise[s] += one.noise[s];
      for (std::size_t k = 0; k < power[s].size(); ++k) power[s][k] += one.power[s][k];
    }
  }
  for (std::size_t s = 0; s < power.size(); ++s)
    for (double& p : power[s]) p /= noise[s];
  return {power[0], power[1], power[2]};
}

}  // namespace gpf
