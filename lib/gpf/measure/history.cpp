#include "gpf/measure/history.hpp"

#include "gpf/measure/bins.hpp"

namespace gpf {

Moment moment_of(const State& state, int bins) {
  const Bins across(bins);
  const auto size = static_cast<std::size_t>(bins);
  std::vector<double> count(size, 0), mean(size, 0);
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const auto b = static_cast<std::size_t>(across.at(state.position[i].y));
    count[b] += 1;
    mean[b] += state.velocity[i].x;
  }
  for (std::size_t b = 0; b < size; ++b)
    if (count[b] > 0) mean[b] /= count[b];
  double energy = 0, thermal = 0;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const Vec2 c = state.velocity[i];
    const Vec2 u{c.x - mean[static_cast<std::size_t>(across.at(state.position[i].y))], c.y};
    energy += 0.5 * dot(c, c);
    thermal += 0.5 * dot(u, u);
  }
  const auto n = static_cast<double>(state.position.size());
  return {energy / n, thermal / n};
}

void History::offer(double now, const State& state, int bins) {
  if (offered++ % stride != 0) return;
  const Moment moment = moment_of(state, bins);
  time.push_back(now);
  energy.push_back(moment.energy);
  temperature.push_back(moment.temperature);
  if (time.size() < most_moments) return;
  for (auto* values : {&time, &energy, &temperature}) {
    for (std::size_t k = 0; 2 * k < values->size(); ++k) (*values)[k] = (*values)[2 * k];
    values->resize((values->size() + 1) / 2);
  }
  stride *= 2;
}

}  // namespace gpf
