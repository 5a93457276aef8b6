// kn.dilute, flow.knudsen: what changes from dense to rarefied flow.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {
namespace {

/// ln of the largest over the smallest value among the scenes, in each replica.
std::vector<double> log_range(const std::vector<const SceneValues*>& scenes, std::string_view quantity) {
  std::vector<std::vector<double>> values;
  for (const SceneValues* scene : scenes) values.push_back(scene->of(quantity));
  return per_replica(values.empty() ? 0 : values.front().size(), [&](std::size_t r) {
    double least = INFINITY, most = -INFINITY;
    for (const std::vector<double>& at : values) least = std::min(least, at[r]), most = std::max(most, at[r]);
    return std::log(most / least);
  });
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

/// Q and U_0 against Kn between rough walls (fig. 4.26), in (g W)^(1/2): over the decade of Kn below `edge` they change
/// (ln of largest over smallest) less than half as much as over the decade above, where they fall from one point to the
/// next.
Evidence estimate_flow_knudsen(const Claim& claim, Tier, const SceneRecords& records) {
  const double edge = claim.parameter("edge");
  Evidence evidence;
  evidence.plot = {
      .title = "Mean flow between rough walls", .xlabel = "Kn", .ylabel = "Q, (g W)^(1/2)", .logx = true, .logy = true};
  for (const auto& [restitution, scan] : scans_by(normal_restitution, area_fraction, records, any_scene)) {
    const std::vector<const SceneValues*> dense = between_knudsen(scan, edge / 10, edge),
                                          dilute = between_knudsen(scan, edge, edge * 20),
                                          decade = between_knudsen(scan, edge, edge * 10);
    evidence.plot.series.push_back(over_knudsen(fmt::format("e_n {:.2g}", restitution), scan, "mean_flow"));
    for (const char* quantity : {"mean_flow", "centre_velocity"}) {
      const std::string what =
          fmt::format("e_n {:.2g}, {}", restitution, std::string_view(quantity) == "mean_flow" ? "Q" : "U_0");
      const std::vector<double> below = log_range(dense, quantity), above = log_range(decade, quantity);
      evidence.checks.push_back(
          {.label = fmt::format("{}: change over the decade of Kn below {:.2g} in units of that above", what, edge),
           .values = combined(below, above, [](double a, double b) { return a / b; }),
           .band = {0, 0.5}});
      for (std::size_t k = 1; k < dilute.size(); ++k)
        evidence.checks.push_back({.label = fmt::format("{}: at Kn {:.2g} less that at Kn {:.2g}", what,
                                                        mean_knudsen(*dilute[k - 1]), mean_knudsen(*dilute[k])),
                                   .values = difference(dilute[k - 1]->of(quantity), dilute[k]->of(quantity)),
                                   .band = {-INFINITY, 0},
                                   .x = mean_knudsen(*dilute[k])});
      std::string values;
      for (const SceneValues& scene : scan)
        values += fmt::format(" {:.2g}: {},", mean_knudsen(scene), with_error(scene.of(quantity)));
      evidence.notes.push_back(
          fmt::format("{}: changes by a factor {:.2f} over Kn {:.2g}-{:.2g}, by {:.2f} over {:.2g}-{:.2g}. At Kn{}.",
                      what, std::exp(over_replicas(below).mean), edge / 10, edge, std::exp(over_replicas(above).mean),
                      edge, edge * 10, values));
    }
  }
  return evidence;
}

}  // namespace gpf
