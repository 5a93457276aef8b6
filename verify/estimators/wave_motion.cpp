#include "verify/estimators/wave_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gpf {
namespace {

constexpr double turn = 2 * std::numbers::pi;

const std::vector<double>& of_shape(const DensityContrast& contrast, ModeShape shape) {
  return shape == ModeShape::even ? contrast.even : shape == ModeShape::odd ? contrast.odd : contrast.varicose;
}

Vec2 amplitude(const Record& record, const Snapshot& snapshot, ModeShape shape, int k) {
  const DensityModes modes = density_modes(snapshot.state, record.scene.length(), k);
  return modes.amplitude[static_cast<std::size_t>(shape)].back();
}

}  // namespace

StrongestMode strongest_mode(const DensityContrast& contrast) {
  StrongestMode strongest{ModeShape::even, 1, 0};
  for (const ModeShape shape : mode_shapes) {
    const std::vector<double>& c = of_shape(contrast, shape);
    for (std::size_t k = 0; k < c.size(); ++k)
      if (c[k] > strongest.contrast) strongest = {shape, static_cast<int>(k) + 1, c[k]};
  }
  return strongest;
}

std::optional<double> onset_time(const Record& record, ModeShape shape, int k, std::size_t window) {
  const BlockTimes block = block_times(record);
  std::vector<double> middles;
  std::vector<bool> seen;
  for (std::size_t b = 0; b + window <= record.blocks; b += window) {
    const double from = block.start + static_cast<double>(b) * block.length,
                 to = from + static_cast<double>(window) * block.length;
    middles.push_back((from + to) / 2);
    seen.push_back(of_shape(density_contrast_between(record, from, to), shape)[static_cast<std::size_t>(k) - 1] >=
                   visible_contrast);
  }
  for (std::size_t w = 0; w < seen.size(); ++w) {
    const auto from = seen.begin() + static_cast<std::ptrdiff_t>(w);
    if (seen[w] && 2 * std::count(from, seen.end(), true) >= seen.end() - from) return middles[w];
  }
  return std::nullopt;
}

std::optional<double> mode_speed(const Record& record, ModeShape shape, int k) {
  if (record.snapshots.size() < 2 || !(record.snapshots.back().time > record.snapshots.end()[-2].time))
    return std::nullopt;
  const Snapshot &before = record.snapshots[record.snapshots.size() - 2], &after = record.snapshots.back();
  const Vec2 a = amplitude(record, before, shape, k), b = amplitude(record, after, shape, k);
  const double turned = std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
  const double per_speed = turn * k * (after.time - before.time) / record.scene.length();
  const double flow = snapshot_flow(record);
  return flow + std::remainder(turned - per_speed * flow, turn) / per_speed;
}

double snapshot_flow(const Record& record) {
  const State& state = record.snapshots[record.snapshots.size() - 2].state;
  double sum = 0;
  for (const Vec2 v : state.velocity) sum += v.x;
  return sum / static_cast<double>(state.velocity.size());
}

}  // namespace gpf
