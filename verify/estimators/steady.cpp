// algo.steady: kinetic energy and granular temperature of the whole flow become stationary.
#include <fmt/format.h>

#include <algorithm>

#include "gpf/base/error.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// Mean of a history over from <= time < to. Throws InputError when it holds no moment there.
double mean_between(const Record& record, const std::vector<double>& values, double from, double to) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (record.history.time[k] >= from && record.history.time[k] < to) sum += values[k], count += 1;
  if (count == 0)
    throw InputError(fmt::format("a history without a moment between times {:g} and {:g}", from, to),
                     "the run is shorter than that", "lengthen the scene's duration");
  return sum / count;
}

/// Second half of the averaging window less its first half, over the mean.
double drift(const Record& record, const std::vector<double>& values) {
  const double from = record.run.start_up, middle = 0.5 * (from + record.time), beyond = 2 * record.time;
  return (mean_between(record, values, middle, beyond) - mean_between(record, values, from, middle)) /
         mean_between(record, values, from, beyond);
}

/// The least of the transient, over the mean of the window: well below one when the run began far from its end.
double departure(const Record& record, const std::vector<double>& values) {
  double least = values.front();
  for (std::size_t k = 0; k < values.size() && record.history.time[k] < record.run.start_up; ++k)
    least = std::min(least, values[k]);
  return least / mean_between(record, values, record.run.start_up, 2 * record.time);
}

/// The replicas' mean course, in units of the mean over the window.
Series course(const SceneValues& scene, std::vector<double> History::*field, std::string label) {
  Series series{.label = std::move(label), .style = SeriesStyle::line};
  constexpr std::size_t most_points = 400;
  const Record& first = scene.records().front();
  const std::size_t stride = (first.history.time.size() + most_points - 1) / most_points;
  for (std::size_t k = 0; k < first.history.time.size(); k += stride) {
    double sum = 0, scale = 0;
    for (const Record& record : scene.records()) {
      const std::vector<double>& values = record.history.*field;
      if (k >= values.size()) return series;
      sum += values[k];
      scale += mean_between(record, values, record.run.start_up, 2 * record.time);
    }
    series.x.push_back(first.history.time[k]);
    series.y.push_back(sum / scale);
  }
  return series;
}

}  // namespace

Evidence estimate_steady(const Claim& claim, Tier, const SceneRecords& records) {
  struct Field {
    std::vector<double> History::*values;
    const char *name, *symbol;
  };
  constexpr Field fields[] = {{&History::energy, "kinetic energy", "E"},
                              {&History::temperature, "granular temperature", "T"}};
  Evidence evidence;
  evidence.plot = {.title = "The way to the steady state",
                   .xlabel = "time in (W/g)^(1/2)",
                   .ylabel = "E and T over their means after the start-up",
                   .series = {}};
  for (const auto& entry : records) {
    const auto& name = entry.first;
    const auto& replicas = entry.second;  // no structured binding: clang 14 cannot capture one
    const SceneValues scene(name, replicas);
    for (const Field& field : fields) {
      evidence.checks.push_back(
          {.label = fmt::format("{}: drift of {} {} between the halves of the window", name, field.name, field.symbol),
           .values = per_replica(scene.replicas(),
                                 [&](std::size_t r) { return drift(replicas[r], replicas[r].history.*field.values); }),
           .band = band_about(0, claim.tolerance_total())});
      evidence.checks.push_back(
          {.label =
               fmt::format("{}: least {} {} of the transient over its steady mean", name, field.name, field.symbol),
           .values =
               per_replica(scene.replicas(),
                           [&](std::size_t r) { return departure(replicas[r], replicas[r].history.*field.values); }),
           .band = {0, claim.parameter("transient_below")},
           .exact = true});
      evidence.plot.series.push_back(course(scene, field.values, fmt::format("{}, {}", field.symbol, name)));
    }
    evidence.notes.push_back(fmt::format("{}: the window begins at time {:g} and ends at {:g}.", name,
                                         replicas.front().run.start_up, replicas.front().time));
  }
  evidence.notes.emplace_back(
      "E is the mean of c.c/2 over all disks, T that of u.u/2 with u about the instantaneous mean of the bin. The "
      "lines "
      "are means over the replicas.");
  return evidence;
}

}  // namespace gpf
