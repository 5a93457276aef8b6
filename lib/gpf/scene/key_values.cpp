#include "gpf/scene/key_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "gpf/scene/nearest_word.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 2> tables{"scene", "run"};

const SceneKey* find_key(std::string_view name) {
  const auto keys = scene_keys();
  const auto found = std::find_if(keys.begin(), keys.end(), [name](const SceneKey& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

std::string_view nearest_key(std::string_view table, std::string_view name) {
  std::vector<std::string_view> names;
  for (const SceneKey& key : scene_keys())
    if (key.table == table) names.push_back(key.name);
  return nearest_word(name, names);
}

std::string missing_table_remedy(std::string_view table) {
  return table == "scene" ? "add [scene] with geometry = \"channel\" and the other keys (gpf run --help lists them)"
                          : "add [run] with collisions_per_particle = 1000, or with a duration";
}

/// The first, with the others below it, a line each.
InputError together(const std::vector<InputError>& mistakes) {
  std::string remedy = mistakes.front().remedy();
  for (std::size_t k = 1; k < mistakes.size(); ++k) remedy += fmt::format("\n{}", mistakes[k].what());
  return {mistakes.front().problem(), mistakes.front().why(), remedy};
}

}  // namespace

KeyValues::KeyValues(std::string_view text, std::string_view name) : name_(name) {
  std::vector<InputError> mistakes;
  const auto note = [&mistakes](const auto& read) {
    try {
      read();
    } catch (const InputError& mistake) {
      mistakes.push_back(mistake);
    }
  };
  for (const TomlEntry& entry : read_toml(text, name))
    note([&] {
      for (const TomlEntry& given : table_of(entry)) note([&] { read_key(entry.key, given); });
    });
  if (!mistakes.empty()) throw together(mistakes);
  for (const std::string_view table : tables)
    if (!tables_.contains(table))
      throw error_at(name_, {}, fmt::format("the table [{}] is missing", table),
                     table == "scene" ? "it says what is simulated" : "it says how long the scene is measured",
                     missing_table_remedy(table));
}

const TomlTable& KeyValues::table_of(const TomlEntry& entry) {
  const bool known = std::find(tables.begin(), tables.end(), entry.key) != tables.end();
  if (!known) {
    const SceneKey* key = find_key(entry.key);
    throw error_at(name_, entry.position, fmt::format("unknown table or key {}", quoted(entry.key)),
                   "a scene file holds the tables [scene] and [run]",
                   key != nullptr ? fmt::format("move it below [{}]", key->table)
                                  : fmt::format("did you mean [{}]?", nearest_word(entry.key, tables)));
  }
  tables_.emplace(entry.key, entry.position);
  const auto* table = std::get_if<TomlTable>(&entry.value.data);
  if (table == nullptr)
    throw error_at(name_, entry.position, fmt::format("'{}' is {}", entry.key, kind_of(entry.value)),
                   "it must be a table of keys", fmt::format("write [{}] on a line of its own", entry.key));
  return *table;
}

void KeyValues::read_key(std::string_view table, const TomlEntry& entry) {
  const SceneKey* key = find_key(entry.key);
  if (key == nullptr || key->table != table)
    throw error_at(name_, entry.position, fmt::format("unknown key {} in [{}]", quoted(entry.key), table),
                   key != nullptr ? fmt::format("it belongs to [{}]", key->table) : "gpf run --help lists all keys",
                   key != nullptr ? fmt::format("move it below [{}]", key->table)
                                  : fmt::format("did you mean '{}'?", nearest_key(table, entry.key)));
  given_.emplace(entry.key, Given{entry.position, checked(*key, entry.value)});
}

KeyValues::Value KeyValues::checked(const SceneKey& key, const TomlValue& value) const {
  switch (key.kind) {
    case KeyKind::word: {
      const auto* word = std::get_if<std::string>(&value.data);
      if (word == nullptr) throw wrong_type(key, value, fmt::format("write {}", key.range()));
      if (std::find(key.words.begin(), key.words.end(), *word) == key.words.end())
        throw error_at(name_, value.position, fmt::format("{} = {} is unknown", key.name, quoted(*word)),
                       fmt::format("it must be {}", key.range()),
                       fmt::format("did you mean \"{}\"?", nearest_word(*word, key.words)));
      return *word;
    }
    case KeyKind::integer: {
      const auto* integer = std::get_if<std::int64_t>(&value.data);
      if (integer == nullptr) throw wrong_type(key, value, "write a whole number without a point");
      check_range(key, value.position, static_cast<double>(*integer), fmt::format("{}", *integer));
      return *integer;
    }
    case KeyKind::wall_pair: {
      const auto* pair = std::get_if<TomlArray>(&value.data);
      if (pair == nullptr) {
        const double both = number(key, value);
        return std::array{both, both};
      }
      if (pair->size() != 2)
        throw error_at(name_, value.position, fmt::format("{} has {} values", key.name, pair->size()),
                       "a channel has two walls", "write one number, or [lower, upper]");
      return std::array{number(key, (*pair)[0]), number(key, (*pair)[1])};
    }
    case KeyKind::ascending:
      return checked_ascending(key, value);
    default:
      return number(key, value);
  }
}

std::vector<double> KeyValues::checked_ascending(const SceneKey& key, const TomlValue& value) const {
  const auto* array = std::get_if<TomlArray>(&value.data);
  if (array == nullptr) return {number(key, value)};
  std::vector<double> numbers;
  for (const TomlValue& entry : *array) {
    numbers.push_back(number(key, entry));
    if (numbers.size() > 1 && numbers.back() <= numbers[numbers.size() - 2])
      throw error_at(name_, entry.position,
                     fmt::format("{} has {} after {}", key.name, numbers.back(), numbers[numbers.size() - 2]),
                     "each is greater than the one before", "put them in order, each once");
  }
  return numbers;
}

double KeyValues::number(const SceneKey& key, const TomlValue& value) const {
  double number = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&value.data))
    number = static_cast<double>(*integer);
  else if (const auto* real = std::get_if<double>(&value.data))
    number = *real;
  else
    throw wrong_type(key, value, "write a number");
  if (!std::isfinite(number))
    throw error_at(name_, value.position, fmt::format("{} = {} is not a finite number", key.name, number),
                   fmt::format("it must lie in {}", key.range()), "write a number in that range");
  check_range(key, value.position, number, fmt::format("{}", number));
  return number + 0.0;  // -0 becomes 0: equal scenes have equal texts
}

