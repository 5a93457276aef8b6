// kn.density, slip.density, gradient.density, slip.knudsen, gradient.knudsen: power laws across a scan of the area
// fraction at each e_n.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <iterator>

#include "gpf/stats/exponents.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {
namespace {

/// Quantities of derive_quantities; without x the area fraction.
struct Reading {
  const char *name, *x, *y;
};

struct Relation {
  const char *title, *xlabel, *ylabel;
  std::vector<Reading> readings;  ///< the first one is judged, the others are noted
};

/// x and y of each scene in the range of the fit, one value per replica.
struct Points {
  std::vector<std::vector<double>> x, y;
};

std::vector<double> abscissa(const SceneValues& scene, const Reading& reading) {
  return reading.x != nullptr ? scene.of(reading.x)
                              : std::vector<double>(scene.replicas(), area_fraction(scene.scene()));
}

/// The range is one of `judged`'s x, so that all readings fit the same scenes.
Points points_in_range(const std::vector<SceneValues>& scan, const Reading& judged, const Reading& reading,
                       double lowest, double highest) {
  Points points;
  for (const SceneValues& scene : scan) {
    const double mean = over_replicas(abscissa(scene, judged)).mean, rounding = 1e-6;
    if (mean < lowest * (1 - rounding) || mean > highest * (1 + rounding)) continue;
    points.x.push_back(abscissa(scene, reading));
    points.y.push_back(scene.of(reading.y));
  }
  return points;
}

std::string describe(const Exponents& fit) {
  std::string windows;
  for (const FitWindow& window : fit.windows)
    windows += fmt::format("{}{:.3g} over {:.3g}-{:.3g}", windows.empty() ? "" : ", ", window.exponent, window.lowest_x,
                           window.highest_x);
  return fmt::format("exponent {}; windows: {}; slope at the lower end {}, at the upper end {}",
                     with_error(fit.exponent), windows, with_error(fit.low_end), with_error(fit.high_end));
}

void add_checks(Evidence& evidence, const Claim& claim, const std::string& at, const Exponents& fit) {
  const double lowest = claim.parameter("exponent_low"), highest = claim.parameter("exponent_high");
  const double margin = claim.tolerance_total() + fit.half_spread();
  evidence.checks.push_back({.label = fmt::format("{}: exponent", at),
                             .values = fit.exponent,
                             .band = {lowest - margin, highest + margin},
                             .reference = (lowest + highest) / 2});
  const double bend = bend_of_departure(claim.parameter("departure"), fit.lowest_x(), fit.highest_x());
  evidence.checks.push_back({.label = fmt::format("{}: power law (slope at the upper end less that at the lower)", at),
                             .values = fit.bend(),
                             .band = band_about(0, bend)});
}

void add_to_plot(Plot& plot, double restitution, const Points& points, const Exponents& fit) {
  Series measured{.label = fmt::format("e_n {:.2g}", restitution)}, line{.style = SeriesStyle::line};
  double offset = 0;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    const double x = over_replicas(points.x[k]).mean;
    add_point(measured, x, points.y[k]);
    offset +=
        (std::log(measured.y.back()) - fit.windows[0].exponent * std::log(x)) / static_cast<double>(points.x.size());
  }
  for (const double x : {fit.lowest_x(), fit.highest_x()}) {
    line.x.push_back(x);
    line.y.push_back(std::exp(offset) * std::pow(x, fit.windows[0].exponent));
  }
  plot.series.push_back(std::move(measured));
  plot.series.push_back(std::move(line));
}

/// Scenes of the thesis' number of disks, or fewer where the channel would get too long.
bool of_thesis_size(const Scene& scene) { return scene.particles <= 900; }

Evidence power_law_evidence(const Claim& claim, const SceneRecords& records, const Relation& relation) {
  const double lowest = claim.parameter("lowest_x"), highest = claim.parameter("highest_x");
  Evidence evidence;
  evidence.plot = {
      .title = relation.title, .xlabel = relation.xlabel, .ylabel = relation.ylabel, .logx = true, .logy = true};
  const Scans scans = scans_by(normal_restitution, area_fraction, records, of_thesis_size);
  for (auto scan = scans.rbegin(); scan != scans.rend(); ++scan) {
    const double restitution = scan->first;
    const std::string at = fmt::format("e_n {:.2g}", restitution);
    for (const Reading& reading : relation.readings) {
      const Points points = points_in_range(scan->second, relation.readings[0], reading, lowest, highest);
      const Exponents fit = fit_exponents(points.x, points.y);
      const bool judged = &reading == relation.readings.data(),
                 stated = restitution > claim.parameter("lowest_restitution") - 1e-6;
      if (judged && stated) add_checks(evidence, claim, at, fit);
      if (judged) add_to_plot(evidence.plot, restitution, points, fit);
      evidence.notes.push_back(fmt::format("{}, {}{}: {}.", at, reading.name,
                                           judged ? stated ? " (judged)" : " (below the stated e_n)" : "",
                                           describe(fit)));
    }
  }
  evidence.notes.emplace_back(
      "Exponents are slopes of ln y against ln x, every point of equal weight, fitted in each replica; the band is "
      "widened by half the spread of the three windows (all points, without the quarter of largest x, without that of "
      "smallest x). Ends: the third of the points with the smallest and with the largest x. In the plot lines are the "
      "fits over all points.");
  return evidence;
}

}  // namespace

