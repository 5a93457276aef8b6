#include "verify/estimators/velocity_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/measure/distributions.hpp"

namespace gpf {
namespace {

/// One row of a record's histogram, with its cells in units of the velocity.
struct RecordHistogram {
  double lowest = 0, width = 0;
  std::vector<double> counts;

  RecordHistogram(const Record& record, Velocity velocity, std::size_t bin, bool in_mirror) {
    const char* name = velocity == Velocity::ux ? "ux" : velocity == Velocity::uy ? "uy" : "cx";
    const NamedArray& array = array_named(record.arrays, std::string("velocity/") + name);
    const NamedArray& frame = array_named(record.arrays, "velocity/frame");
    const double range = velocity == Velocity::cx ? Distributions::flow_range : Distributions::velocity_range;
    const double sigma = frame.at(bin, velocity == Velocity::uy ? 2 : 1);
    for (std::size_t i = 0; i < array.shape.back(); ++i) counts.push_back(array.at(bin, i));
    if (in_mirror && velocity == Velocity::uy) std::reverse(counts.begin(), counts.end());
    width = 2 * range / static_cast<double>(counts.size()) * sigma;
    lowest = (velocity == Velocity::cx ? frame.at(bin, 0) : 0) - range * sigma;
  }
  [[nodiscard]] double centre(std::size_t i) const { return lowest + (static_cast<double>(i) + 0.5) * width; }
  /// <(v - about)^power> times the counts; of the even ones the second is free of the width of the cells.
  [[nodiscard]] double sum(int power, double about) const {
    double sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) sum += counts[i] * std::pow(centre(i) - about, power);
    return power == 2 ? sum - this->sum(0, about) * width * width / 12 : sum;
  }
};

/// Shares n counts in from < u/sigma < to evenly out over the grid.
void share_out(VelocityDistribution& d, double from, double to, double n) {
  const double lo = (from + d.range) / d.cell, hi = (to + d.range) / d.cell, last = static_cast<double>(d.cells);
  for (double i = std::max(std::floor(lo), 0.0); i < std::min(hi, last); i += 1)
    d.counts[static_cast<std::size_t>(i)] += n * (std::min(hi, i + 1) - std::max(lo, i)) / (hi - lo);
}

std::size_t cell_at(double x) {
  return static_cast<std::size_t>(std::lround((x + VelocityDistribution::range) / VelocityDistribution::cell));
}

}  // namespace

const char* name_of(Velocity velocity) {
  return velocity == Velocity::ux ? "u_x" : velocity == Velocity::uy ? "u_y" : "u_x about the long-time mean";
}

double VelocityDistribution::between(double from, double to) const {
  double sum = 0;
  for (std::size_t i = cell_at(from); i < cell_at(to); ++i) sum += counts[i];
  return sum;
}

std::vector<double> VelocityDistribution::density() const {
  const double at_zero = between(-2 * cell, 2 * cell) / 4;
  std::vector<double> p = counts;
  for (double& value : p) value /= at_zero;
  return p;
}

VelocityDistribution velocity_distribution(const Record& record, Velocity velocity, int bin) {
  const auto b = static_cast<std::size_t>(bin), mirror = static_cast<std::size_t>(record.run.bins - 1 - bin);
  std::vector<RecordHistogram> histograms{{record, velocity, b, false}};
  if (mirror != b) histograms.emplace_back(record, velocity, mirror, true);
  VelocityDistribution d;
  std::vector<double> means(histograms.size(), 0.0);
  double second = 0, third = 0, fourth = 0;
  for (std::size_t h = 0; h < histograms.size(); ++h) {
    const double n = histograms[h].sum(0, 0);
    if (n == 0) throw InputError(fmt::format("no velocity in bin {}", bin + 1), "the bin was empty", "use wider bins");
    if (velocity == Velocity::cx) means[h] = histograms[h].sum(1, 0) / n;
    d.total += n, d.mean += n * means[h];
    second += histograms[h].sum(2, means[h]);
    third += histograms[h].sum(3, means[h]);
    fourth += histograms[h].sum(4, means[h]);
  }
  d.mean /= d.total;
  d.sigma = std::sqrt(second / d.total);
  d.skewness = third / d.total / std::pow(d.sigma, 3);
  d.kurtosis = fourth / d.total / std::pow(d.sigma, 4);
  d.reach = d.range;
  for (std::size_t h = 0; h < histograms.size(); ++h) {
    const RecordHistogram& from = histograms[h];
    const std::size_t last = from.counts.size() - 1;  // the outermost cells also hold what lies beyond
    const auto edge = [&](std::size_t i) {
      return (from.lowest + static_cast<double>(i) * from.width - means[h]) / d.sigma;
    };
    for (std::size_t i = 1; i < last; ++i) share_out(d, edge(i), edge(i + 1), from.counts[i]);
    d.reach = std::min({d.reach, -edge(1), edge(last)});
  }
  return d;
}

