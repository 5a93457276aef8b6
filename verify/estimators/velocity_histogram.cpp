#include "verify/estimators/velocity_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gpf/measure/distributions.hpp"
#include "gpf/measure/named_array.hpp"

namespace gpf {

VelocityHistogram::VelocityHistogram(std::vector<double> centres, std::vector<double> counts, int smoothing)
    : centres_(std::move(centres)), counts_(std::move(counts)), smooth_(counts_.size(), 0.0) {
  const int cells = static_cast<int>(counts_.size());
  for (int k = 0; k < cells; ++k) {
    const int first = std::max(0, k - smoothing), last = std::min(cells - 1, k + smoothing);
    for (int j = first; j <= last; ++j)
      smooth_[static_cast<std::size_t>(k)] += counts_[static_cast<std::size_t>(j)] / (last - first + 1);
  }
}

std::size_t VelocityHistogram::highest() const {
  return static_cast<std::size_t>(std::max_element(smooth_.begin(), smooth_.end()) - smooth_.begin());
}

double VelocityHistogram::peak() const {
  const std::size_t k = highest();
  if (smooth_.empty() || !(smooth_[k] > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (k == 0 || k + 1 == smooth_.size()) return centres_[k];
  const double below = smooth_[k - 1], above = smooth_[k + 1], curvature = below - 2 * smooth_[k] + above;
  const double shift = curvature < 0 ? 0.5 * (below - above) / curvature : 0;
  return centres_[k] + shift * (centres_[k + 1] - centres_[k]);
}

double VelocityHistogram::second_rise() const {
  const std::size_t k = highest();
  if (smooth_.empty() || !(smooth_[k] > 0)) return std::numeric_limits<double>::quiet_NaN();
  double rise = 0, least = smooth_[k];
  const auto look = [&](double value) {
    least = std::min(least, value);
    rise = std::max(rise, value - least);
  };
  for (std::size_t j = k + 1; j < smooth_.size(); ++j) look(smooth_[j]);
  least = smooth_[k];
  for (std::size_t j = k; j-- > 0;) look(smooth_[j]);
  return rise / smooth_[k];
}

std::vector<VelocityHistogram> velocity_histograms(const SceneValues& scene, std::string_view array, int bin,
                                                   Parity parity) {
  std::vector<VelocityHistogram> histograms;
  for (const Record& record : scene.records()) {
    const NamedArray& all = array_named(record.arrays, array);
    const std::size_t cells = all.shape.back();
    const auto near = static_cast<std::size_t>(bin), far = static_cast<std::size_t>(scene.bins() - 1 - bin);
    const double width = 2 * Distributions::velocity_range / static_cast<double>(cells);
    std::vector<double> centres, counts;
    for (std::size_t c = 0; c < cells; ++c) {
      centres.push_back(-Distributions::velocity_range + (static_cast<double>(c) + 0.5) * width);
      const double mirror = all.at(far, parity == Parity::even ? c : cells - 1 - c);
      counts.push_back(near == far ? all.at(near, c) : all.at(near, c) + mirror);
    }
    histograms.emplace_back(std::move(centres), std::move(counts));
  }
  return histograms;
}

Series histogram_series(const std::vector<VelocityHistogram>& histograms, std::string label) {
  Series points{.label = std::move(label)};
  if (histograms.empty()) return points;
  std::vector<double> total(histograms.front().counts().size(), 0.0);
  for (const VelocityHistogram& histogram : histograms)
    for (std::size_t c = 0; c < total.size(); ++c) total[c] += histogram.counts()[c];
  const double most = *std::max_element(total.begin(), total.end());
  for (std::size_t c = 0; c < total.size(); ++c) {
    if (!(total[c] > 0)) continue;
    points.x.push_back(histograms.front().centres()[c]);
    points.y.push_back(total[c] / most);
    points.yerr.push_back(std::sqrt(total[c]) / most);
  }
  return points;
}

}  // namespace gpf
