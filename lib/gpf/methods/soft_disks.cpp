#include "gpf/methods/soft_disks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

constexpr double skin = 0.4;  // of the list of neighbours, in diameters
constexpr int fewest_steps = 2;

void require(bool ok, const char* problem, const char* why, const char* remedy) {
  if (!ok) throw InputError(problem, why, remedy);
}

}  // namespace

SoftDisks::Spring SoftDisks::spring_of(double restitution, double duration, double mass) {
  const double eta = -std::log(restitution) / duration, omega = std::numbers::pi / duration;
  return {mass * (square(omega) + square(eta)), 2 * mass * eta};
}

SoftDisks::SoftDisks(const Scene& scene, const SoftContact& contact, const State& start)
    : scene_(scene),
      channel_(scene.geometry == Geometry::channel),
      diameter_(scene.diameter()),
      length_(scene.length()),
      step_(contact.duration / contact.steps_per_contact),
      position_(start.position),
      velocity_(start.velocity) {
  const auto count = static_cast<std::size_t>(std::max(0, scene.particles));
  require(count > 0 && start.position.size() == count && start.velocity.size() == count,
          "the start state does not fit the scene", "it must hold a position and a velocity for each disk",
          "give as many of both as the scene has particles, at least one");
  require(contact.duration > 0 && std::isfinite(contact.duration), "a contact lasts no time",
          "soft disks overlap while they touch", "give a duration, 1/50 of the mean free time or less");
  require(contact.steps_per_contact >= fewest_steps, "a contact has fewer than 2 steps",
          "a spring cannot be followed so coarsely", "take 25");
  require(scene.normal_restitution > 0 && scene.wall_normal_restitution > 0, "a restitution is 0",
          "no linear dashpot has it", "take 0.05 or more, or hard disks");
  require(length_ > 2 * diameter_ && (channel_ || 1 > 2 * diameter_), "a period is too short",
          "with two diameters or less the nearest image of a disk is not unique", "use a longer or wider scene");
  pair_ = spring_of(scene.normal_restitution, contact.duration, 0.5);
  wall_ = spring_of(scene.wall_normal_restitution, contact.duration, 1);
  force_.resize(count);
  expected_velocity_ = velocity_;
  turned_.assign(count, 0);
  build_neighbours();
  compute_forces();
  sums_ = {};  // no time has passed yet
}

void SoftDisks::advance(double until) {
  const auto last = static_cast<std::uint64_t>(std::max(0.0, std::round(until / step_)));
  while (steps_ < last) take_step();
}

void SoftDisks::take_step() {
  const double half = step_ / 2;
  for (std::size_t i = 0; i < position_.size(); ++i) {
    velocity_[i] = velocity_[i] + half * force_[i];
    position_[i] = position_[i] + step_ * velocity_[i];
    sums_.gravity_work += scene_.gravity * step_ * velocity_[i].x;
    expected_velocity_[i] = velocity_[i] + half * force_[i];
  }
  ++steps_;
  if (neighbours_are_stale()) build_neighbours();
  compute_forces();
  for (std::size_t i = 0; i < position_.size(); ++i) velocity_[i] = velocity_[i] + half * force_[i];
  if (channel_) turn_at_walls();
}

void SoftDisks::compute_forces() {
  std::fill(force_.begin(), force_.end(), Vec2{scene_.gravity, 0});
  contact_energy_ = 0;
  pair_forces();
  if (channel_) wall_forces();
}

void SoftDisks::pair_forces() {
  const double reach = square(diameter_);
  for (const auto& [i, j] : neighbours_) {
    const Vec2 r = nearest(position_[j] - position_[i]);
    const double squared = dot(r, r);
    if (squared >= reach) continue;
    const double distance = std::sqrt(squared), overlap = diameter_ - distance;
    deepest_overlap_ = std::max(deepest_overlap_, overlap);
    if (!(overlap < diameter_ / 2))
      throw PhysicsError(
          fmt::format("disks {} and {} overlap by {:.3g} d at time {:.6g}", i, j, overlap / diameter_, time()),
          "the contacts are too soft for these velocities, or the steps too large",
          "shorten the contact's duration, or take more steps in it");
    const Vec2 n = (1 / distance) * r;
    const double separation = dot(expected_velocity_[j] - expected_velocity_[i], n);
    const double push = pair_.stiffness * overlap - pair_.damping * separation;
    force_[i] = force_[i] - push * n;
    force_[j] = force_[j] + push * n;
    contact_energy_ += 0.5 * pair_.stiffness * square(overlap);
    sums_.pair_loss += step_ * pair_.damping * square(separation);
    sums_.virial += step_ * push * distance;
    if (watcher_ != nullptr)
      watcher_->on_pair({time(), static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), position_[i], r,
                         expected_velocity_[i], expected_velocity_[j], (step_ * push) * n,
                         step_ * pair_.damping * square(separation)});
  }
}

