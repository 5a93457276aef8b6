// Claims phase.*: which structure a channel has, over the lengths, widths and walls of a campaign (thesis figs. 5.6,
// 5.8-5.11, 5.22).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "gpf/base/error.hpp"
#include "gpf/io/snapshot.hpp"
#include "verify/campaign_collect.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf {
namespace {

struct Point {
  SceneValues scene;
  PointResult result;

  [[nodiscard]] double length() const { return scene.scene().length_over_width; }
  [[nodiscard]] double width() const { return scene.scene().width_over_diameter; }
  [[nodiscard]] double roughness() const { return scene.scene().wall_tangential_restitution[lower]; }
};

/// L/W follows from a whole number of disks: equal to a percent is equal.
bool same_length(double a, double b) { return std::abs(a - b) < 0.01 * b; }

std::vector<Point> points_of(const SceneRecords& records) {
  std::vector<Point> points;
  for (const auto& [name, replicas] : records) {
    SceneValues scene(name, replicas);
    std::vector<std::optional<Structure>> labels;
    for (const DensityContrast& contrast : density_contrasts(scene)) labels.push_back(classify(contrast));
    points.push_back({std::move(scene), result_of(std::move(labels))});
  }
  return points;
}

/// By the replica's number, from 0.
enum class Runs { all, even, odd };

/// 1 for each run of the points that has one of the structures, else 0. Points are alike to the claim, so that their
/// runs together are judged; where they are not, the interval of a common share is wider than need be.
std::vector<double> hits(const std::vector<const Point*>& points, const std::vector<Structure>& wanted,
                         Runs runs = Runs::all) {
  std::vector<double> values;
  for (const Point* point : points)
    for (std::size_t r = 0; r < point->result.labels.size(); ++r) {
      if (runs != Runs::all && (r % 2 == 0) != (runs == Runs::even)) continue;
      const auto& label = point->result.labels[r];
      values.push_back(label && std::find(wanted.begin(), wanted.end(), *label) != wanted.end() ? 1 : 0);
    }
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

std::vector<const Point*> those(const std::vector<Point>& points, const std::function<bool(const Point&)>& wanted) {
  std::vector<const Point*> chosen;
  for (const Point& point : points)
    if (wanted(point)) chosen.push_back(&point);
  return chosen;
}

std::vector<double> lengths_of(const std::vector<Point>& points) {
  std::vector<double> lengths;
  for (const Point& point : points)
    if (std::none_of(lengths.begin(), lengths.end(), [&](double l) { return same_length(point.length(), l); }))
      lengths.push_back(point.length());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

double median_width(const std::vector<Point>& points) {
  std::vector<double> values;
  for (const Point& p : points) values.push_back(p.width());
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

constexpr const char* somewhere = "somewhere between";

/// The regions that a claim can speak of: the shortest and the longest channels; of those between, for each width, the
/// length at which `wanted` is most frequent in the even replicas, so that the odd ones can be judged; those below the
/// median width; those of the largest width or length; all.
std::vector<const Point*> region(const std::string& name, const std::vector<Point>& points,
                                 const std::vector<Structure>& wanted) {
  const std::vector<double> lengths = lengths_of(points);
  const auto at = [&](double length) {
    return those(points, [&](const Point& p) { return same_length(p.length(), length); });
  };
  if (name == "shortest") return at(lengths.front());
  if (name == "longest") return at(lengths.back());
  if (name == "everywhere") return those(points, [](const Point&) { return true; });
  if (name == "narrow") {
    const double width = median_width(points);
    return those(points, [&](const Point& p) { return p.width() < width; });
  }
  if (name == "widest or longest") {
    double width = 0;
    for (const Point& p : points) width = std::max(width, p.width());
    return those(points, [&](const Point& p) { return p.width() == width || same_length(p.length(), lengths.back()); });
  }
  if (name == somewhere) {
    std::set<double> widths;
    for (const Point& p : points) widths.insert(p.width());
    std::vector<const Point*> all;
    for (const double width : widths) {
      std::vector<const Point*> best;
      for (std::size_t l = 1; l + 1 < lengths.size(); ++l) {
        const std::vector<const Point*> here =
            those(points, [&](const Point& p) { return p.width() == width && same_length(p.length(), lengths[l]); });
        if (best.empty() || mean(hits(here, wanted, Runs::even)) > mean(hits(best, wanted, Runs::even))) best = here;
      }
      all.insert(all.end(), best.begin(), best.end());
    }
    return all;
  }
  throw InputError(fmt::format("unknown region '{}' of a phase diagram", name), "a claim's [structures] names it",
                   "write shortest, longest, somewhere between, narrow, widest or longest, or everywhere");
}

std::string points_text(const std::vector<const Point*>& points) {
  std::set<std::string> lengths, widths;
  for (const Point* p : points) {
    lengths.insert(fmt::format("{:.3g}", p->length()));
    widths.insert(fmt::format("{:.3g}", p->width()));
  }
  return fmt::format("{} points, L/W {}, W/d {}", points.size(), fmt::join(lengths, ", "), fmt::join(widths, ", "));
}

/// Of all runs, those with the label that is the most frequent one at the other points of their length and width: how
/// little the rest matters. A tie, or "between the classes", is no label that a run could share.
std::vector<double> runs_like_their_length(const std::vector<Point>& points) {
  std::vector<double> values;
  for (const Point& point : points) {
    std::map<std::optional<Structure>, int> count;
    for (const Point& other : points)
      if (&other != &point && same_length(other.length(), point.length()) && other.width() == point.width())
        for (const auto& label : other.result.labels) ++count[label];
    if (count.empty()) continue;  // nothing but the length and the width varies here
    const auto most =
        std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const bool tie =
        std::count_if(count.begin(), count.end(), [&](const auto& c) { return c.second == most->second; }) != 1;
    for (const auto& label : point.result.labels) values.push_back(!tie && label && label == most->first ? 1 : 0);
  }
  return values;
}

/// The label of most runs at a point; where others have another one, or two are as frequent, that is said.
std::string name_at(const PointResult& result) {
  if (result.bistable) return "bistable";
  return name_of(result.structure) + (result.share.hits < result.labels.size() ? ", not all" : "");
}

void draw(const std::vector<Point>& points, Evidence& evidence) {
  const bool widths =
      std::any_of(points.begin(), points.end(), [&](const Point& p) { return p.width() != points.front().width(); });
  const auto height = [&](const Point& p) { return widths ? p.width() : p.roughness(); };
  std::map<std::string, Series> by_name;
  double low = INFINITY, high = -INFINITY;
  for (const Point& p : points) {
    const std::string name = name_at(p.result);
    Series& series = by_name[name];
    series.label = name;
    series.x.push_back(p.length());
    series.y.push_back(height(p));
    low = std::min(low, height(p)), high = std::max(high, height(p));
  }
  const std::vector<double> lengths = lengths_of(points);
  const double margin = 0.1 * (high - low), side = 0.1 * (lengths.back() - lengths.front());
  evidence.plot = {.title = "Structure of most replicas",
                   .xlabel = "L/W",
                   .ylabel = widths ? "W/d" : "beta_w of the lower wall",
                   .xrange = {{lengths.front() - side, lengths.back() + side}},
                   .yrange = {{low - margin, high + margin}}};
  for (auto& [name, series] : by_name) evidence.plot.series.push_back(std::move(series));

  // Pictures of one row of the diagram, the highest.
  std::vector<const Point*> row = those(points, [&](const Point& p) { return height(p) == high; });
  std::sort(row.begin(), row.end(), [](const Point* a, const Point* b) { return a->length() < b->length(); });
  for (const Point* p : row) {
    const Record& record = p->scene.records().front();
    const std::string title =
        fmt::format("{}, t = {:.4g}: {}", p->scene.name(), record.time, name_of(p->result.labels.front()));
    evidence.drawings.push_back({title, snapshot_svg(record.scene, record.final_state, title)});
  }
}

}  // namespace

// [structures] states, for each region of the diagram, what more than half of its runs are; parameter `alike`, where
// given, which share of all runs has the label that is the most frequent one at the other points of their length and
// width; `most_varicose`, which share is a varicose wave at most.
Evidence estimate_phase_diagram(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<Point> points = points_of(records);
  Evidence evidence;
  const auto add = [&](std::string label, std::vector<double> values, Interval band) {
    evidence.checks.push_back(
        {.label = std::move(label), .values = std::move(values), .band = band, .reference = NAN, .share = true});
  };
  for (const auto& [name, stated] : claim.structures) {
    const std::vector<Structure> wanted = structures_named(stated);
    const std::vector<const Point*> chosen = region(name, points, wanted);
    add(fmt::format("{} ({}): runs with a {}", name, points_text(chosen), stated),
        hits(chosen, wanted, name == somewhere ? Runs::odd : Runs::all), majority);
  }
  if (claim.parameters.contains("alike"))
    add("runs with the label that is the most frequent one at the other points of their L/W and W/d",
        runs_like_their_length(points), {claim.parameter("alike"), 1});
  if (claim.parameters.contains("most_varicose"))
    add("runs with a varicose wave", hits(region("everywhere", points, {}), {Structure::varicose}),
        {0, claim.parameter("most_varicose")});
  for (const Point& p : points)
    evidence.notes.push_back(fmt::format("{} (N {}): {}; band shift {:.3f} W.", p.scene.name(),
                                         p.scene.scene().particles, tally_of(p.result.labels),
                                         over_replicas(p.scene.of("band_shift")).mean));
  draw(points, evidence);
  return evidence;
}

}  // namespace gpf
