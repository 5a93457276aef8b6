// What the methods other than the engine tell those who watch.
#pragma once

#include "gpf/scene/contact.hpp"

namespace gpf {

/// Is shown every contact. Of a contact that lasts (soft disks) each time step is shown as one, with the impulse of that
/// step: sums of impulses and losses are right, numbers of contacts are not.
struct ContactWatcher {
  virtual ~ContactWatcher() = default;
  virtual void on_pair(const PairContact& contact) = 0;
  virtual void on_wall(const WallContact& contact) = 0;
};

}  // namespace gpf
