// The values that a scene file gives, each checked on its own against the table of keys.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/scene/scene_keys.hpp"
#include "gpf/scene/toml_reader.hpp"

namespace gpf {

class KeyValues {
 public:
  /// Reads TOML `text`; `name` stands for it in messages. Throws InputError, with name:line:column, on text that is not
  /// TOML, an unknown table or key, a wrong type, a number that is not finite or out of the key's range, a missing
  /// table; of several mistakes in tables and keys with all, a line each.
  KeyValues(std::string_view text, std::string_view name);

  [[nodiscard]] bool has(std::string_view key) const { return given_.contains(key); }

  /// The value of a key of that type; nothing if it is not given.
  [[nodiscard]] std::optional<double> real(std::string_view key) const { return value<double>(key); }
  [[nodiscard]] std::optional<std::int64_t> integer(std::string_view key) const { return value<std::int64_t>(key); }
  [[nodiscard]] std::optional<std::string> word(std::string_view key) const { return value<std::string>(key); }
  [[nodiscard]] std::optional<std::array<double, 2>> wall_pair(std::string_view key) const {
    return value<std::array<double, 2>>(key);
  }
  [[nodiscard]] std::optional<std::vector<double>> ascending(std::string_view key) const {
    return value<std::vector<double>>(key);
  }

  /// An error placed at the first of `keys` that is given, else at the table of the first.
  [[nodiscard]] InputError error(std::initializer_list<std::string_view> keys, std::string_view problem,
                                 std::string why, std::string remedy) const;
  /// The error of a key that has no default and is not given.
  [[nodiscard]] InputError missing(std::string_view key, std::string example) const;

 private:
  using Value = std::variant<std::int64_t, double, std::string, std::array<double, 2>, std::vector<double>>;
  struct Given {
    TomlPosition position;
    Value value;
  };

  template <class T>
  [[nodiscard]] std::optional<T> value(std::string_view key) const {
    const auto found = given_.find(key);
    return found == given_.end() ? std::nullopt : std::optional<T>(std::get<T>(found->second.value));
  }

  [[nodiscard]] const TomlTable& table_of(const TomlEntry& entry);
  void read_key(std::string_view table, const TomlEntry& entry);
  [[nodiscard]] Value checked(const SceneKey& key, const TomlValue& value) const;
  [[nodiscard]] std::vector<double> checked_ascending(const SceneKey& key, const TomlValue& value) const;
  [[nodiscard]] double number(const SceneKey& key, const TomlValue& value) const;
  [[nodiscard]] InputError wrong_type(const SceneKey& key, const TomlValue& value, std::string remedy) const;
  void check_range(const SceneKey& key, TomlPosition position, double number, std::string_view written) const;

  std::string name_;
  std::map<std::string, TomlPosition, std::less<>> tables_;
  std::map<std::string, Given, std::less<>> given_;
};

}  // namespace gpf
