// Example of reference/guide/method.md: another way to the flow of a scene - disks that meet walls only.
#include <cmath>
#include <cstdio>
#include <vector>

#include "gpf/measure/measurement.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/methods/contact_watcher.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/start.hpp"

using namespace gpf;

/// The limit of an infinite Knudsen number: every disk flies as if it were alone. Units as in Scene.
class Collisionless {
 public:
  Collisionless(const Scene& scene, State start) : scene_(scene), state_(std::move(start)) {}

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const State& state() const { return state_; }
  void watch(ContactWatcher* watcher) { watcher_ = watcher; }

  void advance(double until) {
    for (std::size_t i = 0; i < state_.position.size(); ++i) fly(i, until);
    time_ = until;
  }

 private:
  void fly(std::size_t i, double until) {
    Vec2 &r = state_.position[i], &c = state_.velocity[i];
    const double lower = scene_.diameter() / 2, upper = 1 - lower, length = scene_.length();
    for (double now = time_; now < until;) {
      const Wall wall = c.y < 0 ? Wall::lower : Wall::upper;
      const double contact = now + ((wall == Wall::lower ? lower : upper) - r.y) / c.y;
      const double lapse = std::min(contact, until) - now;
      r.x += lapse * (c.x + 0.5 * scene_.gravity * lapse);
      r.x -= length * std::floor(r.x / length);
      c.x += scene_.gravity * lapse;
      r.y += lapse * c.y;
      now += lapse;
      if (contact >= until) return;
      const Vec2 before = c;
      c = {scene_.wall_tangential_restitution[static_cast<std::size_t>(wall)] * c.x,
           -scene_.wall_normal_restitution * c.y};
      if (watcher_ != nullptr) watcher_->on_wall({now, static_cast<std::int32_t>(i), wall, r, before, c});
    }
  }

  Scene scene_;
  State state_;
  double time_ = 0;
  ContactWatcher* watcher_ = nullptr;
};

/// Shows a measurement what the method does.
struct Watch final : ContactWatcher {
  explicit Watch(Measurement& m) : measurement(m) {}
  void on_pair(const PairContact& contact) override { measurement.on_pair(contact); }
  void on_wall(const WallContact& contact) override { measurement.on_wall(contact); }
  Measurement& measurement;
};

int main() {
  Scene scene;
  scene.particles = 400;
  scene.width_over_diameter = 20;
  scene.length_over_width = 4;
  scene.wall_tangential_restitution = {0.5, 0.5};
  scene.gravity = 1;
  State start = start_state(scene);
  for (Vec2& c : start.velocity) c.y = c.y < 0 ? -1 : 1;

  Collisionless method(scene, start);
  Measurement measurement(scene, 12);
  Watch watch(measurement);
  method.watch(&watch);
  const double start_up = 50, interval = 0.037, end = 150;
  method.advance(start_up);
  measurement.begin(start_up, method.state());
  for (double time = start_up; time < end;) {
    time += interval;
    method.advance(time);
    measurement.sample(time, method.state());
  }
  std::vector<double> totals(measurement.layout().size());
  const auto sums = measurement.series().sums();
  for (std::size_t k = 0; k < sums.size(); ++k) totals[k % totals.size()] += sums[k];

  // Between walls t_1 apart <u_x> = g t_1 (1 + beta)/(2 (1 - beta)): u_x gains g t_1 on the way, beta of it is left.
  const double beta = 0.5, exact = (1 - scene.diameter()) * (1 + beta) / (2 * (1 - beta));
  double flow = 0;
  for (const Quantity& q : derive_quantities(scene, measurement.layout(), totals))
    if (q.name == "mean_flow") flow = q.values.front();
  std::printf("mean flow %.3f, exactly %.3f\n", flow, exact);
  return std::abs(flow / exact - 1) < 0.01 ? 0 : 1;
}
