#include "gpf/measure/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gpf {
namespace {

/// Cell of x in [lo, hi), the outermost for what lies beyond.
std::size_t cell_of(double x, double lo, double hi, std::size_t cells) {
  const double place = (x - lo) / (hi - lo) * static_cast<double>(cells);
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(cells - 1)));
}

/// lambda = <|u|>/omega of a uniform gas, which no temperature changes.
double enskog_free_path(const Scene& scene) {
  return std::sqrt(std::numbers::pi / 2) * scene.velocity_scale() / scene.reference_collision_rate();
}

}  // namespace

Distributions::Distributions(const Scene& scene, int bins) : bins_(bins) {
  const auto b = static_cast<std::size_t>(bins), disks = static_cast<std::size_t>(scene.particles);
  arrays_ = {{"velocity/frame", {b, 3}},           {"velocity/ux", {b, velocity_cells}},
             {"velocity/uy", {b, velocity_cells}}, {"velocity/cx", {b, flow_cells}},
             {"contact/angle", {b, angle_cells}},  {"free_path/unit", {1}},
             {"free_path/lab", {path_cells}},      {"free_path/peculiar", {path_cells}},
             {"free_path/last", {disks}},          {"free_path/flow", {b, 2}}};
  array(unit).values[0] = enskog_free_path(scene);
}

void Distributions::begin(const State& state) {
  const auto count = static_cast<std::size_t>(bins_.count());
  struct Sums {
    double n = 0, x = 0, xx = 0, yy = 0;
  };
  std::vector<Sums> sums(count + 1);  // the last: all disks
  for (std::size_t i = 0; i < state.position.size(); ++i)
    for (Sums* s : {&sums[bin(state.position[i].y)], &sums[count]}) {
      const Vec2 c = state.velocity[i];
      s->n += 1, s->x += c.x, s->xx += c.x * c.x, s->yy += c.y * c.y;
    }
  for (std::size_t b = 0; b < count; ++b) {
    const Sums& s = sums[b].n < 8 ? sums[count] : sums[b];  // a bin that is almost empty says nothing
    const double mean = s.x / s.n;
    array(frame).at(b, 0) = mean;
    array(frame).at(b, 1) = std::sqrt(std::max(s.xx / s.n - mean * mean, 1e-12));
    array(frame).at(b, 2) = std::sqrt(std::max(s.yy / s.n, 1e-12));
  }
}

void Distributions::on_pair(const PairContact& c) {
  const double turn = std::atan2(c.r_12.y, c.r_12.x);
  const double half_turn = turn < 0 ? turn + std::numbers::pi : turn;
  double middle = c.position.y + 0.5 * c.r_12.y;
  middle -= std::floor(middle);
  array(angle).at(bin(middle), cell_of(half_turn, 0, std::numbers::pi, angle_cells)) += 1;
  for (const std::int32_t disk : {c.first, c.second}) array(last_time).values[static_cast<std::size_t>(disk)] = c.time;
}

void Distributions::free_path(std::int32_t disk, const PairContact& c, Vec2 displacement) {
  const double path_unit = array(unit).values[0];
  const auto add = [&](Name name, Vec2 path) {
    const double octave = std::log2(std::sqrt(dot(path, path)) / path_unit);
    array(name).values[cell_of(octave, std::log2(path_least), std::log2(path_most), path_cells)] += 1;
  };
  add(lab, displacement);
  double y = c.position.y + (disk == c.second ? c.r_12.y : 0);  // where the path ends
  y -= std::floor(y);
  const std::size_t b = bin(y);
  const double disks = array(flow).at(b, 1), lapse = c.time - array(last_time).values[static_cast<std::size_t>(disk)];
  if (disks > 0) add(peculiar, {displacement.x - array(flow).at(b, 0) / disks * lapse, displacement.y});
}

void Distributions::sample(const State& state, std::span<const double> fluctuation) {
  const auto add = [this](Name name, std::size_t b, double u, double range, std::size_t cells) {
    array(name).at(b, cell_of(u, -range, range, cells)) += 1;
  };
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const std::size_t b = bin(state.position[i].y);
    const Vec2 c = state.velocity[i];
    const double mean = array(frame).at(b, 0), sigma_x = array(frame).at(b, 1), sigma_y = array(frame).at(b, 2);
    add(ux, b, fluctuation[i] / sigma_x, velocity_range, velocity_cells);
    add(uy, b, c.y / sigma_y, velocity_range, velocity_cells);
    add(cx, b, (c.x - mean) / sigma_x, flow_range, flow_cells);
    array(flow).at(b, 0) += c.x;
    array(flow).at(b, 1) += 1;
  }
}

}  // namespace gpf
