#include "verify/estimators/normal_stress_crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gpf/base/vec2.hpp"
#include "gpf/stats/hypothesis.hpp"

namespace gpf {
namespace {

Series centre_series(const SceneRow& row, StressPart part, Density density, std::string label) {
  Series points{.label = std::move(label)};
  for (const SceneValues* scene : row.scenes)
    add_point(points, over_replicas(density_of(*scene, density)).mean, centre_value(*scene, part));
  return points;
}

/// Sign of the mean over replicas where it is certain to crossing_alpha, else 0.
int sure_sign(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const Estimate e = over_replicas(values);
  const double bound = student_t_quantile(1 - crossing_alpha, static_cast<double>(values.size() - 1)) * e.error;
  return e.mean > bound ? 1 : e.mean < -bound ? -1 : 0;
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
  std::vector<std::vector<double>> y;
  for (const SceneValues* scene : row.scenes) y.push_back(centre_value(*scene, part, mean));
  SignChange change;
  std::size_t first = y.size(), last = y.size();
  for (std::size_t k = y.size(); k-- > 0;) {
    if (sure_sign(y[k]) < 0) last = k;
    if (sure_sign(y[k]) <= 0 || last == y.size()) continue;
    first = k;
    break;
  }
  if (first == y.size()) return change;
  change.below = row.scenes[first];
  change.above = row.scenes[last];

  std::vector<std::vector<double>> x;
  std::vector<double> mean_x;
  std::vector<Estimate> estimates;
  y = {y.begin() + static_cast<std::ptrdiff_t>(first), y.begin() + static_cast<std::ptrdiff_t>(last) + 1};
  std::size_t replicas = y.front().size();
  bool errors = true;
  for (std::size_t k = 0; k < y.size(); ++k) {
    x.push_back(density_of(*row.scenes[first + k], density));
    mean_x.push_back(over_replicas(x.back()).mean);
    estimates.push_back(over_replicas(y[k]));
    replicas = std::min(replicas, y[k].size());
    errors = errors && estimates.back().error > 0;
  }
  if (errors && y.size() > 2) {
    const LineFit line = fit_line(mean_x, estimates);
    if (chi2_p_value(line.chi2, line.degrees_of_freedom) < crossing_alpha) return change;
    change.crossing = zero_crossing(line, student_t_quantile(1 - crossing_alpha, static_cast<double>(replicas - 1)));
  }
  if (errors && y.size() == 2)
    change.crossing = crossing_between(mean_x[0], estimates[0], mean_x[1], estimates[1], replicas);
  change.densities = per_replica(replicas, [&](std::size_t r) {
    std::vector<double> at;
    std::vector<Estimate> value;  // of this replica, with the error of the mean as its weight
    for (std::size_t k = 0; k < y.size(); ++k) {
      at.push_back(x[k][r]);
      value.push_back({y[k][r], errors ? estimates[k].error : 1});
    }
    const LineFit line = fit_line(at, value);
    return -line.intercept / line.slope;
  });
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
