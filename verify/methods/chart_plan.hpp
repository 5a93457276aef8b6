// What the chart of speed against accuracy runs: scenes, and methods on them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/flow/method_setting.hpp"
#include "gpf/scene/scene_file.hpp"

namespace gpf {

/// A method, and what of the scene is varied with it.
struct ChartSeries {
  MethodSetting setting;
  std::vector<std::string> scenes;
  double length = 1;         ///< of the measured time, in that of the scene
  double tc = 1;             ///< of tc_time
  double particles = 1;      ///< of N and L at constant nu and W
  double steady_window = 0;  ///< not 0: begins with the reference's last state and measures for this long

  /// The setting, and the factors that are not 1: the series' name in tables.
  [[nodiscard]] std::string text() const;
};

struct ChartPlan {
  std::string title;
  int replicas = 4, reference_replicas = 8;
  std::vector<std::string> chart;      ///< scenes that are drawn
  std::vector<std::string> evidence;   ///< more scenes, which only the advice reads
  std::vector<std::string> held_back;  ///< scenes on which the advice is tried; no series may name them
  std::vector<ChartSeries> series;

  [[nodiscard]] std::vector<std::string> scenes() const;  ///< chart and evidence
};

/// Reads reference/methods.toml:
///   title, replicas, reference_replicas; [scenes] chart, evidence, held_back; [[series]] method, of = "chart",
///   "evidence" or "both", or scenes = [...]; any of lengths, tc, particles (lists of factors; each makes a series),
///   steady_window.
/// Throws InputError with file and line.
ChartPlan parse_chart_plan(std::string_view text, const std::string& name);
ChartPlan load_chart_plan(const std::filesystem::path& path);

/// The scene as a series varies it.
SceneFile varied(const SceneFile& file, const ChartSeries& series);

}  // namespace gpf
