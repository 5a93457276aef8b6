#include "verify/estimators/pair_functions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "gpf/measure/correlations.hpp"
#include "gpf/measure/tallies.hpp"

namespace gpf {
namespace {

constexpr std::size_t cells = Correlations::distance_cells;
constexpr double cell_width = Correlations::distance_range / static_cast<double>(cells);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double Strip::within(double r) const {
  const double w = height;
  double area = std::numbers::pi * w * r * r / 4 - r * r * r / 3;
  if (r > w) {
    const double s = std::sqrt(r * r - w * w);
    area = w * (r * r * std::asin(w / r) + w * s) / 2 - (r * r * r - s * s * s) / 3;
  }
  return 4 * area / (w * w * length);
}

PairFunctions::PairFunctions(const Record& record, const std::vector<int>& bins)
    : length_(record.scene.length() * record.scene.width_over_diameter),
      count_(cells),
      expected_(cells),
      ux_(cells),
      uy_(cells),
      uxy_(cells),
      v_(cells) {
  const TallyLayout layout(record.run);
  const std::vector<double> totals = totals_of(record);
  const auto array = [&](const char* name) -> const NamedArray& { return array_named(record.arrays, name); };
  double paired = 0, pairs = 0;
  for (const int bin : bins) {
    const auto b = static_cast<std::size_t>(bin);
    const auto tally = [&](Tally t) { return totals[layout.at(t, bin)]; };
    const double mirror = 2 * bin >= record.run.bins ? -1 : 1;
    const bool at_wall = record.scene.geometry == Geometry::channel && (bin == 0 || bin == record.run.bins - 1);
    const Strip strip{record.scene.width_over_diameter / record.run.bins - (at_wall ? 0.5 : 0), length_};
    const double disks = tally(Tally::count), mean = tally(Tally::cx) / disks;
    const double shift = mean - array("pair/frame").values[b];  // the record's v is about the frame
    for (std::size_t k = 0; k < cells; ++k) {
      const double r = cell_width * static_cast<double>(k), n = array("pair/count").at(b, k);
      count_[k] += n;
      expected_[k] += array("pair/total").values[b] * (strip.within(r + cell_width) - strip.within(r));
      ux_[k] += array("pair/ux").at(b, k);
      uy_[k] += array("pair/uy").at(b, k);
      uxy_[k] += mirror * array("pair/uxy").at(b, k);
      v_[k] += array("pair/cx").at(b, k) - 2 * shift * array("pair/cx_sum").at(b, k) + shift * shift * n;
    }
    disks_ += disks;
    ux2_ += tally(Tally::ux2);
    cy2_ += tally(Tally::cy2);
    v2_ += tally(Tally::cx2) - disks * mean * mean;
    vcy_ += mirror * (tally(Tally::cxcy) - mean * tally(Tally::cy));
    const double sampled = array("order/disks").values[b];
    paired += sampled;
    pairs += 2 * array("pair/total").values[b];
    forced_ -= tally(Tally::ux2) * sampled / disks;  // not every sample's pairs are counted
    hexatic_ += array("order/psi6").values[b];
    neighbours_ += array("order/neighbours").values[b];
  }
  forced_ /= pairs * ux2_ / disks_;
  hexatic_ /= paired;
  neighbours_ /= paired;
}

double PairFunctions::distance(std::size_t cell) { return cell_width * (static_cast<double>(cell) + 0.5); }

std::vector<double> PairFunctions::pair_correlation() const {
  std::vector<double> g(cells, nan);
  for (std::size_t k = 0; k < cells && distance(k) + cell_width / 2 <= length_ / 2; ++k)
    g[k] = count_[k] / expected_[k];
  return g;
}

const std::vector<double>& PairFunctions::products(Component component, Mean mean) const {
  switch (component) {
    case Component::xx:
      return mean == Mean::instantaneous ? ux_ : v_;
    case Component::yy:
      return uy_;
    case Component::xy:
      break;
  }
  return uxy_;
}

double PairFunctions::one_disk(Component component, Mean mean) const {
  switch (component) {
    case Component::xx:
      return (mean == Mean::instantaneous ? ux2_ : v2_) / disks_;
    case Component::yy:
      return cy2_ / disks_;
    case Component::xy:
      break;
  }
  return std::sqrt(ux2_ * cy2_) / disks_;
}

std::vector<double> PairFunctions::velocity_correlation(Component component, Mean mean) const {
  std::vector<double> c = products(component, mean);
  const double scale = one_disk(component, mean);
  for (std::size_t k = 0; k < cells; ++k) c[k] = count_[k] > 0 ? c[k] / (count_[k] * scale) : nan;
  return c;
}

double PairFunctions::mean_correlation(Component component, double from, double to, Mean mean) const {
  const std::vector<double>& product = products(component, mean);
  double sum = 0, pairs = 0;
  for (std::size_t k = 0; k < cells; ++k)
    if (distance(k) > from && distance(k) < to) sum += product[k], pairs += count_[k];
  return sum / (pairs * one_disk(component, mean));
}

double PairFunctions::one_disk_xy() const { return vcy_ / std::sqrt(v2_ * cy2_); }

std::vector<PairFunctions> pair_functions(const SceneValues& scene, int bin) {
  std::vector<PairFunctions> replicas;
  for (const Record& record : scene.records()) replicas.emplace_back(record, std::vector{bin, scene.bins() - 1 - bin});
  return replicas;
}

Series curve_of(std::string label, const std::vector<PairFunctions>& replicas,
                const std::function<std::vector<double>(const PairFunctions&)>& curve) {
  std::vector<std::vector<double>> curves;
  for (const PairFunctions& replica : replicas) curves.push_back(curve(replica));
  Series series{.label = std::move(label)};
  for (std::size_t k = 0; k < cells; ++k)
    if (PairFunctions::distance(k) > 1)
      add_point(series, PairFunctions::distance(k), per_replica(curves.size(), [&](auto r) { return curves[r][k]; }));
  return series;
}

std::string label_of(const Scene& scene) {
  std::string label = fmt::format("nu {:.3g}, e_n {:.2f}, beta_w {:.1f}", scene.area_fraction(),
                                  scene.normal_restitution, scene.wall_tangential_restitution[Wall::lower]);
  if (scene.particles != 900) label += fmt::format(", N {}", scene.particles);
  return label;
}

}  // namespace gpf
