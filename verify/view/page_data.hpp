// What the scripts of a page read: one JSON object.
#pragma once

#include <cstdint>
#include <string>

#include "verify/view/packed_frames.hpp"
#include "verify/view/view_source.hpp"

namespace gpf {

/// JSON that may stand between <script> tags: no `<` in it, whatever the record's texts hold.
std::string page_data(const ViewSource& source, const PackedFrames& frames, double interval, std::uint64_t frames_hash);

}  // namespace gpf
