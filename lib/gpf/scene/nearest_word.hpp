// The known word that an unknown one was probably meant to be.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace gpf {

/// Levenshtein distance: the least number of characters inserted, deleted or replaced that turns a into b.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word at the least edit distance; the first of equally near ones. `words` must not be empty.
[[nodiscard]] std::string_view nearest_word(std::string_view word, std::span<const std::string_view> words);

}  // namespace gpf
