#include "verify/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/record.hpp"
#include "gpf/scene/nearest_word.hpp"
#include "verify/toml_fields.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 7> campaign_keys{"title", "replicas", "most_replicas", "precision", "axes",
                                                        "scene", "run"};
constexpr std::int64_t most_replicas_of_a_point = 1000;

/// A value of `key` as a scene file has it.
std::string text_of(const TomlFields& table, const std::string& key, const TomlValue& value) {
  struct Text {
    const TomlFields& table;
    const std::string& key;
    [[nodiscard]] InputError refused(const std::string& problem, const char* why) const {
      return table.error(key, problem, why, "see gpf run --help for the keys");
    }
    [[nodiscard]] InputError no_value() const {
      return refused("a date or a table as a value of a scene", "no key of a scene has one");
    }
    std::string operator()(const TomlDate&) const { throw no_value(); }
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t n) const { return std::to_string(n); }
    std::string operator()(double x) const {
      const std::string digits = fmt::format("{}", x);
      return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
    }
    std::string operator()(const std::string& s) const {
      if (s.find_first_of("\"\\") != std::string::npos ||
          std::any_of(s.begin(), s.end(), [](unsigned char c) { return c < 0x20; }))
        throw refused(gpf::quoted(s) + " is no word of a scene", "it has quotation marks or control characters");
      return '"' + s + '"';
    }
    std::string operator()(const TomlArray& values) const {
      std::vector<std::string> texts;
      for (const TomlValue& v : values) texts.push_back(text_of(table, key, v));
      return fmt::format("[{}]", fmt::join(texts, ", "));
    }
    std::string operator()(const TomlTable&) const { throw no_value(); }
  };
  return std::visit(Text{table, key}, value.data);
}

double number_of(const TomlValue& value) {
  if (const auto* n = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*n);
  if (const auto* x = std::get_if<double>(&value.data)) return *x;
  if (const auto* list = std::get_if<TomlArray>(&value.data); list != nullptr && !list->empty())
    return number_of(list->front());
  return 0;  // a word
}

/// "scene" or "run".
std::string_view table_of(const std::string& key, const TomlFields& axes) {
  std::vector<std::string_view> names;
  for (const SceneKey& known : scene_keys()) {
    if (known.name == key) return known.table;
    names.push_back(known.name);
  }
  throw axes.error(key, fmt::format("unknown key '{}' in [axes]", key), "axes are keys of [scene] and [run]",
                   fmt::format("did you mean '{}'?", nearest_word(key, names)));
}

std::vector<CampaignAxis> axes_of(const TomlFields& table) {
  std::vector<CampaignAxis> axes;
  for (const TomlEntry& entry : table.entries()) {
    static_cast<void>(table_of(entry.key, table));
    if (entry.key == "seed")
      throw table.error("seed", "seed is an axis", "replicas have seeds of their own", "raise replicas instead");
    const auto* values = std::get_if<TomlArray>(&entry.value.data);
    if (values == nullptr || values->empty())
      throw table.error(entry.key, fmt::format("axis '{}' is not a list of values", entry.key),
                        "an axis is what is varied", fmt::format("write {} = [ ... ]", entry.key));
    CampaignAxis axis{entry.key, {}, {}};
    for (const TomlValue& value : *values) {
      axis.texts.push_back(text_of(table, entry.key, value));
      axis.numbers.push_back(number_of(value));
    }
    if (std::set(axis.texts.begin(), axis.texts.end()).size() != axis.texts.size())
      throw table.error(entry.key, fmt::format("axis '{}' has a value twice", entry.key), "it would be run twice",
                        "remove one");
    axes.push_back(std::move(axis));
  }
  if (axes.empty())
    throw table.error("", "[axes] is empty", "a campaign varies something", "add length_over_width = [1, 2, 4]");
  return axes;
}

