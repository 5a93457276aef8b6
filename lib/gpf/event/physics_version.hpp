// Which physics a record was made with.
#pragma once

namespace gpf {

/// Goes up with every change that moves a bit of any trajectory or changes the meaning of a tally; records made with
/// another version are not used.
inline constexpr int physics_version = 1;

}  // namespace gpf
