#include "verify/estimators/normal_stress_crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gpf/base/vec2.hpp"

namespace gpf {
namespace {

Series centre_series(const SceneRow& row, StressPart part, Density density, std::string label) {
  Series points{.label = std::move(label)};
  for (const SceneValues* scene : row.scenes)
    add_point(points, over_replicas(density_of(*scene, density)).mean, centre_value(*scene, part));
  return points;
}

}  // namespace

std::vector<double> density_of(const SceneValues& scene, Density density) {
  if (density == Density::local) return scene.mirrored("area_fraction", scene.half() - 1);
  return std::vector<double>(scene.replicas(), scene.scene().area_fraction());
}

std::string name_of(Density density) { return density == Density::local ? "nu_bin" : "nu"; }

std::vector<double> centre_value(const SceneValues& scene, StressPart part, MeanFlow mean) {
  return first_normal_stress_difference(scene, scene.half() - 1, part, mean);
}

SignChange sign_change(const SceneRow& row, StressPart part, Density density, MeanFlow mean) {
  SignChange change;
  for (std::size_t k = 0; k + 1 < row.scenes.size(); ++k)
    if (over_replicas(centre_value(*row.scenes[k], part, mean)).mean > 0 &&
        over_replicas(centre_value(*row.scenes[k + 1], part, mean)).mean <= 0) {
      change.below = row.scenes[k];
      change.above = row.scenes[k + 1];
    }
  if (!change.found()) return change;
  const std::vector<double> x_below = density_of(*change.below, density), x_above = density_of(*change.above, density),
                            y_below = centre_value(*change.below, part, mean),
                            y_above = centre_value(*change.above, part, mean);
  const std::size_t replicas = std::min(y_below.size(), y_above.size());
  change.densities = per_replica(replicas, [&](std::size_t r) {
    return x_below[r] + (x_above[r] - x_below[r]) * y_below[r] / (y_below[r] - y_above[r]);
  });
  if (replicas < 2) return change;
  const Estimate below = over_replicas(y_below), above = over_replicas(y_above);
  if (!(below.error > 0) || !(above.error > 0)) return change;
  change.crossing = crossing_between(over_replicas(x_below).mean, below, over_replicas(x_above).mean, above, replicas);
  return change;
}

Crossing crossing_between(double x_below, Estimate below, double x_above, Estimate above, std::size_t replicas) {
  const std::vector<double> x{x_below, x_above};
  const std::vector<Estimate> y{below, above};
  const LineFit line = fit_line(x, y);
  // Welch and Satterthwaite's degrees of freedom of the line's error where it crosses zero: each end has its own error.
  const double share = (-line.intercept / line.slope - x_below) / (x_above - x_below);
  const double a = square((1 - share) * below.error), b = square(share * above.error);
  const double degrees_of_freedom = static_cast<double>(replicas - 1) * square(a + b) / (a * a + b * b);
  return zero_crossing(line, student_t_quantile(1 - crossing_alpha, degrees_of_freedom));
}

std::string text_of(const SignChange& change, Density density) {
  if (!change.found()) return "no density of the scenes";
  const std::string between = fmt::format("between the scenes of nu {:.3g} and {:.3g}",
                                          change.below->scene().area_fraction(), change.above->scene().area_fraction());
  if (change.densities.size() < 2 || !change.crossing.bounded()) return "a density " + between;
  return fmt::format("{} {:.3f} (Fieller's 98 % interval {:.3f} to {:.3f}; {})", name_of(density), change.crossing.at,
                     change.crossing.interval.lo, change.crossing.interval.hi, between);
}

std::vector<std::string> crossing_notes(const SceneRow& row) {
  std::vector<std::string> notes;
  for (const StressPart part : {StressPart::both, StressPart::collisional})
    for (const Density density : {Density::mean, Density::local})
      notes.push_back(fmt::format("{}: {} changes sign at {}.", row.label(), symbol_of(part),
                                  text_of(sign_change(row, part, density), density)));
  notes.push_back(
      fmt::format("{}: about the long-time mean flow N_1 changes sign at {}.", row.label(),
                  text_of(sign_change(row, StressPart::both, Density::mean, MeanFlow::long_time), Density::mean)));
  return notes;
}

void append(std::vector<std::string>& notes, std::vector<std::string> more) {
  for (std::string& note : more) notes.push_back(std::move(note));
}

Plot centre_plot(const std::vector<SceneRow>& rows, StressPart part, Density density) {
  Plot plot{.title = fmt::format("{} at the centre", symbol_of(part)),
            .xlabel = density == Density::mean ? "mean area fraction" : "area fraction of the centre bins",
            .ylabel = symbol_of(part)};
  for (const SceneRow& row : rows) {
    plot.series.push_back(centre_series(row, part, density, row.label()));
    const Series& points = plot.series.back();
    plot.series.push_back({.style = SeriesStyle::line, .x = points.x, .y = points.y});
  }
  double most = 0;
  for (const Series& series : plot.series)
    for (const double x : series.x) most = std::max(most, x);
  plot.series.push_back({.style = SeriesStyle::line, .x = {0, most}, .y = {0, 0}});
  return plot;
}

}  // namespace gpf