/// The scene file of a point.
std::string scene_text(const TomlFields& file, const TomlFields& axes_table, const Campaign& campaign,
                       const std::vector<std::size_t>& place) {
  std::string text;
  for (const std::string_view table : {"scene", "run"}) {
    text += fmt::format("[{}]\n", table);
    for (std::size_t a = 0; a < campaign.axes.size(); ++a)
      if (table_of(campaign.axes[a].key, axes_table) == table)
        text += fmt::format("{} = {}\n", campaign.axes[a].key, campaign.axes[a].texts[place[a]]);
    const TomlFields fixed = file.table(table, table, {});
    for (const TomlEntry& entry : fixed.entries()) {
      if (axes_table.has(entry.key))
        throw fixed.error(entry.key, fmt::format("'{}' is both fixed and an axis", entry.key),
                          "it has one value at each point", "remove one of the two");
      text += fmt::format("{} = {}\n", entry.key, text_of(fixed, entry.key, entry.value));
    }
  }
  return text;
}

int replicas_in(const TomlFields& file, std::string_view key, std::int64_t least) {
  const std::int64_t value = file.integer(key);
  if (value < least || value > most_replicas_of_a_point)
    throw file.error(key, fmt::format("{} = {}", key, value),
                     fmt::format("it lies within {} and {}", least, most_replicas_of_a_point),
                     "choose a number between");
  return static_cast<int>(value);
}

}  // namespace

std::vector<std::size_t> Campaign::neighbours(std::size_t point) const {
  std::vector<std::size_t> result;
  std::size_t stride = 1;
  for (std::size_t a = axes.size(); a-- > 0;) {
    const std::size_t at = points[point].place[a];
    if (at > 0) result.push_back(point - stride);
    if (at + 1 < axes[a].texts.size()) result.push_back(point + stride);
    stride *= axes[a].texts.size();
  }
  return result;
}

Campaign parse_campaign(std::string_view text, const std::string& name) {
  const TomlTable tree = read_toml(text, name);
  const TomlFields file(tree, {}, "", name, campaign_keys);
  Campaign campaign;
  campaign.text = text;
  campaign.title = file.text("title");
  campaign.replicas = replicas_in(file, "replicas", 1);
  campaign.most_replicas =
      file.has("most_replicas") ? replicas_in(file, "most_replicas", campaign.replicas) : campaign.replicas;
  if (file.has("precision")) campaign.precision = file.number("precision");
  if (file.has("precision") && !(campaign.precision > 0 && campaign.precision < 1))
    throw file.error("precision", fmt::format("precision = {}", campaign.precision),
                     "it is the relative standard error wanted of the mean flow", "write 0.01 for one per cent");
  const TomlFields axes = file.table("axes", "[axes]", {});
  campaign.axes = axes_of(axes);
  std::size_t points = 1;
  for (const CampaignAxis& axis : campaign.axes) {
    points *= axis.texts.size();
    if (points > most_campaign_points)
      throw axes.error(axis.key, fmt::format("the axes have more than {} combinations", most_campaign_points),
                       "a point is at least one run", "shorten an axis, or make several campaigns");
  }
  std::map<std::string, std::string> scenes;
  for (std::size_t p = 0; p < points; ++p) {
    CampaignPoint point;
    point.place.resize(campaign.axes.size());
    std::size_t rest = p;
    for (std::size_t a = campaign.axes.size(); a-- > 0;) {
      point.place[a] = rest % campaign.axes[a].texts.size();
      rest /= campaign.axes[a].texts.size();
    }
    for (std::size_t a = 0; a < campaign.axes.size(); ++a)
      point.label +=
          fmt::format("{}{} = {}", a == 0 ? "" : ", ", campaign.axes[a].key, campaign.axes[a].texts[point.place[a]]);
    point.scene = parse_scene(scene_text(file, axes, campaign, point.place),
                              fmt::format("{}, the scene of {}", name, point.label));
    if (point.scene.run.density_modes == 0)
      throw file.error("run", "the runs measure no density modes", "structures are told by them",
                       "add density_modes = 8 to [run]");
    const std::string canonical = canonical_text(point.scene.scene, point.scene.run);
    if (const auto [same, is_new] = scenes.emplace(canonical, point.label); !is_new)
      throw axes.error(campaign.axes.front().key,
                       fmt::format("'{}' and '{}' are the same scene", same->second, point.label),
                       "it would be one run under two names", "remove one of the values");
    campaign.points.push_back(std::move(point));
  }
  return campaign;
}

Campaign load_campaign(const std::filesystem::path& path) { return parse_campaign(read_text(path), path.string()); }

}  // namespace gpf