/// Kn = lambda/W against the area fraction (sec. 4.2.2, fig. 4.16): lambda is the mean displacement between successive
/// collisions. Below e_n .8 "non-monotonic": there Kn at nu `rises_to` exceeds that at nu `rises_from`.
Evidence estimate_kn_density(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence = power_law_evidence(
      claim, records,
      {"Knudsen number between rough walls",
       "mean area fraction",
       "Kn",
       {{"laboratory displacement between pair contacts", nullptr, "knudsen_number_lab"},
        {"peculiar path between pair contacts", nullptr, "knudsen_number"},
        {"laboratory path between contacts with disks or walls", nullptr, "knudsen_number_any_contact"}}});
  const Scans scans = scans_by(normal_restitution, area_fraction, records, of_thesis_size);
  const double from = claim.parameter("rises_from"), to = claim.parameter("rises_to");
  for (const auto& [restitution, scan] : scans) {
    if (restitution > claim.parameter("lowest_restitution") - 1e-6) continue;
    const SceneValues *dilute = find_scene(scan, area_fraction, from), *dense = find_scene(scan, area_fraction, to);
    if (dilute == nullptr || dense == nullptr) continue;
    for (const char* quantity : {"knudsen_number_lab", "knudsen_number"})
      evidence.checks.push_back(
          {.label = fmt::format("e_n {:.2g}: {} at nu {:.2g} less that at nu {:.2g}", restitution, quantity, to, from),
           .values = difference(dense->of(quantity), dilute->of(quantity)),
           .band = {0, INFINITY}});
  }
  return evidence;
}

/// U_w/U_0 against the area fraction (fig. 4.21): U_w mean velocity of the bins next to the walls, U_0 of the centre.
Evidence estimate_slip_density(const Claim& claim, Tier, const SceneRecords& records) {
  return power_law_evidence(
      claim, records,
      {"Slip velocity between rough walls", "mean area fraction", "U_w/U_0", {{"slip", nullptr, "slip_velocity"}}});
}

/// (dU/dy)/U_0 at the walls against the area fraction (fig. 4.22), in 1/W.
Evidence estimate_gradient_density(const Claim& claim, Tier, const SceneRecords& records) {
  return power_law_evidence(claim, records,
                            {"Velocity gradient at rough walls",
                             "mean area fraction",
                             "(dU/dy)/U_0, 1/W",
                             {{"(dU/dy)/U_0 between bins 1 and 2", nullptr, "wall_gradient_relative"},
                              {"(dU/dy)/U_0 extrapolated to the wall", nullptr, "wall_gradient_relative_extrapolated"},
                              {"dU/dy between bins 1 and 2", nullptr, "wall_gradient"}}});
}

/// U_w/U_0 against Kn as the area fraction changes (fig. 4.23). Scenes of more disks than the thesis' 900: slip and Kn
/// equal those of 900 disks at the same area fraction within the symbols ("good agreement").
Evidence estimate_slip_knudsen(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence =
      power_law_evidence(claim, records,
                         {"Slip velocity between rough walls",
                          "Kn",
                          "U_w/U_0",
                          {{"Kn from laboratory displacements", "knudsen_number_lab", "slip_velocity"},
                           {"Kn from peculiar paths", "knudsen_number", "slip_velocity"},
                           {"Kn from paths between any contacts", "knudsen_number_any_contact", "slip_velocity"}}});
  const Scans usual = scans_by(normal_restitution, area_fraction, records, of_thesis_size);
  const Scans larger =
      scans_by(normal_restitution, area_fraction, records, [](const Scene& scene) { return !of_thesis_size(scene); });
  for (const auto& [restitution, scan] : larger)
    for (const SceneValues& large : scan) {
      const double nu = area_fraction(large.scene());
      const auto same_e = usual.find(restitution);
      const SceneValues* small = same_e == usual.end() ? nullptr : find_scene(same_e->second, area_fraction, nu);
      if (small == nullptr) continue;
      for (const char* quantity : {"slip_velocity", "knudsen_number_lab"})
        evidence.checks.push_back(
            {.label = fmt::format("e_n {:.2g}, nu {:.2g}: ln of {} with {} disks over that with {}", restitution, nu,
                                  quantity, large.scene().particles, small->scene().particles),
             .values = log_ratio(large.of(quantity), small->of(quantity)),
             .band = band_about(0, claim.parameter("departure"))});
    }
  return evidence;
}

/// (dU/dy)/U_0 at the walls against Kn as the area fraction changes (fig. 4.24), in 1/W.
Evidence estimate_gradient_knudsen(const Claim& claim, Tier, const SceneRecords& records) {
  return power_law_evidence(
      claim, records,
      {"Velocity gradient at rough walls",
       "Kn",
       "(dU/dy)/U_0, 1/W",
       {{"(dU/dy)/U_0 between bins 1 and 2", "knudsen_number_lab", "wall_gradient_relative"},
        {"(dU/dy)/U_0 extrapolated to the wall", "knudsen_number_lab", "wall_gradient_relative_extrapolated"},
        {"(dU/dy)/U_0, Kn from peculiar paths", "knudsen_number", "wall_gradient_relative"},
        {"dU/dy between bins 1 and 2", "knudsen_number_lab", "wall_gradient"}}});
}

}  // namespace gpf
