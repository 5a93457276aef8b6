#include "verify/toml_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/scene/nearest_word.hpp"

namespace gpf {
namespace {

std::string single_spaced(std::string_view text) {
  std::string result;
  bool gap = false;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      gap = !result.empty();
    } else {
      if (gap) result += ' ';
      gap = false;
      result += c;
    }
  }
  return result;
}

/// Characters that would move the cursor of a terminal, or that pages cannot hold.
bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

}  // namespace

TomlFields::TomlFields(const TomlTable& table, TomlPosition position, std::string_view where, std::string_view file,
                       std::span<const std::string_view> known)
    : table_(table), position_(position), where_(where), file_(file) {
  if (known.empty()) return;
  for (const TomlEntry& entry : table)
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      throw error_at(file_, entry.position, fmt::format("unknown key {}{}", gpf::quoted(entry.key), in_where()),
                     fmt::format("known are: {}", fmt::join(known, ", ")),
                     fmt::format("did you mean '{}'?", nearest_word(entry.key, known)));
}

std::string TomlFields::in_where() const { return where_.empty() ? "" : fmt::format(" in {}", where_); }

const TomlEntry* TomlFields::find(std::string_view key) const {
  const auto found =
      std::find_if(table_.begin(), table_.end(), [key](const TomlEntry& entry) { return entry.key == key; });
  return found == table_.end() ? nullptr : &*found;
}

const TomlEntry& TomlFields::required(std::string_view key) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr)
    throw error(key, fmt::format("{} is missing{}", key, in_where()), "it has no default",
                fmt::format("add {} = ... (reference/claims/README.md shows how)", key));
  return *entry;
}

InputError TomlFields::error(std::string_view key, std::string_view problem, std::string why,
                             std::string remedy) const {
  const TomlEntry* entry = find(key);
  return error_at(file_, entry == nullptr ? position_ : entry->position, problem, std::move(why), std::move(remedy));
}

InputError TomlFields::wrong_type(const TomlEntry& entry, std::string_view wanted) const {
  return error_at(file_, entry.position, fmt::format("{} is {}", entry.key, kind_of(entry.value)),
                  fmt::format("it must be {}", wanted), "correct its value");
}

template <class T>
const T& TomlFields::value(std::string_view key, std::string_view wanted) const {
  const TomlEntry& entry = required(key);
  const T* found = std::get_if<T>(&entry.value.data);
  if (found == nullptr) throw wrong_type(entry, wanted);
  return *found;
}

std::string TomlFields::text(std::string_view key) const {
  std::string result = single_spaced(value<std::string>(key, "a string"));
  if (result.empty()) throw error(key, fmt::format("{} is empty", key), "it tells a reader something", "fill it in");
  if (has_control_character(result))
    throw error(key, fmt::format("{} holds a control character", key), "it is shown on terminals and pages",
                "remove it");
  return result;
}

double TomlFields::number(std::string_view key) const {
  const TomlEntry& entry = required(key);
  if (const auto* integer = std::get_if<std::int64_t>(&entry.value.data)) return static_cast<double>(*integer);
  const double real = value<double>(key, "a number");
  if (!std::isfinite(real))
    throw error(key, fmt::format("{} = {} is not a finite number", key, real), "nothing can be computed with it",
                "write a finite number");
  return real;
}

std::int64_t TomlFields::integer(std::string_view key) const { return value<std::int64_t>(key, "an integer"); }

bool TomlFields::boolean(std::string_view key) const { return value<bool>(key, "true or false"); }

std::vector<std::string> TomlFields::texts(std::string_view key) const {
  const auto& array = value<TomlArray>(key, "an array of strings");
  std::vector<std::string> result;
  for (const TomlValue& element : array) {
    const auto* text = std::get_if<std::string>(&element.data);
    if (text == nullptr)
      throw error_at(file_, element.position, fmt::format("{} holds {}", key, kind_of(element)),
                     "it must be an array of strings", "write each in quotation marks");
    std::string word = single_spaced(*text);
    if (word.empty())
      throw error_at(file_, element.position, fmt::format("{} holds an empty string", key), "it names nothing",
                     "fill it in or leave it out");
    if (has_control_character(word))
      throw error_at(file_, element.position, fmt::format("{} holds a control character", key),
                     "it is shown on terminals and pages", "remove it");
    if (std::find(result.begin(), result.end(), word) != result.end())
      throw error_at(file_, element.position, fmt::format("{} holds {} twice", key, gpf::quoted(word)),
                     "each is listed once", "remove one");
    result.push_back(std::move(word));
  }
  if (result.empty()) throw error(key, fmt::format("{} is empty", key), "it must hold at least one string", "add one");
  return result;
}

TomlFields TomlFields::table(std::string_view key, std::string_view where,
                             std::span<const std::string_view> known) const {
  const auto& entries = value<TomlTable>(key, "a table");
  return {entries, required(key).position, where, file_, known};
}

std::vector<TomlFields> TomlFields::tables(std::string_view key, std::string_view where,
                                           std::span<const std::string_view> known) const {
  std::vector<TomlFields> result;
  if (!has(key)) return result;
  for (const TomlValue& element : value<TomlArray>(key, "an array of tables")) {
    const auto* entries = std::get_if<TomlTable>(&element.data);
    if (entries == nullptr)
      throw error_at(file_, element.position, fmt::format("{} holds {}", key, kind_of(element)),
                     "it must be an array of tables", fmt::format("write each as [[{}]]", key));
    result.emplace_back(*entries, element.position, where, file_, known);
  }
  return result;
}

}  // namespace gpf
