// stress.jr.*, stress.enskog: pressure, shear stress and viscosity of each bin against constitutive relations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/stress_values.hpp"

namespace gpf {
namespace {

/// (a - b)/scale, replica by replica.
std::vector<double> deviation(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  return per_replica(a.size(), [&](std::size_t r) { return (a[r] - b[r]) / scale; });
}
std::vector<double> relative_deviation(const std::vector<double>& a, const std::vector<double>& b) {
  return per_replica(a.size(), [&](std::size_t r) { return a[r] / b[r] - 1; });
}

std::string bins_label(const SceneValues& scene, int bin) {
  return fmt::format("nu {:.3g}, beta_w {:.3g}, bins {} and {}", scene.scene().area_fraction(),
                     scene.scene().wall_tangential_restitution[0], bin + 1, scene.bins() - bin);
}

/// Measured viscosities as points, theory as a line.
void plot_viscosity(const SceneValues& scene, Constitutive theory, Plot& plot) {
  Series points{.label = fmt::format("nu {:.3g}, beta_w {:.3g}", scene.scene().area_fraction(),
                                     scene.scene().wall_tangential_restitution[0])};
  Series line{.style = SeriesStyle::line};
  for (int bin = first_bin_with_shear_rate; bin < scene.half(); ++bin) {
    const Rheology found = rheology(scene, bin, theory);
    add_point(points, scene.centre(bin), found.viscosity);
    line.x.push_back(scene.centre(bin));
    line.y.push_back(over_replicas(found.theory_viscosity).mean);
  }
  plot.series.push_back(std::move(points));
  plot.series.push_back(std::move(line));
}

Plot viscosity_plot(const char* theory) {
  return {.title = fmt::format("Viscosity: measured (points) and {} (lines)", theory),
          .xlabel = "y/W",
          .ylabel = "viscosity/(rho_p g^(1/2) W^(3/2))",
          .logy = true,
          .xrange = {{0, 0.5}}};
}

/// The ratios of a scene to the theory, for the page: next to the wall, where no local theory holds, and beyond.
std::string ratios(const SceneValues& scene, Constitutive theory) {
  double extreme[2][2] = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}}, pressure[2] = {INFINITY, -INFINITY};
  const BinRange bulk = bulk_bins(scene);
  for (int bin = first_bin_with_shear_rate; bin < scene.half(); ++bin) {
    const Rheology found = rheology(scene, bin, theory);
    const double ratio = over_replicas(found.viscosity).mean / over_replicas(found.theory_viscosity).mean;
    double(&range)[2] = extreme[bin >= bulk.first];
    range[0] = std::min(range[0], ratio);
    range[1] = std::max(range[1], ratio);
    const double p = over_replicas(found.pressure).mean / over_replicas(found.theory_pressure).mean;
    pressure[0] = std::min(pressure[0], p);
    pressure[1] = std::max(pressure[1], p);
  }
  std::string text = fmt::format(
      "{}: measured over theory: pressure {:.3f} to {:.3f} (from bin {} on), viscosity {:.3f} to {:.3f} (from bin {} "
      "on)",
      scene.name(), pressure[0], pressure[1], first_bin_with_shear_rate + 1, extreme[1][0], extreme[1][1],
      bulk.first + 1);
  if (std::isfinite(extreme[0][0]))
    text += fmt::format(", and {:.3f} to {:.3f} within a mean free path of the wall", extreme[0][0], extreme[0][1]);
  return text + ".";
}

const char definitions[] =
    "p = (P_xx + P_yy)/2; shear stress -P_xy, for the lower half; viscosity = -P_xy/(dU/dy), dU/dy the slope of a "
    "parabola through U of the bin and two neighbours on each side (one in bin 3). Bins y and W - y are averaged. "
    "Theory takes nu, T and dU/dy of each bin as measured. Bins 1 and 2 are left out: disks are layered there.";

}  // namespace

// Claims stress.jr.smooth and .rough (figs. 4.1, 4.2). p of each bin relative to that of eq. 4.8, tolerance_total()
// wide; -P_xy and mu less those of eqs. 4.12 and 4.9 in units of the largest theoretical value of the figure's panel
// (all scenes together), shear_margin and viscosity_margin wide: that is what three curves in one panel show. Bins:
// those of bulk_bins() for shear and viscosity, all from the third on for p. The
// viscosity of the centre pair, a ratio of numbers that vanish there, is only drawn.
Evidence estimate_stress_theory(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = viscosity_plot("Jenkins-Richman");
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  double shear_scale = 0, viscosity_scale = 0;
  for (const SceneValues& scene : scenes)
    for (int bin = bulk_bins(scene).first; bin < scene.half(); ++bin) {
      const Rheology found = rheology(scene, bin);
      shear_scale = std::max(shear_scale, over_replicas(found.theory_shear_stress).mean);
      viscosity_scale = std::max(viscosity_scale, over_replicas(found.theory_viscosity).mean);
    }
  for (const SceneValues& scene : scenes) {
    const int bulk = bulk_bins(scene).first;
    for (int bin = first_bin_with_shear_rate; bin < scene.half(); ++bin) {
      const Rheology found = rheology(scene, bin);
      const auto check = [&](const char* what, std::vector<double> values, double half_width) {
        evidence.checks.push_back({.label = fmt::format("{}: {}", bins_label(scene, bin), what),
                                   .values = std::move(values),
                                   .band = band_about(0, half_width),
                                   .x = scene.centre(bin)});
      };
      check("p over Jenkins-Richman, less 1", relative_deviation(found.pressure, found.theory_pressure),
            claim.tolerance_total());
      if (bin < bulk) continue;
      check("-P_xy less Jenkins-Richman, over the panel's largest",
            deviation(found.shear_stress, found.theory_shear_stress, shear_scale), claim.parameter("shear_margin"));
      if (bin + 1 == scene.half()) continue;
      check("viscosity less Jenkins-Richman, over the panel's largest",
            deviation(found.viscosity, found.theory_viscosity, viscosity_scale), claim.parameter("viscosity_margin"));
    }
    plot_viscosity(scene, Constitutive::jenkins_richman, evidence.plot);
    evidence.notes.push_back(ratios(scene, Constitutive::jenkins_richman));
  }
  evidence.notes.push_back(
      fmt::format("Panel: largest shear stress {:.3g} rho_p g W, largest viscosity {:.3g} rho_p g^(1/2) W^(3/2).",
                  shear_scale, viscosity_scale));
  evidence.notes.emplace_back(definitions);
  return evidence;
}

