// The keys of a scene file: one table, from which the parser checks and the help is written.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gpf {

enum class KeyKind { integer, real, word, wall_pair, ascending };

struct SceneKey {
  std::string_view table, name;
  KeyKind kind = KeyKind::real;
  std::span<const std::string_view> words{};  ///< allowed values of a word
  double least = 0, most = 0;                 ///< of a number
  bool least_excluded = false;
  std::string_view range_reason{};
  std::string_view meaning{};
  std::string_view otherwise{};  ///< what holds when the key is left out

  /// Allowed values, for messages: "[0, 1]", "1 ... 1000", "\"square\" | \"triangular\"".
  [[nodiscard]] std::string range() const;
};

/// Coordinates are kept to about 2e-15 of the longest side; at 1e4 d a contact is then still sharp to 2e-11 d.
inline constexpr double longest_side = 1e4;
/// The neighbourhood of a cell is three cells, each wider than d, and must not meet itself round the period.
inline constexpr double shortest_period = 4;
/// The centres' room W - d is d/100 here; in less, a disk does little but hit walls.
inline constexpr double narrowest_channel = 1.01;
/// pi/(2 sqrt 3): the triangular lattice at contact.
inline constexpr double close_packing = 0.90689968211710894;

/// All keys, [scene] before [run], in the order in which the help shows them.
[[nodiscard]] std::span<const SceneKey> scene_keys();

/// Keys, ranges, meanings and defaults as plain text, for `gpf run --help` and the documentation.
[[nodiscard]] std::string scene_key_help();

}  // namespace gpf
