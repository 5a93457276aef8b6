#include "verify/campaign_collect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/markdown.hpp"
#include "gpf/io/snapshot.hpp"
#include "verify/csv.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

constexpr double alpha = 0.05;

/// The finished runs of a point, as far as `most` of them.
std::vector<Record> records_of(const CampaignPoint& point, const Manifest& manifest, const RecordStore& store,
                               std::size_t most) {
  std::vector<Record> records;
  const std::string label = point.label + " #";
  for (const ManifestEntry& entry : manifest) {
    if (records.size() == most) break;
    if (!entry.wanted || !entry.label.starts_with(label)) continue;
    if (auto record = store.load(job_of(entry).file)) records.push_back(std::move(*record));
  }
  return records;
}

double over(const std::vector<double>& values) { return values.empty() ? NAN : over_replicas(values).mean; }

std::vector<std::string> row_of(const Campaign& campaign, std::size_t point, const PointResult& result) {
  std::vector<std::string> row;
  for (std::size_t a = 0; a < campaign.axes.size(); ++a)
    row.push_back(campaign.axes[a].texts[campaign.points[point].place[a]]);
  row.push_back(fmt::format("{}", campaign.points[point].scene.scene.particles));
  row.push_back(result.name());
  if (result.labels.empty()) return row;  // the other cells stay empty
  row.push_back(fmt::format("{}/{}", result.share.hits, result.labels.size()));
  row.push_back(fmt::format("{:.2f} to {:.2f}", result.confidence.lo, result.confidence.hi));
  row.push_back(tally_of(result.labels));
  row.push_back(fmt::format("{:.3f}", over(result.band_shift)));
  row.push_back(fmt::format("{:.4f}", over(result.mean_flow)));
  row.push_back(fmt::format("{:.2g}", over_replicas(result.mean_flow).error));
  return row;
}

std::vector<std::string> header_of(const Campaign& campaign) {
  std::vector<std::string> header;
  for (const CampaignAxis& axis : campaign.axes) header.push_back(axis.key);
  for (const char* name : {"N", "structure", "replicas", "share, 95 % on either side", "all", "band shift, W",
                           "mean flow", "its standard error"})
    header.emplace_back(name);
  return header;
}

struct DrawnAxis {
  std::string label;
  std::vector<double> numbers;
};

DrawnAxis drawn(const CampaignAxis& axis) {
  if (std::set(axis.numbers.begin(), axis.numbers.end()).size() == axis.numbers.size()) return {axis.key, axis.numbers};
  DrawnAxis order{fmt::format("{}: {}", axis.key, fmt::join(axis.texts, ", ")), {}};
  for (std::size_t k = 0; k < axis.texts.size(); ++k) order.numbers.push_back(static_cast<double>(k + 1));
  return order;
}

}  // namespace

PointResult result_of(std::vector<std::optional<Structure>> labels) {
  PointResult result;
  result.labels = std::move(labels);
  if (result.labels.empty()) return result;
  std::map<std::optional<Structure>, std::size_t> count;
  for (const auto& label : result.labels) ++count[label];
  const auto most =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto as_many =
      std::count_if(count.begin(), count.end(), [&](const auto& c) { return c.second == most->second; });
  result.structure = as_many == 1 ? most->first : std::nullopt;
  result.share = {most->second, result.labels.size()};
  result.confidence = proportion_interval(result.share, alpha);
  result.bistable = tally_of(result.labels).ends_with("bistable");
  return result;
}

std::string PointResult::name() const {
  if (labels.empty()) return "no run";
  if (bistable) return "bistable";
  return name_of(structure) + (structure && !decided() ? "?" : "");
}

std::vector<PointResult> collect(const Campaign& campaign, const Manifest& manifest, const RecordStore& store) {
  std::vector<PointResult> results;
  for (const CampaignPoint& point : campaign.points) {
    const std::vector<Record> records = records_of(point, manifest, store, manifest.size());
    PointResult result;
    if (!records.empty()) {
      const SceneValues scene(point.label, records);
      std::vector<std::optional<Structure>> labels;
      for (const DensityContrast& contrast : density_contrasts(scene)) labels.push_back(classify(contrast));
      result = result_of(std::move(labels));
      result.band_shift = scene.of("band_shift");
      result.mean_flow = scene.of("mean_flow");
    }
    results.push_back(std::move(result));
  }
  return results;
}

