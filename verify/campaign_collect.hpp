// What the finished runs of a campaign say: the structure at each point, and how sure that is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "gpf/stats/estimate.hpp"
#include "gpf/stats/proportion.hpp"
#include "verify/campaign_manifest.hpp"
#include "verify/estimators/density_structure.hpp"

namespace gpf {

/// All of so many replicas alike: 0.05^(1/5) = .55 of all replicas at least, at 95 %; of four it is .47.
inline constexpr int fewest_decisive_replicas = 5;

struct PointResult {
  std::vector<std::optional<Structure>> labels;  ///< one for each finished replica
  std::optional<Structure> structure;            ///< of most replicas; nothing: between the classes, a tie, or no run
  Share share;                                   ///< of the replicas that have it
  Interval confidence{0, 1};                     ///< of that share among all replicas, 95 % on either side
  bool bistable = false;                         ///< two classes are each more than rare
  std::vector<double> band_shift, mean_flow;     ///< one for each finished replica

  /// More than half of all replicas are of the structure, at 95 %.
  [[nodiscard]] bool decided() const { return structure.has_value() && confidence.lo >= 0.5; }
  /// "wave", "bistable", "between the classes", "no run"; with a question mark where it is not decided.
  [[nodiscard]] std::string name() const;
};

/// What the labels of a point's runs say; without band_shift and mean_flow.
PointResult result_of(std::vector<std::optional<Structure>> labels);

/// One for each point of the campaign.
std::vector<PointResult> collect(const Campaign& campaign, const Manifest& manifest, const RecordStore& store);

/// Replicas that each point should have so that the boundaries between structures are known: twice as many as are done,
/// up to most_replicas, at points that are not decided, that have a neighbour of another structure or whose mean flow
/// is not as precise as the campaign wants; as many as are done elsewhere.
std::vector<int> refined_replicas(const Campaign& campaign, const std::vector<PointResult>& results);

/// Anew: a picture of the last state of each point's first finished replica, into `folder`/<point>.svg, and a page that
/// shows them under what each was called. Returns the page; empty when no run is done. Throws StorageError.
std::string draw_snapshots(const Campaign& campaign, const Manifest& manifest, const RecordStore& store,
                           const std::filesystem::path& folder);

/// Markdown: what the axes are, one row a point.
std::string phase_table(const Campaign& campaign, const std::vector<PointResult>& results);
/// The same as CSV, one column for each axis.
std::string phase_csv(const Campaign& campaign, const std::vector<PointResult>& results);
/// The structures in the plane of the first two axes (of one axis: over it); an axis whose numbers
/// do not tell its values apart is drawn by their order. Throws InputError for more than two axes.
Plot phase_diagram(const Campaign& campaign, const std::vector<PointResult>& results);

}  // namespace gpf