// Claim stress.enskog, beyond the thesis: p and viscosity of each bin of bulk_bins() relative to Enskog theory with
// restitution (Garzo & Dufty), tolerance_total() wide for p and viscosity_margin for the viscosity.
Evidence estimate_stress_enskog(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = viscosity_plot("Enskog theory with restitution");
  for (const SceneValues& scene : by_area_fraction(records)) {
    for (int bin = bulk_bins(scene).first; bin < scene.half(); ++bin) {
      const Rheology found = rheology(scene, bin, Constitutive::garzo_dufty);
      const auto check = [&](const char* what, const std::vector<double>& measured, const std::vector<double>& theory,
                             double half_width) {
        evidence.checks.push_back({.label = fmt::format("{}: {} over theory, less 1", bins_label(scene, bin), what),
                                   .values = relative_deviation(measured, theory),
                                   .band = band_about(0, half_width),
                                   .x = scene.centre(bin)});
      };
      check("p", found.pressure, found.theory_pressure, claim.tolerance_total());
      if (bin + 1 < scene.half())
        check("viscosity", found.viscosity, found.theory_viscosity, claim.parameter("viscosity_margin"));
    }
    plot_viscosity(scene, Constitutive::garzo_dufty, evidence.plot);
    evidence.notes.push_back(ratios(scene, Constitutive::garzo_dufty));
  }
  evidence.notes.emplace_back(definitions);
  return evidence;
}

// Claim stress.size (sec. 4.1.1). The scene with more disks less the one with fewer, bin by bin from the third on: p
// relative, -P_xy in units of what a wall carries, both tolerance_total() wide; viscosity relative, viscosity_margin
// wide (not in the centre pair); N_1, normal_stress_margin wide.
Evidence estimate_stress_size(const Claim& claim, Tier, const SceneRecords& records) {
  std::vector<SceneValues> scenes = by_area_fraction(records);
  std::stable_sort(scenes.begin(), scenes.end(), [](const SceneValues& a, const SceneValues& b) {
    return a.scene().particles < b.scene().particles;
  });
  const SceneValues &small = scenes.front(), &large = scenes.back();
  const double wall = small.scene().area_fraction() / 2;
  Evidence evidence;
  evidence.plot = viscosity_plot("Jenkins-Richman");
  for (int bin = first_bin_with_shear_rate; bin < small.half(); ++bin) {
    const Rheology few = rheology(small, bin), many = rheology(large, bin);
    const auto check = [&](const char* what, std::vector<double> values, double half_width) {
      evidence.checks.push_back({.label = fmt::format("{}: {}, {} disks less {}", bins_label(small, bin), what,
                                                      large.scene().particles, small.scene().particles),
                                 .values = std::move(values),
                                 .band = band_about(0, half_width),
                                 .x = small.centre(bin)});
    };
    const std::size_t replicas = std::min(small.replicas(), large.replicas());
    const auto relative = [&](const std::vector<double>& a, const std::vector<double>& b) {
      return per_replica(replicas, [&](std::size_t r) { return a[r] / b[r] - 1; });
    };
    check("p, relative", relative(many.pressure, few.pressure), claim.tolerance_total());
    check("-P_xy over a wall's",
          per_replica(replicas, [&](std::size_t r) { return (many.shear_stress[r] - few.shear_stress[r]) / wall; }),
          claim.tolerance_total());
    check("N_1",
          difference(first_normal_stress_difference(large, bin, StressPart::both),
                     first_normal_stress_difference(small, bin, StressPart::both)),
          claim.parameter("normal_stress_margin"));
    if (bin + 1 < small.half())
      check("viscosity, relative", relative(many.viscosity, few.viscosity), claim.parameter("viscosity_margin"));
  }
  for (const SceneValues* scene : {&small, &large}) {
    plot_viscosity(*scene, Constitutive::jenkins_richman, evidence.plot);
    evidence.plot.series[evidence.plot.series.size() - 2].label = fmt::format("{} disks", scene->scene().particles);
  }
  evidence.notes.emplace_back(definitions);
  return evidence;
}

}  // namespace gpf
