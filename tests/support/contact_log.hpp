// An observer that writes down which contacts happened, and when.
#pragma once

#include <cstdint>
#include <vector>

#include "gpf/event/observer.hpp"

namespace gpf::test {

/// a < b for a pair; b is -1 for the lower and -2 for the upper wall.
struct Contact {
  double time;
  std::int32_t a, b;
  friend bool operator==(const Contact&, const Contact&) = default;
};

struct ContactLog {
  std::vector<Contact> contacts;

  void on_pair(const PairContact& c) { contacts.push_back({c.time, c.first, c.second}); }
  void on_wall(const WallContact& c) { contacts.push_back({c.time, c.disk, c.wall == lower ? -1 : -2}); }
};

}  // namespace gpf::test