void SoftDisks::wall_forces() {
  const double radius = diameter_ / 2;
  for (std::size_t i = 0; i < position_.size(); ++i)
    for (const Wall wall : {lower, upper}) {
      const double outward = wall == lower ? -1 : 1;
      const double overlap = radius - (wall == lower ? position_[i].y : 1 - position_[i].y);
      if (overlap <= 0) continue;
      if (!(overlap < radius))
        throw PhysicsError(fmt::format("disk {} leaves the channel at time {:.6g}", i, time()),
                           "the walls are too soft for its velocity, or the steps too large",
                           "shorten the contact's duration, or take more steps in it");
      const auto w = static_cast<std::size_t>(wall);
      const double approach = outward * expected_velocity_[i].y;
      const double push = wall_.stiffness * overlap + wall_.damping * approach;
      force_[i].y -= outward * push;
      contact_energy_ += 0.5 * wall_.stiffness * square(overlap);
      sums_.wall_loss[w] += step_ * wall_.damping * square(approach);
      sums_.wall_normal[w] += step_ * push;
      if (watcher_ != nullptr)
        watcher_->on_wall({time(), static_cast<std::int32_t>(i), wall, position_[i], expected_velocity_[i],
                           expected_velocity_[i] - Vec2{0, outward * step_ * push}});
    }
}

void SoftDisks::turn_at_walls() {
  const double radius = diameter_ / 2;
  for (std::size_t i = 0; i < position_.size(); ++i) {
    const bool below = position_[i].y<radius, above = position_[i].y> 1 - radius;
    if (!below && !above) {
      turned_[i] = 0;
      continue;
    }
    const bool leaving = below ? velocity_[i].y > 0 : velocity_[i].y < 0;
    if (turned_[i] != 0 || !leaving) continue;
    turned_[i] = 1;
    const auto wall = static_cast<std::size_t>(below ? lower : upper);
    const double beta = scene_.wall_tangential_restitution[wall], before = velocity_[i].x;
    velocity_[i].x *= beta;
    if (watcher_ != nullptr)
      watcher_->on_wall({time(),
                         static_cast<std::int32_t>(i),
                         static_cast<Wall>(wall),
                         position_[i],
                         {before, velocity_[i].y},
                         velocity_[i]});
    sums_.wall_loss[wall] += 0.5 * (1 - square(beta)) * square(before);
    sums_.wall_tangential[wall] += (1 - beta) * before;
  }
}

Vec2 SoftDisks::nearest(Vec2 r) const {
  r.x -= length_ * std::nearbyint(r.x / length_);
  if (!channel_) r.y -= std::nearbyint(r.y);
  return r;
}

/// Some pair may have come nearer by the skin: two disks have moved by half of it against the mean of all.
bool SoftDisks::neighbours_are_stale() const {
  Vec2 mean;
  for (std::size_t i = 0; i < position_.size(); ++i) mean = mean + (position_[i] - listed_at_[i]);
  mean = (1 / static_cast<double>(position_.size())) * mean;
  const double most = square(skin * diameter_ / 2);
  for (std::size_t i = 0; i < position_.size(); ++i) {
    const Vec2 moved = position_[i] - listed_at_[i] - mean;
    if (dot(moved, moved) > most) return true;
  }
  return false;
}

void SoftDisks::build_neighbours() {
  listed_at_ = position_;
  neighbours_.clear();
  const double reach = (1 + skin) * diameter_;
  const auto count = static_cast<std::uint32_t>(position_.size());
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    const Vec2 r = nearest(position_[j] - position_[i]);
    if (dot(r, r) < square(reach)) neighbours_.emplace_back(std::min(i, j), std::max(i, j));
  };
  const int along = static_cast<int>(length_ / reach), across = std::max(1, static_cast<int>(1 / reach));
  if (along < 3 || (!channel_ && across < 3)) {
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t j = i + 1; j < count; ++j) add(i, j);
    return;
  }
  const auto cell_of = [&](double place, double size, int cells) {
    const double wrapped = place - size * std::floor(place / size);
    return std::min(static_cast<int>(wrapped / size * cells), cells - 1);
  };
  // Chains through the disks of each cell.
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> first(static_cast<std::size_t>(along) * static_cast<std::size_t>(across), none),
      next(count, none);
  const auto chain = [&](int cx, int cy) -> std::uint32_t& {
    return first[static_cast<std::size_t>(cx) * static_cast<std::size_t>(across) + static_cast<std::size_t>(cy)];
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const double y = channel_ ? std::clamp(position_[i].y, 0.0, std::nextafter(1.0, 0.0)) : position_[i].y;
    std::uint32_t& head = chain(cell_of(position_[i].x, length_, along), cell_of(y, 1, across));
    next[i] = head;
    head = i;
  }
  // Half of the neighbourhood of each cell, itself included.
  constexpr std::array<std::pair<int, int>, 4> half{{{1, -1}, {1, 0}, {1, 1}, {0, 1}}};
  for (int cx = 0; cx < along; ++cx)
    for (int cy = 0; cy < across; ++cy)
      for (std::uint32_t i = chain(cx, cy); i != none; i = next[i]) {
        for (std::uint32_t j = next[i]; j != none; j = next[j]) add(i, j);
        for (const auto& [dx, dy] : half) {
          int y = cy + dy;
          if (y < 0 || y >= across) {
            if (channel_) continue;
            y = (y + across) % across;
          }
          for (std::uint32_t j = chain((cx + dx) % along, y); j != none; j = next[j]) add(i, j);
        }
      }
  // In the order of the disks, so that sums of forces do not depend on how cells are chained.
  std::sort(neighbours_.begin(), neighbours_.end());
}

State SoftDisks::state() const {
  State state{position_, velocity_};
  for (Vec2& r : state.position) {
    r.x -= length_ * std::floor(r.x / length_);
    if (r.x >= length_) r.x = 0;
    if (!channel_) r.y -= std::floor(r.y);
  }
  return state;
}

double SoftDisks::kinetic_energy() const {
  double sum = 0;
  for (const Vec2 v : velocity_) sum += dot(v, v);
  return sum / 2;
}

}  // namespace gpf
