// A TOML table with known keys, read strictly: each value by its type, each error with file and line.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/scene/toml_reader.hpp"

namespace gpf {

class TomlFields {
 public:
  /// `where` names the table in messages, for example "[scenes]"; empty for the whole file. `file` stands for the
  /// file; both must outlive this, as must `table`. Throws InputError, with the nearest known key, for one that is not
  /// in `known`; no check when `known` is empty.
  TomlFields(const TomlTable& table, TomlPosition position, std::string_view where, std::string_view file,
             std::span<const std::string_view> known);

  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
  [[nodiscard]] const TomlTable& entries() const { return table_; }

  // The value of a key. Each throws InputError when the key is missing or its value is of another type.

  /// Not empty; white space at the ends is taken off and every other run of it becomes one space.
  [[nodiscard]] std::string text(std::string_view key) const;
  /// Finite; an integer will do.
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] std::int64_t integer(std::string_view key) const;
  [[nodiscard]] bool boolean(std::string_view key) const;
  /// Neither empty nor with a text twice.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  [[nodiscard]] TomlFields table(std::string_view key, std::string_view where,
                                 std::span<const std::string_view> known) const;
  /// The tables of [[key]]; none when the key is missing.
  [[nodiscard]] std::vector<TomlFields> tables(std::string_view key, std::string_view where,
                                               std::span<const std::string_view> known) const;

  /// An error at a key, or at the table when it is not given.
  [[nodiscard]] InputError error(std::string_view key, std::string_view problem, std::string why,
                                 std::string remedy) const;

 private:
  [[nodiscard]] const TomlEntry* find(std::string_view key) const;
  [[nodiscard]] const TomlEntry& required(std::string_view key) const;
  [[nodiscard]] InputError wrong_type(const TomlEntry& entry, std::string_view wanted) const;
  template <class T>
  [[nodiscard]] const T& value(std::string_view key, std::string_view wanted) const;
  [[nodiscard]] std::string in_where() const;

  const TomlTable& table_;
  TomlPosition position_;
  std::string_view where_, file_;
};

}  // namespace gpf
