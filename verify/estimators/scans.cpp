#include "verify/estimators/scans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gpf/base/error.hpp"

namespace gpf {

double area_fraction(const Scene& scene) { return scene.area_fraction(); }
double normal_restitution(const Scene& scene) { return scene.normal_restitution; }
double wall_restitution(const Scene& scene) { return scene.wall_tangential_restitution[lower]; }

bool any_scene(const Scene&) { return true; }
bool rough_walls(const Scene& scene) { return wall_restitution(scene) < 0.5; }
bool smooth_walls(const Scene& scene) { return !rough_walls(scene); }

namespace {

/// Numbers of scene files that are meant to be equal: an area fraction is computed, and off by round-off.
bool same(double a, double b) { return std::abs(a - b) < 1e-6; }

}  // namespace

Scans scans_by(SceneNumber group, SceneNumber order, const SceneRecords& records, SceneFilter keep) {
  Scans scans;
  for (const auto& [name, replicas] : records) {
    SceneValues values(name, replicas);
    if (!keep(values.scene())) continue;
    const double key = group(values.scene());
    const auto found = std::find_if(scans.begin(), scans.end(), [&](const auto& s) { return same(s.first, key); });
    (found == scans.end() ? scans[key] : found->second).push_back(std::move(values));
  }
  for (auto& [key, scan] : scans)
    std::stable_sort(scan.begin(), scan.end(), [order](const SceneValues& a, const SceneValues& b) {
      return order(a.scene()) < order(b.scene());
    });
  return scans;
}

const SceneValues* find_scene(const std::vector<SceneValues>& scan, SceneNumber number, double value) {
  for (const SceneValues& scene : scan)
    if (same(number(scene.scene()), value)) return &scene;
  return nullptr;
}

std::vector<double> numbers_of(const std::vector<SceneValues>& scan, SceneNumber number) {
  std::vector<double> numbers;
  for (const SceneValues& scene : scan) numbers.push_back(number(scene.scene()));
  return numbers;
}

std::vector<std::vector<double>> values_of(const std::vector<SceneValues>& scan, std::string_view quantity) {
  std::vector<std::vector<double>> values;
  for (const SceneValues& scene : scan) values.push_back(scene.of(quantity));
  return values;
}

std::vector<double> log_ratio(const std::vector<double>& a, const std::vector<double>& b) {
  return combined(a, b, [](double p, double q) { return std::log(p / q); });
}

std::vector<double> log_interpolated(const std::vector<std::vector<double>>& x,
                                     const std::vector<std::vector<double>>& y, double at) {
  std::size_t replicas = x.empty() ? 0 : x.front().size();
  for (const std::vector<double>& values : x) replicas = std::min(replicas, values.size());
  return per_replica(replicas, [&](std::size_t r) {
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const double a = std::log(x[k][r] / at), b = std::log(x[k + 1][r] / at);
      if (a * b <= 0) return (std::log(y[k][r]) * b - std::log(y[k + 1][r]) * a) / (b - a);
    }
    return std::nan("");
  });
}

void add_extremum(Evidence& evidence, const std::string& label, const std::vector<double>& x,
                  const std::vector<std::vector<double>>& values, Extremum extremum) {
  if (values.size() < 3)
    throw InputError(fmt::format("{}: no extremum among {} points", label, values.size()),
                     "it needs a point on either side", "give the claim at least three scenes");
  const double sign = extremum == Extremum::maximum ? 1 : -1;
  std::size_t inner = 1;
  for (std::size_t k = 2; k + 1 < values.size(); ++k)
    if (sign * over_replicas(values[k]).mean > sign * over_replicas(values[inner]).mean) inner = k;
  for (const std::size_t end : {std::size_t{0}, values.size() - 1})
    evidence.checks.push_back({.label = fmt::format("{} at {:.3g} less that at {:.3g}", label, x[inner], x[end]),
                               .values = difference(values[inner], values[end]),
                               .band = sign > 0 ? Interval{0, INFINITY} : Interval{-INFINITY, 0},
                               .x = x[inner]});
}

std::string with_error(const std::vector<double>& values) {
  const Estimate estimate = over_replicas(values);
  return fmt::format("{:.3g} +- {:.1g}", estimate.mean, estimate.error);
}

Series points_of(std::string label, const std::vector<SceneValues>& scan, SceneNumber x, std::string_view y) {
  Series series{.label = std::move(label)};
  for (const SceneValues& scene : scan) add_point(series, x(scene.scene()), scene.of(y));
  return series;
}

double mean_knudsen(const SceneValues& scene) { return over_replicas(scene.of("knudsen_number_lab")).mean; }

Series over_knudsen(std::string label, const std::vector<SceneValues>& scan, std::string_view quantity) {
  Series series{.label = std::move(label)};
  for (const SceneValues& scene : scan) add_point(series, mean_knudsen(scene), scene.of(quantity));
  return series;
}

std::vector<const SceneValues*> between_knudsen(const std::vector<SceneValues>& scan, double lowest, double highest) {
  std::vector<const SceneValues*> kept;
  for (const SceneValues& scene : scan)
    if (lowest < mean_knudsen(scene) && mean_knudsen(scene) < highest) kept.push_back(&scene);
  return kept;
}

}  // namespace gpf
