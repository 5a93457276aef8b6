#include "gpf/methods/enskog_monte_carlo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/base/random.hpp"
#include "gpf/base/vec2.hpp"
#include "gpf/theory/contact_value.hpp"

namespace gpf {
namespace {

constexpr double freezing = 0.7, most_frozen = 0.01;
constexpr double densest = 0.85;   // that a slab can be by chance
constexpr double reach_along = 3;  // diameters over which coverages are averaged along x
// Streams of random numbers: far from each other, and from those of the Gaussian velocities, which start at 0.
constexpr std::uint64_t start_stream = std::uint64_t{1} << 62, collision_stream = std::uint64_t{1} << 61;

double unit(std::uint32_t word) { return (word + 0.5) * 0x1p-32; }

/// Part of a disk's area that lies less than a radius above or below a height `offset` diameters from its centre.
double part_in_slab(double offset) {
  const auto below = [](double h) {  // part of the area below h radii
    const double x = std::clamp(h, -1.0, 1.0);
    return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
  };
  return below(2 * offset + 1) - below(2 * offset - 1);
}

double wrapped(double value, double period) {
  const double w = value - period * std::floor(value / period);
  return w < period ? w : 0;
}

void normalise(std::vector<double>& kernel) {
  double sum = kernel[0];
  for (std::size_t k = 1; k < kernel.size(); ++k) sum += 2 * kernel[k];
  for (double& w : kernel) w /= sum;
}

void require(bool ok, const char* problem, const char* why, const char* remedy) {
  if (!ok) throw InputError(problem, why, remedy);
}

}  // namespace

EnskogMonteCarlo::EnskogMonteCarlo(const Scene& scene, const MonteCarloSetting& setting)
    : scene_(scene),
      channel_(scene.geometry == Geometry::channel),
      diameter_(scene.diameter()),
      bottom_(channel_ ? diameter_ / 2 : 0),
      room_(channel_ ? 1 - diameter_ : 1),
      length_(scene.length()),
      setting_step_(setting.step),
      step_(setting.step / scene.reference_collision_rate()),
      weight_(0),
      memory_(setting.step / 20),
      renewal_(setting.cells_along == 1 ? memory_ : 1),
      cells_(setting.cells),
      along_(setting.cells_along) {
  require(setting.cells >= 4, "less than 4 cells", "the profiles would not be resolved", "take 40");
  require(setting.particles_per_cell >= 10, "less than 10 particles in a cell",
          "partners would be the same few again and again", "take 100 or more");
  require(setting.cells_along >= 1, "less than 1 cell along the channel",
          "1 stands for a flow that is uniform along it", "take 1, or L/d");
  require(setting.step >= 1e-4 && setting.step <= 0.5, "the step is not between 1e-4 and 1/2 mean free times",
          "collisions and flight are taken in turn", "take 0.1");
  require(1.0 * cells_ * along_ * setting.particles_per_cell <= std::numeric_limits<std::int32_t>::max(),
          "more than 2^31 - 1 particles", "they are counted with 32 bits", "take fewer cells or particles in a cell");
  const auto cells = static_cast<std::size_t>(cells_) * static_cast<std::size_t>(along_);
  const auto all = cells * static_cast<std::size_t>(setting.particles_per_cell);
  weight_ = scene.particles / scene.length() / static_cast<double>(all);
  Vec2 mean;
  for (std::size_t i = 0; i < all; ++i) {
    const auto w = random_words(scene.seed, start_stream, i);
    position_.push_back({along_ > 1 ? length_ * unit(w[1]) : 0,
                         bottom_ + room_ * (static_cast<double>(i) + unit(w[0])) / static_cast<double>(all)});
    velocity_.push_back(scene.velocity_scale() * gaussian_pair(scene.seed, i));
    mean = mean + velocity_.back();
  }
  for (Vec2& c : velocity_) c = c - (1 / static_cast<double>(all)) * mean;
  fastest_ = 4 * scene.velocity_scale();
  fraction_.assign(cells, scene.area_fraction() / room_);
  coverage_ = fraction_;
  const int reach = std::min((cells_ - 1) / 2, static_cast<int>(diameter_ / room_ * cells_));
  for (int k = 0; k <= reach; ++k) kernel_.push_back(part_in_slab(k * room_ / (cells_ * diameter_)));
  const double column = length_ / (along_ * diameter_);
  for (int k = 0; k <= (along_ - 1) / 2 && k * column < reach_along; ++k)
    kernel_along_.push_back(1 - k * column / reach_along);
  for (auto* kernel : {&kernel_, &kernel_along_}) normalise(*kernel);
  sort_into_cells();
}

EnskogMonteCarlo::EnskogMonteCarlo(const Scene& scene, const MonteCarloSetting& setting, const State& start)
    : EnskogMonteCarlo(scene, setting) {
  if (start.position.size() != particles() || start.velocity.size() != particles())
    throw InputError(fmt::format("the start has {} particles, not {}", start.position.size(), particles()),
                     "the setting says how many are simulated", "give cells * cells_along * particles_per_cell");
  position_ = start.position;
  velocity_ = start.velocity;
  for (Vec2& r : position_) {
    require(r.y >= bottom_ && r.y <= bottom_ + room_, "a particle of the start is out of the channel",
            "its centre must be a radius from the walls", "give a y in [d/2, 1 - d/2], or [0, 1] without walls");
    r.x = along_ > 1 ? wrapped(r.x, length_) : 0;
  }
  const double renewal = std::exchange(renewal_, 1);  // nothing of the random places
  sort_into_cells();
  renewal_ = renewal;
}

void EnskogMonteCarlo::advance(double until) {
  constexpr double most_steps = 16;  // before the mean free time is looked at again
  while (time_ < until) {
    const double left = until - time_, wanted = std::ceil(left * rate() / setting_step_);
    const double steps = std::clamp(wanted, 1.0, most_steps);
    step_ = wanted <= most_steps ? left / steps : setting_step_ / rate();
    take_steps(static_cast<int>(steps));
    time_ = wanted <= most_steps ? until : time_ + steps * step_;
  }
}

/// Collisions of a particle, about: Enskog's rate at the mean of c_y^2, which no mean flow enters.
double EnskogMonteCarlo::rate() const {
  double sum = 0;
  for (const Vec2 c : velocity_) sum += square(c.y);
  return scene_.reference_collision_rate() * std::sqrt(sum / static_cast<double>(particles())) /
         scene_.velocity_scale();
}

void EnskogMonteCarlo::take_steps(int steps) {
  fly(step_ / 2);
  for (int k = 1; k <= steps; ++k) {
    sort_into_cells();
    collide();
    ++steps_;
    fly(k < steps ? step_ : step_ / 2);
  }
  sort_into_cells();
}

void EnskogMonteCarlo::fly(double time) {
  for (std::size_t i = 0; i < particles(); ++i) {
    if (channel_) {
      bounce(i, time);
    } else {
      position_[i].y = wrapped(position_[i].y + velocity_[i].y * time, 1);
      go_along(i, velocity_[i].x * time);
    }
  }
}

void EnskogMonteCarlo::go_along(std::size_t i, double distance) {
  if (along_ > 1) position_[i].x = wrapped(position_[i].x + distance, length_);
}

/// Flight for `time`, with all walls on the way.
void EnskogMonteCarlo::bounce(std::size_t i, double time) {
  Vec2& c = velocity_[i];
  double& y = position_[i].y;
  const double top = bottom_ + room_;
  const auto fall = [&](double t) {
    const double distance = c.x * t + scene_.gravity * t * t / 2;
    sums_.gravity_work += weight_ * scene_.gravity * distance;
    go_along(i, distance);
    c.x += scene_.gravity * t;
  };
  for (double left = time; left > 0;) {
    const double wall_y = c.y < 0 ? bottom_ : top;
    const double until = c.y == 0 ? left : std::max(0.0, (wall_y - y) / c.y);
    if (until >= left) {
      y = std::clamp(y + c.y * left, bottom_, top);
      fall(left);
      return;
    }
    fall(until);
    y = wall_y;
    const auto wall = static_cast<std::size_t>(c.y < 0 ? lower : upper);
    const double beta = scene_.wall_tangential_restitution[wall], e = scene_.wall_normal_restitution;
    sums_.wall_normal[wall] += weight_ * (1 + e) * std::abs(c.y);
    sums_.wall_tangential[wall] += weight_ * (1 - beta) * c.x;
    sums_.wall_loss[wall] += weight_ * ((1 - square(beta)) * square(c.x) + (1 - square(e)) * square(c.y)) / 2;
    const Vec2 before = c;
    c = {beta * c.x, -e * c.y};
    left -= until;
    if (watcher_ != nullptr)
      watcher_->on_wall(
          {this->time() + time - left, static_cast<std::int32_t>(i), static_cast<Wall>(wall), position_[i], before, c});
  }
}

int EnskogMonteCarlo::row_of(double y) const {
  return std::clamp(static_cast<int>((y - bottom_) / room_ * cells_), 0, cells_ - 1);
}

std::size_t EnskogMonteCarlo::cell_of(Vec2 r) const {
  const auto row = static_cast<std::size_t>(row_of(r.y));
  if (along_ == 1) return row;
  const int column = std::min(static_cast<int>(r.x / length_ * along_), along_ - 1);
  return row + static_cast<std::size_t>(cells_) * static_cast<std::size_t>(column);
}

/// Rows and columns less than a period out of range count from the other side.
std::size_t EnskogMonteCarlo::cell_at(int row, int column) const {
  const int r = (row + cells_) % cells_, c = (column + along_) % along_;
  return static_cast<std::size_t>(r) + static_cast<std::size_t>(cells_) * static_cast<std::size_t>(c);
}

void EnskogMonteCarlo::sort_into_cells() {
  first_.assign(fraction_.size() + 1, 0);
  for (const Vec2 r : position_) ++first_[cell_of(r) + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  order_.resize(particles());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < particles(); ++i) order_[next[cell_of(position_[i])]++] = i;
  const double of_one = std::numbers::pi * square(diameter_) / 4 * weight_ * cells_ * along_ / room_;
  for (std::size_t c = 0; c < fraction_.size(); ++c)
    fraction_[c] += (of_one * (first_[c + 1] - first_[c]) - fraction_[c]) * renewal_;
  average_coverage();
  refuse_frozen();
}

/// How much of the slab of a diameter's height about each cell's middle is covered by disks: what crowds a contact
/// there. The density of centres itself is no measure of it, since at a wall it rises to n Z.
void EnskogMonteCarlo::average_coverage() {
  const int reach = static_cast<int>(kernel_.size()) - 1, reach_x = static_cast<int>(kernel_along_.size()) - 1;
  std::vector<double> in_column(fraction_.size());
  for (int column = 0; column < along_; ++column) {
    for (int c = 0; c < cells_; ++c) {
      double sum = 0;
      for (int k = -reach; k <= reach; ++k)
        if (!channel_ || (c + k >= 0 && c + k < cells_))
          sum += kernel_[static_cast<std::size_t>(std::abs(k))] * fraction_[cell_at(c + k, column)];
      in_column[cell_at(c, column)] = sum;
    }
  }
  for (int column = 0; column < along_; ++column) {
    for (int c = 0; c < cells_; ++c) {
      double sum = 0;
      for (int k = -reach_x; k <= reach_x; ++k)
        sum += kernel_along_[static_cast<std::size_t>(std::abs(k))] * in_column[cell_at(c, column + k)];
      coverage_[cell_at(c, column)] = sum;
    }
  }
}

void EnskogMonteCarlo::refuse_frozen() {
  double frozen = 0;
  std::size_t most = 0;
  for (std::size_t c = 0; c < coverage_.size(); ++c) {
    if (coverage_[c] > freezing) frozen += first_[c + 1] - first_[c];
    if (coverage_[c] > coverage_[most]) most = c;
  }
  frozen_ += (frozen / static_cast<double>(particles()) - frozen_) * memory_;
  const auto refuse = [](const std::string& problem, const char* remedy) {
    throw PhysicsError(problem, "disks freeze at .7, and Enskog's equation does not know of it", remedy);
  };
  if (along_ == 1 && coverage_[most] > freezing)
    refuse(fmt::format("nu is {:.2f} in cell {} at time {:.4g}", coverage_[most], most, time()),
           "use the event-driven engine");
  if (along_ > 1 && frozen_ > most_frozen)
    refuse(fmt::format("{:.1f} % of the particles are where nu is above .7 at time {:.4g}", 100 * frozen_, time()),
           "take more particles in a cell, since few come so dense by chance, or the event-driven engine");
  for (double& nu : coverage_) nu = std::min(nu, densest);
}

/// For each cell the largest chi times number of partners that a particle in it can meet.
std::vector<double> EnskogMonteCarlo::crowds() const {
  const int reach = static_cast<int>(std::ceil(diameter_ / room_ * cells_)),
            reach_x = std::min(along_ / 2, static_cast<int>(std::ceil(diameter_ / length_ * along_)));
  std::vector<double> chi, crowd;
  for (const double nu : coverage_) chi.push_back(henderson_contact_value(nu));
  for (int column = 0; column < along_; ++column) {
    for (int c = 0; c < cells_; ++c) {
      double most_chi = 0, most = 0;
      for (int k = c - reach; k <= c + reach; ++k) {
        if (channel_ && (k < 0 || k >= cells_)) continue;
        for (int x = column - reach_x; x <= column + reach_x; ++x) {
          const std::size_t other = cell_at(k, x);
          most_chi = std::max(most_chi, chi[other]);
          most = std::max(most, static_cast<double>(first_[other + 1] - first_[other]));
        }
      }
      crowd.push_back(most_chi * most);
    }
  }
  return crowd;
}

/// Candidates come at the rate that the most crowded partner cell and the speed `fastest_` would give, and are taken
/// with the ratio of their own rate to it. A pair faster than that is taken once only: `fastest_` is kept where a part
/// of 1e-4 of all collisions is missed so, since the few fastest pairs would make most candidates be in vain.
void EnskogMonteCarlo::collide() {
  constexpr double most_missed = 1e-4;
  const double e = scene_.normal_restitution;
  const double density = weight_ * cells_ * along_ / room_;  // of one particle in a cell
  const double per_crowd = std::numbers::pi * diameter_ * density * fastest_ * step_;
  const std::vector<double> crowd = crowds();
  std::uint64_t taken = 0;
  double missed = 0;
  for (std::size_t i = 0; i < particles(); ++i) {
    const Vec2 r = position_[i];
    const double crowd_here = crowd[cell_of(r)];
    // Often more than one candidate a step: whole ones, and the rest by chance.
    std::uint64_t index = i;
    for (double left = per_crowd * crowd_here; left > 0; left -= 1, index += particles()) {
      const auto w = random_words(scene_.seed, collision_stream + steps_, index);
      if (left < 1 && unit(w[0]) > left) break;
      const double angle = 2 * std::numbers::pi * unit(w[1]);
      const Vec2 s{std::cos(angle), std::sin(angle)};
      Vec2 there = r + diameter_ * s, half_way = r + (diameter_ / 2) * s;
      if (channel_ && (there.y < bottom_ || there.y > bottom_ + room_)) continue;
      for (Vec2* p : {&there, &half_way}) {
        if (!channel_) p->y = wrapped(p->y, 1);
        if (along_ > 1) p->x = wrapped(p->x, length_);
      }
      const std::size_t cell = cell_of(there);
      const std::uint32_t count = first_[cell + 1] - first_[cell];
      if (count == 0) continue;
      const std::uint32_t j =
          order_[first_[cell] + std::min(static_cast<std::uint32_t>(unit(w[2]) * count), count - 1)];
      if (j == i) continue;
      const double approach = dot(velocity_[i] - velocity_[j], s);
      if (approach <= 0) continue;
      const double chi = henderson_contact_value(coverage_[cell_of(half_way)]);
      const double part = approach * chi * count / (fastest_ * crowd_here);
      if (unit(w[3]) > part) continue;
      missed += std::max(0.0, part - 1);
      ++taken;
      const Vec2 impulse = ((1 + e) / 2 * approach) * s;
      velocity_[i] = velocity_[i] - impulse;
      velocity_[j] = velocity_[j] + impulse;
      sums_.pair_loss += weight_ * (1 - square(e)) / 4 * square(approach);
      if (watcher_ != nullptr)
        watcher_->on_pair({time(), static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), r, diameter_ * s,
                           velocity_[i], velocity_[j], impulse, (1 - square(e)) / 4 * square(approach)});
    }
  }
  sums_.collisions += taken;
  missed_ += missed, taken_ += static_cast<double>(taken);
  fastest_ *= missed_ > most_missed * taken_ ? 1.01 : 0.999;
  missed_ *= 0.99, taken_ *= 0.99;
}

State EnskogMonteCarlo::state() const { return {position_, velocity_}; }

double EnskogMonteCarlo::kinetic_energy() const {
  double sum = 0;
  for (const Vec2 v : velocity_) sum += dot(v, v);
  return weight_ * sum / 2;
}

}  // namespace gpf
