#include "verify/estimators/scene_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/scene/canonical_text.hpp"

namespace gpf {

std::vector<double> totals_of(const Record& record) {
  const TallyLayout layout(record.run);
  std::vector<double> totals(layout.size(), 0.0);
  for (std::size_t b = 0; b < record.blocks; ++b)
    for (std::size_t k = 0; k < totals.size(); ++k) totals[k] += record.sums[b * totals.size() + k];
  return totals;
}

BlockTimes block_times(const Record& record) {
  const TallyLayout layout(record.run);
  const double interval = record.run.sample_interval;
  return {std::ceil(record.run.start_up / interval) * interval,
          record.blocks == 0 ? 0 : record.sums[layout.at(Tally::measured_time)]};
}

SceneValues::SceneValues(std::string name, const std::vector<Record>& records)
    : name_(std::move(name)), records_(&records) {
  if (records.empty())
    throw InputError(fmt::format("no record of scene {}", name_), "an estimator needs at least one replica",
                     "run the scene first");
  for (const Record& record : records) {
    if (record.run.bins != bins() || scene_hash(record.scene) != scene_hash(scene()))
      throw InputError(fmt::format("the records of {} are of different scenes", name_),
                       "they differ in more than their seeds", "pass replicas of one scene");
    auto& quantities = quantities_.emplace_back();
    for (Quantity& q : derive_quantities(record.scene, TallyLayout(record.run), totals_of(record)))
      quantities.emplace(std::move(q.name), std::move(q.values));
  }
}

std::vector<double> SceneValues::of(std::string_view quantity, int bin) const {
  return per_replica(replicas(), [&](std::size_t r) {
    const auto found = quantities_[r].find(quantity);
    if (found == quantities_[r].end() || static_cast<std::size_t>(bin) >= found->second.size())
      throw InputError(fmt::format("scene {} has no quantity {}[{}]", name_, quantity, bin),
                       "a channel and a periodic scene measure different things", "see gpf/measure/quantities.hpp");
    return found->second[static_cast<std::size_t>(bin)];
  });
}

std::vector<double> SceneValues::mirrored(std::string_view quantity, int bin, Parity parity) const {
  const std::vector<double> near = of(quantity, bin), far = of(quantity, bins() - 1 - bin);
  const double sign = parity == Parity::even ? 1 : -1;
  return per_replica(replicas(), [&](std::size_t r) { return 0.5 * (near[r] + sign * far[r]); });
}

std::vector<double> SceneValues::mean_profile(std::string_view quantity) const {
  std::vector<double> profile;
  for (int bin = 0; bin < half(); ++bin) profile.push_back(over_replicas(mirrored(quantity, bin)).mean);
  return profile;
}

std::vector<SceneValues> by_area_fraction(const SceneRecords& records) {
  std::vector<SceneValues> scenes;
  for (const auto& [name, replicas] : records) scenes.emplace_back(name, replicas);
  std::stable_sort(scenes.begin(), scenes.end(), [](const SceneValues& a, const SceneValues& b) {
    return a.scene().area_fraction() < b.scene().area_fraction();
  });
  return scenes;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  return per_replica(std::min(a.size(), b.size()), [&](std::size_t r) { return a[r] - b[r]; });
}

std::vector<double> magnitude(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

Estimate over_replicas(const std::vector<double>& values) {
  const ReplicaSummary summary = summarise(values);
  return {summary.mean, summary.standard_error()};
}

void add_point(Series& series, double x, const std::vector<double>& values) {
  const Estimate estimate = over_replicas(values);
  series.x.push_back(x);
  series.y.push_back(estimate.mean);
  series.yerr.push_back(estimate.error);
}

Interval band_about(double reference, double half_width) { return {reference - half_width, reference + half_width}; }

double process_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace gpf
