// A campaign: one scene varied along axes, each point with replicas. The file that a user writes, and what it means.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "gpf/scene/scene_file.hpp"

namespace gpf {

/// One varied key of [scene] or [run].
struct CampaignAxis {
  std::string key;
  std::vector<std::string> texts;  ///< values as in a scene file: "2", "[0.1, 0.9]"
  std::vector<double> numbers;     ///< for plots: the number; of a pair its first number
};

/// One combination of values.
struct CampaignPoint {
  std::vector<std::size_t> place;  ///< index of the value along each axis
  std::string label;               ///< "length_over_width = 2, wall_tangential_restitution = 0.6"
  SceneFile scene;
};

struct Campaign {
  std::string title;
  int replicas = 0;       ///< of each point
  int most_replicas = 0;  ///< of a point on a boundary, for --adaptive; `replicas` when the file gives none
  double precision = 0;   ///< wanted of each point's mean flow, for --adaptive: standard error over mean; 0: none
  std::vector<CampaignAxis> axes;
  std::vector<CampaignPoint> points;  ///< all combinations, the last axis fastest
  std::string text;                   ///< the file as read

  /// Points that differ from `point` by one step along one axis.
  [[nodiscard]] std::vector<std::size_t> neighbours(std::size_t point) const;
};

/// Most points, and most values along one axis: beyond, a table is no use to anyone.
inline constexpr std::size_t most_campaign_points = 10000;

/// Reads
///   title = "..."          replicas = 4          most_replicas = 16   precision = 0.01   (both optional)
///   [axes]                 a list of values for each varied key of [scene] or [run]
///   [scene], [run]         as in a scene file, without the varied keys
/// Throws InputError, with file and line, for unknown or missing keys, an axis without values or with one twice, a key
/// that is both varied and fixed, more than most_campaign_points points, and whatever parse_scene refuses (lines
/// counted in the scene of the point, which the message names), two points of the same scene, and a [run] without
/// density_modes.
Campaign parse_campaign(std::string_view text, const std::string& name);
/// parse_campaign of a file. Throws StorageError when it cannot be read.
Campaign load_campaign(const std::filesystem::path& path);

}  // namespace gpf
