// UTF-8 texts: their length as a reader counts it, and what of them XML can hold.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace gpf {

/// Number of code points; right for texts without combining or wide characters.
constexpr std::size_t character_count(std::string_view text) {
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts));
}

/// A text in characters that XML has: spaces for control characters, U+FFFD for U+FFFE, U+FFFF and bytes that are not
/// UTF-8. Marks (<, &, ]]>) stay.
std::string xml_characters(const std::string& text);

}  // namespace gpf
