#include "gpf/measure/density_modes.hpp"

#include <cmath>
#include <numbers>

#include "gpf/base/vec2.hpp"

namespace gpf {

DensityModes density_modes(const State& state, double length, int count) {
  constexpr double turn = 2 * std::numbers::pi;
  const auto size = static_cast<std::size_t>(count);
  std::array<std::vector<Vec2>, 3> sum;  // N a_k, real and imaginary part
  for (auto& s : sum) s.assign(size, {});
  DensityModes modes;
  for (const Vec2 r : state.position) {
    const double across = turn * (r.y - 0.5);
    modes.band = modes.band + Vec2{std::cos(across), std::sin(across)};
  }
  modes.band = (1 / static_cast<double>(state.position.size())) * modes.band;
  const double middle = 0.5 + std::atan2(modes.band.y, modes.band.x) / turn;
  for (const Vec2 r : state.position) {
    const double along = turn * r.x / length, across = turn * (r.y - middle);
    const std::array<double, 3> phi{1, std::numbers::sqrt2 * std::sin(across), std::numbers::sqrt2 * std::cos(across)};
    const Vec2 step{std::cos(along), std::sin(along)};
    Vec2 e = step;  // exp(2 pi i k x/L)
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t s = 0; s < phi.size(); ++s) sum[s][k] = sum[s][k] + phi[s] * e;
      e = {e.x * step.x - e.y * step.y, e.x * step.y + e.y * step.x};
    }
    for (std::size_t s = 0; s < phi.size(); ++s) modes.noise[s] += square(phi[s]);
  }
  const double squared_number = square(static_cast<double>(state.position.size()));
  for (std::size_t s = 0; s < sum.size(); ++s) {
    modes.noise[s] /= squared_number;
    for (const Vec2 a : sum[s]) {
      modes.amplitude[s].push_back((1 / static_cast<double>(state.position.size())) * a);
      modes.power[s].push_back(dot(a, a) / squared_number);
    }
  }
  return modes;
}

}  // namespace gpf
