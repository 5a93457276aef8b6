// What the engine tells those who watch.
#pragma once

#include "gpf/scene/contact.hpp"

namespace gpf {

/// Watches nothing; every observer has these two members.
struct NoObserver {
  void on_pair(const PairContact&) {}
  void on_wall(const WallContact&) {}
};

}  // namespace gpf
