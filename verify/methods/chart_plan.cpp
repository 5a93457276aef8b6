#include "verify/methods/chart_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/record.hpp"
#include "verify/toml_fields.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 5> file_keys{"title", "replicas", "reference_replicas", "scenes", "series"};
constexpr std::array<std::string_view, 3> scene_keys_of_plan{"chart", "evidence", "held_back"};
constexpr std::array<std::string_view, 7> series_keys{"method", "of",        "scenes",       "lengths",
                                                      "tc",     "particles", "steady_window"};

bool contains(const std::vector<std::string>& all, const std::string& name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

/// The factors of a key; {1} when it is not there.
std::vector<double> factors(const TomlFields& table, std::string_view key) {
  if (!table.has(key)) return {1};
  std::vector<double> values;
  for (const TomlEntry& entry : table.entries()) {
    if (entry.key != key) continue;
    if (const auto* list = std::get_if<TomlArray>(&entry.value.data))
      for (const TomlValue& v : *list) {
        if (const auto* x = std::get_if<double>(&v.data)) values.push_back(*x);
        if (const auto* n = std::get_if<std::int64_t>(&v.data)) values.push_back(static_cast<double>(*n));
      }
  }
  if (values.empty() || std::any_of(values.begin(), values.end(), [](double x) { return !(x > 0); }))
    throw table.error(key, fmt::format("{} is not a list of positive factors", key), "each makes a series of its own",
                      fmt::format("write {} = [0.25, 1]", key));
  return values;
}

int count_in(const TomlFields& file, std::string_view key) {
  const std::int64_t value = file.integer(key);
  if (value < 2 || value > 64)
    throw file.error(key, fmt::format("{} = {}", key, value), "errors are taken from the scatter between replicas",
                     "choose 2 to 64");
  return static_cast<int>(value);
}

std::vector<std::string> scenes_of(const TomlFields& table, const ChartPlan& plan) {
  if (table.has("scenes") == table.has("of"))
    throw table.error("", "a series has scenes or of, one of the two", "", "write of = \"chart\"");
  if (!table.has("scenes")) {
    const std::string of = table.text("of");
    if (of == "both") return plan.scenes();
    if (of == "chart") return plan.chart;
    if (of == "evidence") return plan.evidence;
    throw table.error("of", fmt::format("of = '{}'", of), "it is chart, evidence or both", "choose one");
  }
  std::vector<std::string> scenes = table.texts("scenes");
  for (const std::string& scene : scenes)
    if (!contains(plan.chart, scene) && !contains(plan.evidence, scene))
      throw table.error("scenes", fmt::format("'{}' is neither a chart nor an evidence scene", scene),
                        "only those have references, and held-back scenes must not be looked at", "add it to [scenes]");
  return scenes;
}

}  // namespace

std::string ChartSeries::text() const {
  std::string text = text_of(setting);
  if (length != 1) text += fmt::format(" length x{:.3g}", length);
  if (tc != 1) text += fmt::format(" t_c x{:.3g}", tc);
  if (particles != 1) text += fmt::format(" N x{:.3g}", particles);
  if (steady_window > 0) text += fmt::format(" window {:.3g}", steady_window);
  return text;
}

std::vector<std::string> ChartPlan::scenes() const {
  std::vector<std::string> all = chart;
  all.insert(all.end(), evidence.begin(), evidence.end());
  return all;
}

ChartPlan parse_chart_plan(std::string_view text, const std::string& name) {
  const TomlTable tree = read_toml(text, name);
  const TomlFields file(tree, {}, "", name, file_keys);
  ChartPlan plan;
  plan.title = file.text("title");
  plan.replicas = count_in(file, "replicas");
  plan.reference_replicas = count_in(file, "reference_replicas");
  const TomlFields scenes = file.table("scenes", "[scenes]", scene_keys_of_plan);
  plan.chart = scenes.texts("chart");
  plan.evidence = scenes.texts("evidence");
  plan.held_back = scenes.texts("held_back");
  for (const std::string& scene : plan.held_back)
    if (contains(plan.scenes(), scene))
      throw scenes.error("held_back", fmt::format("'{}' is held back and looked at", scene),
                         "the advice is tried on scenes that it has not seen", "remove it from one list");
  for (const TomlFields& table : file.tables("series", "[[series]]", series_keys)) {
    ChartSeries series;
    series.setting = parse_method(table.text("method"));
    series.scenes = scenes_of(table, plan);
    if (table.has("steady_window")) series.steady_window = table.number("steady_window");
    for (const double length : factors(table, "lengths"))
      for (const double tc : factors(table, "tc"))
        for (const double particles : factors(table, "particles")) {
          series.length = length, series.tc = tc, series.particles = particles;
          plan.series.push_back(series);
        }
  }
  return plan;
}

ChartPlan load_chart_plan(const std::filesystem::path& path) {
  return parse_chart_plan(read_text(path), path.string());
}

SceneFile varied(const SceneFile& file, const ChartSeries& series) {
  SceneFile result = file;
  Scene& scene = result.scene;
  Run& run = result.run;
  scene.tc_time *= series.tc;
  const auto particles = static_cast<std::int32_t>(std::lround(scene.particles * series.particles));
  scene.length_over_width *= static_cast<double>(particles) / scene.particles;
  scene.particles = particles;
  run.duration = series.steady_window > 0 ? series.steady_window : run.duration * series.length;
  if (series.steady_window > 0) run.start_up = series.steady_window / 8;
  run.detail = Detail::profiles;
  run.density_modes = 0;
  run.snapshots.clear();
  result.text = canonical_text(scene, run);
  return result;
}

}  // namespace gpf
