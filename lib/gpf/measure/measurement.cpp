#include "gpf/measure/measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/measure/density_modes.hpp"

namespace gpf {

Measurement::Measurement(const Scene& scene, int bins, Detail detail, int density_modes)
    : channel_(scene.geometry == Geometry::channel),
      disks_(scene.particles),
      gravity_(scene.gravity),
      radius_(scene.diameter() / 2),
      length_(scene.length()),
      bins_(bins),
      layout_(bins, density_modes),
      series_(layout_.size()),
      open_(layout_.size(), 0.0),
      travels_(static_cast<std::size_t>(scene.particles)) {
  if (detail != Detail::profiles) distributions_.emplace(scene, bins);
  if (detail == Detail::correlations) correlations_.emplace(scene, bins);
}

void Measurement::begin(double time, const State& state) {
  begun_ = true;
  last_time_ = momentum_time_ = time;
  momentum_ = momentum(state).x;
  energy_ = kinetic_energy(state);
  std::fill(open_.begin(), open_.end(), 0.0);
  for (std::size_t i = 0; i < travels_.size(); ++i) travels_[i] = {time, state.velocity[i], {}, 0};
  if (distributions_) distributions_->begin(state);
  if (correlations_) correlations_->begin(state);
}

/// Work of gravity since momentum_time_: g times the integral of the total momentum, which grows as N g t between
/// wall contacts.
void Measurement::gravity_until(double time) {
  const double lapse = time - momentum_time_, weight = disks_ * gravity_;
  sum(Tally::gravity_work) += gravity_ * lapse * (momentum_ + 0.5 * weight * lapse);
  momentum_ += weight * lapse;
  momentum_time_ = time;
}

void Measurement::travel(std::int32_t disk, double time, Vec2 velocity_after, const PairContact* pair) {
  Travel& t = travels_[static_cast<std::size_t>(disk)];
  const double lapse = time - t.time;
  t.displacement = t.displacement + lapse * t.velocity + Vec2{0.5 * gravity_ * lapse * lapse, 0};
  t.time = time;
  t.velocity = velocity_after;
  if (pair == nullptr) return;
  if (t.started > 0) {
    sum(Tally::free_paths) += 1;
    sum(Tally::free_path) += std::sqrt(dot(t.displacement, t.displacement));
    if (distributions_) distributions_->free_path(disk, *pair, t.displacement);
  }
  t.started = 1;
  t.displacement = {};
}

/// J_a r_b of a contact line, shared over the bins that it crosses (Irving & Kirkwood's straight contour).
void Measurement::add_stress(Vec2 impulse, Vec2 r, double from, double to) {
  bins_.share(from, to, !channel_, [&](int bin, double fraction) {
    sum(Tally::stress_xx, bin) += fraction * impulse.x * r.x;
    sum(Tally::stress_xy, bin) += fraction * impulse.x * r.y;
    sum(Tally::stress_yy, bin) += fraction * impulse.y * r.y;
  });
}

void Measurement::on_pair(const PairContact& c) {
  if (!begun_) return;
  sum(Tally::pair_contacts) += 1;
  sum(Tally::pair_loss) += c.energy_loss;
  sum(Tally::virial) += dot(c.r_12, c.impulse);
  add_stress(c.impulse, c.r_12, c.position.y, c.position.y + c.r_12.y);
  double middle = c.position.y + 0.5 * c.r_12.y;
  if (!channel_) middle -= std::floor(middle);
  sum(Tally::contacts, bins_.at(middle)) += 1;
  sum(Tally::loss, bins_.at(middle)) += c.energy_loss;
  travel(c.first, c.time, c.velocity_1, &c);
  travel(c.second, c.time, c.velocity_2, &c);
  if (distributions_) distributions_->on_pair(c);
}

void Measurement::on_wall(const WallContact& c) {
  if (!begun_) return;
  gravity_until(c.time);
  const Vec2 impulse = c.velocity_after - c.velocity_before;  // that the disk received
  momentum_ += impulse.x;
  const int wall = c.wall;
  sum(Tally::wall_contacts, wall) += 1;
  sum(Tally::wall_normal, wall) += c.wall == Wall::lower ? impulse.y : -impulse.y;
  sum(Tally::wall_tangential, wall) -= impulse.x;
  sum(Tally::wall_loss, wall) +=
      0.5 * (dot(c.velocity_before, c.velocity_before) - dot(c.velocity_after, c.velocity_after));
  const double surface = c.wall == Wall::lower ? 0 : 1;  // the line from the wall's surface to the disk's centre
  const Vec2 r{0, c.wall == Wall::lower ? radius_ : -radius_};
  add_stress(impulse, r, surface, surface + r.y);
  travel(c.disk, c.time, c.velocity_after, nullptr);
}

void Measurement::add_fields(const State& state) {
  const auto size = static_cast<std::size_t>(bins_.count());
  std::vector<double> count(size, 0), mean(size, 0);
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const auto b = static_cast<std::size_t>(bins_.at(state.position[i].y));
    count[b] += 1;
    mean[b] += state.velocity[i].x;
  }
  for (std::size_t b = 0; b < size; ++b) {
    if (count[b] == 0) continue;
    mean[b] /= count[b];
    sum(Tally::count, static_cast<int>(b)) += count[b];
    sum(Tally::freedom, static_cast<int>(b)) += count[b] - 1;
  }
  std::vector<double> ux(state.position.size());
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const int b = bins_.at(state.position[i].y);
    const Vec2 c = state.velocity[i];
    const double u = c.x - mean[static_cast<std::size_t>(b)];
    ux[i] = u;
    const double cx2 = c.x * c.x, cy2 = c.y * c.y, u2 = u * u;
    sum(Tally::cx, b) += c.x;
    sum(Tally::cx2, b) += cx2;
    sum(Tally::cx3, b) += cx2 * c.x;
    sum(Tally::cx4, b) += cx2 * cx2;
    sum(Tally::cy, b) += c.y;
    sum(Tally::cy2, b) += cy2;
    sum(Tally::cy3, b) += cy2 * c.y;
    sum(Tally::cy4, b) += cy2 * cy2;
    sum(Tally::cxcy, b) += c.x * c.y;
    sum(Tally::ux2, b) += u2;
    sum(Tally::ux3, b) += u2 * u;
    sum(Tally::ux4, b) += u2 * u2;
    sum(Tally::speed) += std::sqrt(cx2 + cy2);
    sum(Tally::peculiar_speed) += std::sqrt(u2 + cy2);
  }
  if (distributions_) distributions_->sample(state, ux);
  if (correlations_) correlations_->sample(state, ux);
}

