// kn.dilute, flow.knudsen: what changes from dense to rarefied flow.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {
namespace {

/// y of each scene, one value per replica: [scene][replica].
using Values = std::vector<std::vector<double>>;

/// Q = (integral of U over y)/(g W^3)^(1/2) (eq. 4.18): the mean of U over the bins, which are equally wide.
std::vector<double> flow_rate(const SceneValues& scene) {
  std::vector<double> rate(scene.replicas());
  for (int bin = 0; bin < scene.bins(); ++bin)
    rate = combined(rate, scene.of("mean_velocity", bin), [&](double sum, double u) { return sum + u / scene.bins(); });
  return rate;
}

/// ln of the largest over the smallest of the values, in each replica that all of them have; NaN where one is.
std::vector<double> log_range(const Values& logarithms) {
  std::vector<double> least = logarithms.front(), most = least;
  for (const std::vector<double>& at : logarithms) {
    least = combined(least, at, [](double a, double b) { return b < a || std::isnan(b) ? b : a; });
    most = combined(most, at, [](double a, double b) { return b > a || std::isnan(b) ? b : a; });
  }
  return difference(most, least);
}

/// ln y of the scenes whose mean Kn lies between `from` and `to`.
Values logarithms_between(const std::vector<SceneValues>& scan, const Values& y, double from, double to) {
  Values logarithms;
  for (std::size_t k = 0; k < scan.size(); ++k) {
    if (mean_knudsen(scan[k]) < from || mean_knudsen(scan[k]) > to) continue;
    logarithms.push_back(y[k]);
    for (double& value : logarithms.back()) value = std::log(value);
  }
  return logarithms;
}

}  // namespace

/// Kn between smooth walls against the area fraction (fig. 3.2, inset), by both definitions of the path: falls from one
/// to the next, and is of order 1 - closer to 1 than to .1 or 10 on a logarithmic scale - in the most dilute flow.
Evidence estimate_kn_dilute(const Claim&, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scan = by_area_fraction(records);
  Evidence evidence;
  evidence.plot = {.title = "Knudsen number between smooth walls",
                   .xlabel = "mean area fraction",
                   .ylabel = "Kn",
                   .logx = true,
                   .logy = true};
  const auto judge = [&](const char* quantity, const char* name) {
    evidence.plot.series.push_back(points_of(name, scan, area_fraction, quantity));
    evidence.checks.push_back({.label = fmt::format("nu {:.3g}: Kn, {}", area_fraction(scan.front().scene()), name),
                               .values = scan.front().of(quantity),
                               .band = {std::sqrt(0.1), std::sqrt(10)},
                               .reference = 1});
    for (std::size_t k = 1; k < scan.size(); ++k)
      evidence.checks.push_back(
          {.label = fmt::format("Kn at nu {:.3g} over that at nu {:.3g}, {}", area_fraction(scan[k].scene()),
                                area_fraction(scan[k - 1].scene()), name),
           .values = log_ratio(scan[k].of(quantity), scan[k - 1].of(quantity)),
           .band = {-INFINITY, 0},
           .x = area_fraction(scan[k].scene())});
    std::string seen;
    for (const SceneValues& scene : scan)
      seen += fmt::format(" nu {:.3g}: {},", area_fraction(scene.scene()), with_error(scene.of(quantity)));
    evidence.notes.push_back(fmt::format("Kn, {}:{} in falling order.", name, seen));
  };
  judge("knudsen_number_lab", "laboratory displacement");
  judge("knudsen_number", "peculiar path");
  return evidence;
}

/// Q and U_0 against Kn between rough walls (fig. 4.26), in (g W)^(1/2). From the lowest Kn up to `edge` they change
/// (ln of largest over smallest) less than half as much as from `edge` over as many decades up; their values at the
/// ends of these ranges are interpolated. Clear of `edge`, by a tenth, they fall from one point to the next.
Evidence estimate_flow_knudsen(const Claim& claim, Tier, const SceneRecords& records) {
  const double edge = claim.parameter("edge");
  Evidence evidence;
  evidence.plot = {
      .title = "Mean flow between rough walls", .xlabel = "Kn", .ylabel = "Q, (g W)^(1/2)", .logx = true, .logy = true};
  for (const auto& [restitution, scan] : scans_by(normal_restitution, area_fraction, records, any_scene)) {
    const Values kn = values_of(scan, "knudsen_number_lab");
    double lowest = edge;
    for (const SceneValues& scene : scan) lowest = std::min(lowest, mean_knudsen(scene));
    const double highest = edge * edge / lowest;
    Values flow_rates;
    for (const SceneValues& scene : scan) flow_rates.push_back(flow_rate(scene));
    for (const bool centre : {false, true}) {
      const Values y = centre ? values_of(scan, "centre_velocity") : flow_rates;
      const std::string what = fmt::format("e_n {:.2g}, {}", restitution, centre ? "U_0" : "Q");
      Values below_edge = logarithms_between(scan, y, 0, edge), above_edge = logarithms_between(scan, y, edge, highest);
      const std::vector<double> at_edge = log_interpolated(kn, y, edge);
      below_edge.push_back(at_edge);
      above_edge.push_back(at_edge);
      above_edge.push_back(log_interpolated(kn, y, highest));
      const std::vector<double> below = log_range(below_edge), above = log_range(above_edge);
      evidence.checks.push_back(
          {.label = fmt::format("{}: change from the lowest Kn to {:.2g} in units of that as far above", what, edge),
           .values = combined(below, above, [](double a, double b) { return a / b; }),
           .band = {0, 0.5}});
      std::string values;
      Series points{.label = fmt::format("e_n {:.2g}", restitution)};
      for (std::size_t k = 0; k < scan.size(); ++k) {
        const double at = mean_knudsen(scan[k]);
        values += fmt::format(" {:.2g}: {},", at, with_error(y[k]));
        add_point(points, at, y[k]);
        if (k == 0 || at < edge * 1.1 || mean_knudsen(scan[k - 1]) > edge * 20) continue;
        evidence.checks.push_back(
            {.label = fmt::format("{}: at nu {:.3g} less that at nu {:.3g}", what, area_fraction(scan[k - 1].scene()),
                                  area_fraction(scan[k].scene())),
             .values = difference(y[k - 1], y[k]),
             .band = {-INFINITY, 0},
             .x = at});
      }
      if (!centre) evidence.plot.series.push_back(std::move(points));
      evidence.notes.push_back(
          fmt::format("{}: changes by a factor {:.2f} over Kn {:.2g}-{:.2g}, by {:.2f} over {:.2g}-{:.2g}. At Kn{}.",
                      what, std::exp(over_replicas(below).mean), lowest, edge, std::exp(over_replicas(above).mean),
                      edge, highest, values));
    }
  }
  return evidence;
}

}  // namespace gpf
