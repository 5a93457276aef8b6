// TOML text as a tree of plain values with their positions: the one place where TOML is parsed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gpf/base/error.hpp"

namespace gpf {

/// Both from one; columns count characters, not bytes.
struct TomlPosition {
  std::uint32_t line = 1, column = 1;
};

/// A date or a time: valid TOML that nothing in gpf asks for, so its value is not kept.
struct TomlDate {};

struct TomlEntry;
struct TomlValue;
using TomlArray = std::vector<TomlValue>;
using TomlTable = std::vector<TomlEntry>;  ///< in the order of the text

struct TomlValue {
  TomlPosition position;
  std::variant<TomlDate, bool, std::int64_t, double, std::string, TomlArray, TomlTable> data;
};

struct TomlEntry {
  std::string key;
  TomlPosition position;  ///< of the key
  TomlValue value;
};

/// Longest text that read_toml takes, in bytes. The parser recurses once per dot of a key such as a.a.a.a; this
/// bounds the depth to 8192, which fits an 8 MB stack even with the sanitizers' frames.
inline constexpr std::size_t longest_toml_text = 16384;

/// Parses `text`; `name` stands for it in messages. Throws InputError, with name:line:column, when the text is not
/// TOML, is longer than longest_toml_text, or nests values deeper than 16.
[[nodiscard]] TomlTable read_toml(std::string_view text, std::string_view name);

/// What a value is, for messages: "an integer", "a string", ...
[[nodiscard]] std::string_view kind_of(const TomlValue& value);

/// `text` between quotation marks, shortened to 40 characters and with control characters replaced by '?'.
[[nodiscard]] std::string quoted(std::string_view text);

/// An InputError whose problem begins with "name:line:column: ".
[[nodiscard]] InputError error_at(std::string_view name, TomlPosition position, std::string_view problem,
                                  std::string why, std::string remedy);

}  // namespace gpf