InputError KeyValues::wrong_type(const SceneKey& key, const TomlValue& value, std::string remedy) const {
  constexpr std::array<std::string_view, 5> wanted{"an integer", "a number", "a string", "a number or [lower, upper]",
                                                   "a number or an array of them"};
  return error_at(name_, value.position, fmt::format("{} is {}", key.name, kind_of(value)),
                  fmt::format("it must be {}", wanted[static_cast<std::size_t>(key.kind)]), std::move(remedy));
}

void KeyValues::check_range(const SceneKey& key, TomlPosition position, double number, std::string_view written) const {
  if (number > key.least && number <= key.most) return;
  if (number == key.least && !key.least_excluded) return;
  throw error_at(name_, position, fmt::format("{} = {} is out of range", key.name, written),
                 std::string(key.range_reason), fmt::format("give a value in {}", key.range()));
}

InputError KeyValues::error(std::initializer_list<std::string_view> keys, std::string_view problem, std::string why,
                            std::string remedy) const {
  for (const std::string_view key : keys)
    if (const auto found = given_.find(key); found != given_.end())
      return error_at(name_, found->second.position, problem, std::move(why), std::move(remedy));
  const auto table = tables_.find(find_key(*keys.begin())->table);
  return error_at(name_, table->second, problem, std::move(why), std::move(remedy));
}

InputError KeyValues::missing(std::string_view key, std::string example) const {
  const SceneKey& known = *find_key(key);
  return error({key}, fmt::format("{} is missing in [{}]", key, known.table),
               fmt::format("it has no default: {}", known.meaning), fmt::format("add {} = {}", key, example));
}

}  // namespace gpf
