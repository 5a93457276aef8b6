// Lengths of UTF-8 texts as a reader counts them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace gpf {

/// Number of code points; right for texts without combining or wide characters.
constexpr std::size_t character_count(std::string_view text) {
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts));
}

}  // namespace gpf