void Measurement::add_density_modes(const State& state) {
  if (layout_.density_modes() == 0) return;
  const DensityModes modes = density_modes(state, length_, layout_.density_modes());
  constexpr std::array power{Tally::mode_even, Tally::mode_odd, Tally::mode_varicose};
  constexpr std::array noise{Tally::mode_noise_even, Tally::mode_noise_odd, Tally::mode_noise_varicose};
  for (std::size_t s = 0; s < mode_shapes.size(); ++s) {
    for (int k = 0; k < layout_.density_modes(); ++k) sum(power[s], k) += modes.power[s][static_cast<std::size_t>(k)];
    sum(noise[s]) += modes.noise[s];
  }
  sum(Tally::band_cos) += modes.band.x;
  sum(Tally::band_sin) += modes.band.y;
}

void Measurement::sample(double time, const State& state) {
  gravity_until(time);
  const double energy = kinetic_energy(state);
  momentum_ = momentum(state).x;
  sum(Tally::measured_time) += time - last_time_;
  sum(Tally::samples) += 1;
  sum(Tally::energy) += energy;
  sum(Tally::momentum) += momentum_;
  sum(Tally::energy_change) += energy - energy_;
  add_fields(state);
  add_density_modes(state);
  last_time_ = time;
  energy_ = energy;
  series_.add(open_);
  std::fill(open_.begin(), open_.end(), 0.0);
}

Measurement::Memory Measurement::memory() const {
  return {begun_, last_time_, momentum_time_, momentum_, energy_, open_, travels_, series_.memory(), arrays()};
}

NamedArrays Measurement::arrays() const {
  NamedArrays all;
  if (distributions_) all = distributions_->arrays();
  if (correlations_) all.insert(all.end(), correlations_->arrays().begin(), correlations_->arrays().end());
  return all;
}

void Measurement::restore(const Memory& memory) {
  if (memory.open.size() != open_.size() || memory.travels.size() != travels_.size())
    throw InputError("a checkpoint's measurement does not fit this run",
                     "it was written for other bins or another scene", "start the run anew, without --resume");
  begun_ = memory.begun;
  last_time_ = memory.last_time;
  momentum_time_ = memory.momentum_time;
  momentum_ = memory.momentum;
  energy_ = memory.energy;
  open_ = memory.open;
  travels_ = memory.travels;
  series_.restore(memory.series);
  const auto take = [&memory](NamedArrays& arrays) {
    for (NamedArray& array : arrays) {
      const NamedArray& kept = array_named(memory.arrays, array.name);
      if (kept.shape != array.shape)
        throw InputError("a checkpoint's array " + array.name + " has another shape", "it was written by another gpf",
                         "start the run anew, without --resume");
      array.values = kept.values;
    }
  };
  if (distributions_) take(distributions_->arrays());
  if (correlations_) take(correlations_->arrays());
}

}  // namespace gpf