std::string draw_snapshots(const Campaign& campaign, const Manifest& manifest, const RecordStore& store,
                           const std::filesystem::path& folder) {
  std::string page;
  std::error_code none_there;
  std::filesystem::remove_all(folder, none_there);
  for (std::size_t p = 0; p < campaign.points.size(); ++p) {
    const std::vector<Record> records = records_of(campaign.points[p], manifest, store, 1);
    if (records.empty()) continue;
    const Record& record = records.front();
    const std::string name = name_of(classify(density_contrasts(SceneValues("", records)).front()));
    std::filesystem::create_directories(folder, none_there);  // what follows tells when it is not
    const std::string file = fmt::format("{}.svg", p);
    write_text_atomically(folder / file, snapshot_svg(record.scene, record.final_state,
                                                      fmt::format("{}; t = {:.4g}; over the run: {}",
                                                                  campaign.points[p].label, record.time, name)));
    page += fmt::format("## {}\n\n{}\n\n![{}]({}/{})\n\n", campaign.points[p].label, name, name,
                        folder.filename().string(), file);
  }
  return page;
}

std::vector<int> refined_replicas(const Campaign& campaign, const std::vector<PointResult>& results) {
  std::vector<int> replicas;
  for (std::size_t p = 0; p < results.size(); ++p) {
    const std::vector<std::size_t> near = campaign.neighbours(p);
    const bool boundary = std::any_of(near.begin(), near.end(),
                                      [&](std::size_t n) { return results[n].structure != results[p].structure; });
    const Estimate flow = over_replicas(results[p].mean_flow);
    const bool imprecise = campaign.precision > 0 && !(flow.error <= campaign.precision * std::abs(flow.mean));
    const int done = std::max(static_cast<int>(results[p].labels.size()), campaign.replicas);
    replicas.push_back(boundary || imprecise || !results[p].decided() ? std::min(2 * done, campaign.most_replicas)
                                                                      : done);
    replicas.back() = std::max(replicas.back(), done);
  }
  return replicas;
}

std::string phase_table(const Campaign& campaign, const std::vector<PointResult>& results) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t p = 0; p < results.size(); ++p) rows.push_back(row_of(campaign, p, results[p]));
  return markdown_table(header_of(campaign), rows);
}

std::string phase_csv(const Campaign& campaign, const std::vector<PointResult>& results) {
  std::string text = csv_line(header_of(campaign));
  for (std::size_t p = 0; p < results.size(); ++p) {
    std::vector<std::string> row = row_of(campaign, p, results[p]);
    row.resize(header_of(campaign).size());
    text += csv_line(row);
  }
  return text;
}

Plot phase_diagram(const Campaign& campaign, const std::vector<PointResult>& results) {
  if (campaign.axes.size() > 2)
    throw InputError(fmt::format("'{}' has {} axes", campaign.title, campaign.axes.size()), "a diagram has two",
                     "read the table, or plan campaigns of two axes");
  const DrawnAxis across = drawn(campaign.axes.front());
  const DrawnAxis up = campaign.axes.size() == 2 ? drawn(campaign.axes.back()) : DrawnAxis{"", {0}};
  Plot plot{.title = campaign.title, .xlabel = across.label, .ylabel = up.label};
  std::map<std::string, Series> by_name;
  std::vector<double> xs, ys;
  for (std::size_t p = 0; p < results.size(); ++p) {
    const auto& place = campaign.points[p].place;
    Series& series = by_name[results[p].name()];
    series.label = results[p].name();
    series.x.push_back(across.numbers[place[0]]);
    series.y.push_back(up.numbers[campaign.axes.size() == 2 ? place[1] : 0]);
    xs.push_back(series.x.back());
    ys.push_back(series.y.back());
  }
  const auto range = [](const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double margin = *most > *least ? 0.1 * (*most - *least) : 1;
    return std::pair{*least - margin, *most + margin};
  };
  plot.xrange = range(xs);
  plot.yrange = range(ys);
  for (auto& [name, series] : by_name) plot.series.push_back(std::move(series));
  return plot;
}

}  // namespace gpf
