// What inelastic collapse looks like to those who watch an engine.
#pragma once

#include <cstddef>
#include <vector>

#include "gpf/event/observer.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// Counts the pair contacts of a disk that follow its last one at the same time, to the last bit.
class ContactsAtOnce {
 public:
  explicit ContactsAtOnce(const Scene& scene) : last_(static_cast<std::size_t>(scene.particles), -1.0) {}
  void on_pair(const PairContact& c) {
    double &a = last_[static_cast<std::size_t>(c.first)], &b = last_[static_cast<std::size_t>(c.second)];
    if (c.time == a || c.time == b) ++count_;
    a = b = c.time;
  }
  void on_wall(const WallContact& c) { last_[static_cast<std::size_t>(c.disk)] = c.time; }
  [[nodiscard]] double count() const { return count_; }

 private:
  std::vector<double> last_;
  double count_ = 0;
};

}  // namespace gpf
