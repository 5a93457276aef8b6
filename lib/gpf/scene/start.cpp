#include "gpf/scene/start.hpp"

#include <cmath>
#include <cstdint>

#include "gpf/base/random.hpp"
#include "gpf/scene/lattice.hpp"

namespace gpf {
namespace {

/// Kahan's compensated sum: its error does not grow with the number of terms.
class Sum {
 public:
  void add(double term) {
    const double corrected = term - lost_;
    const double sum = value_ + corrected;
    lost_ = (sum - value_) - corrected;
    value_ = sum;
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  double value_ = 0, lost_ = 0;
};

void remove_mean(std::vector<Vec2>& velocities) {
  Sum x, y;
  for (const Vec2 v : velocities) x.add(v.x), y.add(v.y);
  const auto count = static_cast<double>(velocities.size());
  const Vec2 mean{x.value() / count, y.value() / count};
  for (Vec2& v : velocities) v = v - mean;
}

void scale_to(double velocity_scale, std::vector<Vec2>& velocities) {
  Sum squares;
  for (const Vec2 v : velocities) squares.add(dot(v, v));
  const double factor = velocity_scale * std::sqrt(2 * static_cast<double>(velocities.size()) / squares.value());
  for (Vec2& v : velocities) v = factor * v;
}

}  // namespace

State start_state(const Scene& scene) {
  State state{place_on_lattice(scene), {}};
  state.velocity.reserve(state.position.size());
  for (std::uint64_t disk = 0; disk < state.position.size(); ++disk)
    state.velocity.push_back(gaussian_pair(scene.seed, disk));
  if (state.velocity.size() > 1) remove_mean(state.velocity);
  scale_to(scene.velocity_scale(), state.velocity);
  return state;
}

}  // namespace gpf