std::vector<VelocityDistribution> velocity_distributions(const SceneValues& scene, Velocity velocity, int bin) {
  std::vector<VelocityDistribution> all;
  for (const Record& record : scene.records()) all.push_back(velocity_distribution(record, velocity, bin));
  return all;
}

Series density_series(std::string label, const std::vector<VelocityDistribution>& replicas, std::size_t step) {
  Series series{.label = std::move(label)};
  std::vector<std::vector<double>> densities;
  for (const VelocityDistribution& d : replicas) densities.push_back(d.density());
  for (std::size_t i = 0; i + step <= VelocityDistribution::cells; i += step) {
    const std::vector<double> values = per_replica(replicas.size(), [&](std::size_t r) {
      double sum = 0;
      for (std::size_t k = i; k < i + step; ++k) sum += densities[r][k];
      return sum / static_cast<double>(step);
    });
    const double x = VelocityDistribution::centre(i) + 0.5 * static_cast<double>(step - 1) * VelocityDistribution::cell;
    if (over_replicas(values).mean > 0) add_point(series, x, values);
  }
  return series;
}

Series gaussian_series() {
  Series line{.label = "Gaussian", .style = SeriesStyle::line};
  for (double x = -6; x <= 6.001; x += 0.05) line.x.push_back(x), line.y.push_back(std::exp(-0.5 * x * x));
  return line;
}

Plot density_plot(std::string title, double least) {
  return {.title = std::move(title),
          .xlabel = "u/σ",
          .ylabel = "P(u)/P(0)",
          .logy = true,
          .yrange = {{least, 5}},
          .series = {gaussian_series()}};
}

double distance_from_gaussian(const VelocityDistribution& d) {
  double distance = 0;
  double below = 0;  // counts beyond the grid are too few to matter
  for (std::size_t i = 0; i < d.cells; ++i) {
    below += d.counts[i] / d.total;
    const double edge = d.centre(i) + 0.5 * d.cell;
    distance = std::max(distance, std::abs(below - 0.5 * std::erfc(-edge / std::numbers::sqrt2)));
  }
  return distance;
}

double dispersion(const std::vector<VelocityDistribution>& replicas) {
  constexpr double fewest = 20;
  double variance = 0, expected = 0;
  for (std::size_t i = 0; i < VelocityDistribution::cells; ++i) {
    const std::vector<double> n = per_replica(
        replicas.size(), [&](std::size_t r) { return replicas[r].counts[i] * replicas[0].total / replicas[r].total; });
    const ReplicaSummary summary = summarise(n);
    if (summary.count < 2 || summary.mean < fewest) continue;
    variance += summary.deviation * summary.deviation, expected += summary.mean;
  }
  return expected > 0 ? std::max(1.0, variance / expected) : 1.0;
}

std::vector<Peak> find_peaks(const VelocityDistribution& d, double dispersion) {
  constexpr double least_part = 0.02, errors = 4;
  std::vector<double> s(d.cells, 0.0);
  for (std::size_t i = 1; i + 1 < s.size(); ++i) s[i] = d.counts[i - 1] + d.counts[i] + d.counts[i + 1];
  const double highest = *std::max_element(s.begin(), s.end());
  const auto stands_out = [&](std::size_t high, std::size_t low) {
    const double error = std::sqrt(dispersion * (s[high] + s[low]));
    return s[high] - s[low] > std::max(errors * error, least_part * highest);
  };
  std::vector<Peak> peaks;
  std::size_t high = 0, low = 0;
  bool rising = true;  // as long as no fall from `high` stands out, or else no rise from `low`
  for (std::size_t i = 1; i < s.size(); ++i) {
    if (rising) {
      if (s[i] > s[high]) high = i;
      if (!stands_out(high, i)) continue;
      const double bend = s[high - 1] - 2 * s[high] + s[high + 1];  // parabola through three cells
      const double shift = bend < 0 ? 0.5 * (s[high - 1] - s[high + 1]) / bend : 0;
      peaks.push_back({d.centre(high) + shift * d.cell, s[high] / (0.75 * d.between(-0.2, 0.2))});
      rising = false, low = i;
    } else {
      if (s[i] < s[low]) low = i;
      if (stands_out(i, low)) rising = true, high = i;
    }
  }
  return peaks;
}

double dip_at_zero(const VelocityDistribution& d) {
  return 1 - d.between(-0.1, 0.1) * 2 / (d.between(-0.6, -0.4) + d.between(0.4, 0.6));
}

}  // namespace gpf
