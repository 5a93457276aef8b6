// Where two trajectories of one scene part: the first event that differs, and by how much.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/audit/trace.hpp"

namespace gpf {

/// One number of an event on both sides.
struct NumberDifference {
  std::string name;  ///< "time", "v_x of disk 12"
  double before = 0, after = 0;
  double ulps = 0;  ///< in units of the last place of the scale: the epoch's length, or the event's largest velocity
  double relative = 0;  ///< difference over `before`; infinite where that is 0
};

struct EventDifference {
  enum class Kind {
    numbers,   ///< the same pair at the same place in the order, with other numbers
    exchange,  ///< the same two events in the other order
    partners,  ///< another event: other partners, or one side has no more
    state      ///< the same contacts in every number, but other positions or velocities at the end of the epoch
  };
  Kind kind = Kind::numbers;
  bool other_start = false;     ///< the states differed from the start
  std::int64_t epoch = 0;       ///< the mark that it belongs to
  std::size_t event = 0;        ///< within the epoch, from 1
  TracedContact before, after;  ///< the event on each side
  std::vector<NumberDifference> numbers;
  double largest_ulps = 0;  ///< over `numbers`; infinite where there is no counterpart, and for Kind::state
};

/// Number of the first mark that differs; nothing when all that both sides have agree.
std::optional<std::size_t> first_differing(std::span<const EpochMark> before, std::span<const EpochMark> after);

/// The first event that differs between the contacts of one epoch, sorted by time and partners; nothing when all agree.
/// `epoch_length` is the scale of times.
std::optional<EventDifference> first_differing(std::vector<TracedContact> before, std::vector<TracedContact> after,
                                               double epoch_length);

/// "disks 3 and 17", "disk 3 and the lower wall".
std::string partners_text(const TracedContact& contact);

}  // namespace gpf
