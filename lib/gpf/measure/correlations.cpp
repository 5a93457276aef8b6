#include "gpf/measure/correlations.hpp"

#include <cmath>
#include <complex>

namespace gpf {

Correlations::Correlations(const Scene& scene, int bins)
    : bins_(bins), diameter_(scene.diameter()), length_(scene.length()) {
  const auto b = static_cast<std::size_t>(bins), n = static_cast<std::size_t>(scene.particles);
  arrays_ = {{"pair/count", {b, distance_cells}},
             {"pair/ux", {b, distance_cells}},
             {"pair/uy", {b, distance_cells}},
             {"pair/uxy", {b, distance_cells}},
             {"pair/cx", {b, distance_cells}},
             {"pair/cx_sum", {b, distance_cells}},
             {"pair/frame", {b}},
             {"pair/total", {b}},
             {"pair/samples", {1}},
             {"order/psi6", {b}},
             {"order/neighbours", {b}},
             {"order/disks", {b}},
             {"time/ux", {b, lags}},
             {"time/uy", {b, lags}},
             {"time/count", {b, lags}},
             {"time/origin", {1 + 3 * n}}};
}

void Correlations::begin(const State& state) {
  std::vector<double> count(static_cast<std::size_t>(bins_.count()), 0);
  auto& mean = array(frame).values;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    mean[bin(state.position[i].y)] += state.velocity[i].x;
    count[bin(state.position[i].y)] += 1;
  }
  for (std::size_t b = 0; b < count.size(); ++b)
    if (count[b] > 0) mean[b] /= count[b];
}

void Correlations::sample(const State& state, std::span<const double> ux) {
  double& number = array(samples).values[0];
  if (std::fmod(number, static_cast<double>(stride)) == 0) add_pairs(state, ux);
  add_times(state, ux);
  number += 1;
}

void Correlations::add_pairs(const State& state, std::span<const double> ux) {
  const auto count = static_cast<std::size_t>(bins_.count());
  std::vector<std::vector<std::size_t>> members(count);
  for (std::size_t i = 0; i < state.position.size(); ++i) members[bin(state.position[i].y)].push_back(i);

  std::vector<std::complex<double>> hexatic(state.position.size());
  std::vector<double> near(state.position.size(), 0);
  const auto between = [&](std::size_t i, std::size_t j) {
    Vec2 r = state.position[j] - state.position[i];
    r.x -= length_ * std::round(r.x / length_);
    return r;
  };
  const auto order = [&](std::size_t i, std::size_t j, Vec2 r, double distance) {
    if (distance >= neighbour_range) return;
    const std::complex<double> e = std::polar(1.0, 6 * std::atan2(r.y, r.x));  // the same for r and -r
    hexatic[i] += e, hexatic[j] += e;
    near[i] += 1, near[j] += 1;
  };
  const auto correlate = [&](std::size_t b, std::size_t i, std::size_t j, double distance) {
    if (distance >= distance_range) return;
    const auto cell = static_cast<std::size_t>(distance / distance_range * static_cast<double>(distance_cells));
    const Vec2 c = state.velocity[i], d = state.velocity[j];
    const double mean = array(frame).values[b];
    array(pairs).at(b, cell) += 1;
    array(pair_ux).at(b, cell) += ux[i] * ux[j];
    array(pair_uy).at(b, cell) += c.y * d.y;
    array(pair_uxy).at(b, cell) += 0.5 * (ux[i] * d.y + ux[j] * c.y);
    array(pair_cx).at(b, cell) += (c.x - mean) * (d.x - mean);
    array(pair_cx_sum).at(b, cell) += 0.5 * (c.x + d.x) - mean;
  };

  const auto reach = static_cast<std::size_t>(std::ceil(neighbour_range * diameter_ / bins_.width()));
  for (std::size_t b = 0; b < count; ++b) {
    const auto& mine = members[b];
    const auto n = static_cast<double>(mine.size());
    array(total).values[b] += n * (n - 1) / 2;
    for (std::size_t k = 0; k < mine.size(); ++k) {
      for (std::size_t l = k + 1; l < mine.size(); ++l) {
        const Vec2 r = between(mine[k], mine[l]);
        const double distance = std::sqrt(dot(r, r)) / diameter_;
        order(mine[k], mine[l], r, distance);
        correlate(b, mine[k], mine[l], distance);
      }
      for (std::size_t other = b + 1; other <= b + reach && other < count; ++other)
        for (const std::size_t j : members[other]) {
          const Vec2 r = between(mine[k], j);
          order(mine[k], j, r, std::sqrt(dot(r, r)) / diameter_);
        }
    }
  }
  for (std::size_t b = 0; b < count; ++b)
    for (const std::size_t i : members[b]) {
      if (near[i] > 0) array(psi6).values[b] += std::abs(hexatic[i]) / near[i];
      array(neighbours).values[b] += near[i];
      array(disks).values[b] += 1;
    }
}

/// A new origin every lags - 1 samples. `origin` holds how far from it we are, then bin, u_x and c_y of each disk
/// there.
void Correlations::add_times(const State& state, std::span<const double> ux) {
  auto& start = array(origin).values;
  auto lag = static_cast<std::size_t>(array(samples).values[0] > 0 ? start[0] + 1 : 0);
  for (;;) {
    for (std::size_t i = 0; i < state.position.size(); ++i) {
      double* const at_origin = &start[1 + 3 * i];
      if (lag == 0) {
        at_origin[0] = static_cast<double>(bin(state.position[i].y));
        at_origin[1] = ux[i];
        at_origin[2] = state.velocity[i].y;
      }
      const auto b = static_cast<std::size_t>(at_origin[0]);
      array(time_ux).at(b, lag) += at_origin[1] * ux[i];
      array(time_uy).at(b, lag) += at_origin[2] * state.velocity[i].y;
      array(time_count).at(b, lag) += 1;
    }
    if (lag + 1 < lags) break;
    lag = 0;  // the last lag of one origin is the first of the next
  }
  start[0] = static_cast<double>(lag);
}

}  // namespace gpf
