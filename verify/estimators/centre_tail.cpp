#include "verify/estimators/centre_tail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace gpf {
namespace {

constexpr double gaussian_beyond_three = 0.0026998;  // share of a Gaussian beyond three sigma

/// Exponents by window, and which law the counts prefer: one sentence for each side.
void note_tail(Evidence& evidence, const CentreTail& tail) {
  for (std::size_t s = 0; s < std::size(tail_sides); ++s) {
    const TailExponent all = tail_exponent(tail.fits[s]);
    std::string text =
        fmt::format("{}, {}, {}: exponent {:.2f} (error over replicas and half the spread over windows {:.2f}):",
                    name_of(tail.velocity), tail.label(), tail_sides[s].label, all.estimate.mean, all.estimate.error);
    for (const TailFit& fit : tail.fits[s]) {
      const Estimate a = over_replicas(fit.exponent), rise = over_replicas(fit.end_slope),
                     bend = over_replicas(fit.bend), gain = over_replicas(fit.against_power);
      text += fmt::format(
          " {} {:.2f} ({:.2f}), local exponent up by {:.1f} ({:.1f}) through the window, stretched exponential with "
          "power {:.2f} ({:.2f}) better by {:.1f} ({:.1f}) in ln L of a replica;",
          window_label(fit.window), a.mean, a.error, rise.mean, rise.error, bend.mean, bend.error, gain.mean,
          gain.error);
    }
    text.back() = '.';
    evidence.notes.push_back(std::move(text));
  }
}

double widest_window() {
  double widest = 0;
  for (const TailWindow window : tail_windows) widest = std::max(widest, window.to);
  return widest;
}

}  // namespace

CentreTail::CentreTail(const SceneValues& scene, Velocity v)
    : nu(scene.scene().area_fraction()),
      restitution(scene.scene().normal_restitution),
      wall(scene.scene().wall_tangential_restitution[0]),
      velocity(v),
      distributions(velocity_distributions(scene, v, scene.half() - 1)) {
  for (const Side& side : tail_sides) fits.push_back(fit_tails(distributions, side.side));
}

std::string CentreTail::label() const {
  return fmt::format("nu {:.2f}, e_n {:.2f}, beta_w {:.1f}", nu, restitution, wall);
}

double CentreTail::reach() const {
  double least = VelocityDistribution::range;
  for (const VelocityDistribution& d : distributions) least = std::min(least, d.reach);
  return least;
}

std::vector<double> CentreTail::over_population() const {
  return per_replica(distributions.size(),
                     [&](std::size_t r) { return distributions[r].beyond(3) / gaussian_beyond_three; });
}

std::vector<CentreTail> centre_tails(const SceneRecords& records, Velocity velocity) {
  std::vector<CentreTail> all;
  for (const SceneValues& scene : by_area_fraction(records)) all.emplace_back(scene, velocity);
  std::sort(all.begin(), all.end(), [](const CentreTail& a, const CentreTail& b) {
    return std::tuple(std::lround(100 * a.nu), -a.wall, -a.restitution) <
           std::tuple(std::lround(100 * b.nu), -b.wall, -b.restitution);
  });
  return all;
}

std::string window_label(TailWindow w) { return fmt::format("{:g}-{:g} sigma", w.from, w.to); }

Plot tail_plot(std::string title) {
  return {.title = std::move(title),
          .xlabel = "u/σ, positive tail",
          .ylabel = "P(u)/P(0)",
          .logx = true,
          .logy = true,
          .xrange = {{1, 8}},
          .yrange = {{1e-5, 1}},
          .series = {gaussian_series()}};
}

void add_tail(Plot& plot, const CentreTail& tail) {
  plot.series.push_back(density_series(
      fmt::format("{}, nu {:.2f}, e_n {:.2f}", name_of(tail.velocity), tail.nu, tail.restitution), tail.distributions));
}

void add_power_law(Plot& plot, double exponent, double level) {
  Series line{.label = fmt::format("slope -{:g}", exponent), .style = SeriesStyle::line};
  for (const double x : {2.0, 3.0, 4.0, 6.0, 8.0})
    line.x.push_back(x), line.y.push_back(level * std::pow(x / 3, -exponent));
  plot.series.push_back(std::move(line));
}

void note_tails(Evidence& evidence, const std::vector<CentreTail>& tails) {
  for (const CentreTail& tail : tails)
    if (tail.reach() >= widest_window())
      note_tail(evidence, tail);
    else
      evidence.notes.push_back(fmt::format("{}, {}: the histogram holds all counts up to {:.1f} sigma only.",
                                           name_of(tail.velocity), tail.label(), tail.reach()));
}

void check_reach(Evidence& evidence, const std::vector<CentreTail>& tails) {
  double reach = VelocityDistribution::range;
  for (const CentreTail& tail : tails) reach = std::min(reach, tail.reach());
  evidence.health.push_back({"the histograms reach beyond the windows", reach >= widest_window(),
                             fmt::format("all counts up to {:.1f} sigma, windows up to {:g}", reach, widest_window())});
}

}  // namespace gpf
