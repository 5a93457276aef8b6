// What a page says about where its numbers come from.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verify/view/view_source.hpp"

namespace gpf {

/// A heading and rows of a name and a text.
struct PageTable {
  std::string heading;
  std::vector<std::pair<std::string, std::string>> rows;
};

/// The scene and the run; what the record says about itself and its program, if there is one; this program.
/// frames_hash: trace hash of what happens between the first and the last frame.
std::vector<PageTable> page_tables(const ViewSource& source, std::uint64_t frames_hash);

}  // namespace gpf
