// What only the engine needs to know of a disk.
#pragma once

#include <cstdint>

#include "gpf/event/disk.hpp"
#include "gpf/event/place.hpp"

namespace gpf {

/// Queues keep it beside the time for which the disk is scheduled: it is read when that time has come, and one line of
/// memory then holds both.
struct Plan {
  double last_contact = -never;
  Index column = 0;
  std::uint16_t row = 0;
  Side side = Side::left;  ///< of its cell, through which it leaves when no contact comes before

  [[nodiscard]] Place place() const { return {column, row}; }
  void move_to(const Place& place) {
    column = place.column;
    row = static_cast<std::uint16_t>(place.row);
  }
};
static_assert(sizeof(Plan) == 16);

}  // namespace gpf
