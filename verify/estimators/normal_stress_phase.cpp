// n1.critical, n1.phase: the densities at which N_1 and its collisional part change sign at the centre of the channel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/normal_stress_crossing.hpp"

namespace gpf {

// Claim n1.critical (figs. 4.8, 4.13): between the same walls, N_1 is still positive in the row of the next lower e_n
// where it is negative already in the other: the last scene before the change of sign in the one is no less dense than
// the first after it in the other; by mean area fraction and by that of the centre bins. The other way round it fails;
// where the densities overlap between which either changes its sign, nothing is decided.
Evidence estimate_n1_critical(const Claim&, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  Evidence evidence;
  evidence.plot = centre_plot(rows, StressPart::both, Density::local);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    append(evidence.notes, crossing_notes(rows[k]));
    if (k == 0 || rows[k - 1].wall_restitution != rows[k].wall_restitution) continue;
    const SignChange inelastic = sign_change(rows[k], StressPart::both, Density::mean),
                     elastic = sign_change(rows[k - 1], StressPart::both, Density::mean);
    const auto order = [&](const SceneValues* at_lower, const SceneValues* at_higher, Density density) {
      return difference(density_of(*at_lower, density), density_of(*at_higher, density));
    };
    for (const Density density : {Density::mean, Density::local}) {
      std::vector<double> later;
      if (inelastic.found() && elastic.found()) {
        later = order(inelastic.below, elastic.above, density);
        if (over_replicas(later).mean < 0) {
          later = order(inelastic.above, elastic.below, density);
          if (over_replicas(later).mean > 0) later.clear();
        }
      }
      evidence.checks.push_back({.label = fmt::format("{}: {} where N_1 has a certain sign, less that at e_n {:.3g}",
                                                      rows[k].label(), name_of(density), rows[k - 1].restitution),
                                 .values = std::move(later),
                                 .band = {0, INFINITY},
                                 .exact = density == Density::mean});
    }
  }
  evidence.notes.emplace_back(centre_definition);
  return evidence;
}

// Claims n1.phase, n1.phase.rough (fig. 4.13): the density where N_1 changes sign less that where N_1^c does, the gap.
// Within `coincidence` of zero in rows below e_n `elastic`, and beyond it, to the positive side, in the others. The
// densities between which either sign may change overlap by no more than `coincidence`; else the gap has no values, and
// nothing is decided.
Evidence estimate_n1_phase(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  const double coincidence = claim.parameter("coincidence");
  const auto gap = [&](const SceneRow& row, Density density) {
    const SignChange whole = sign_change(row, StressPart::both, density),
                     collisional = sign_change(row, StressPart::collisional, density);
    if (!whole.found() || !collisional.found()) return std::vector<double>{};
    const auto at = [&](const SceneValues* scene) { return over_replicas(density_of(*scene, density)).mean; };
    const double overlap =
        std::min(at(whole.above), at(collisional.above)) - std::max(at(whole.below), at(collisional.below));
    if (overlap > coincidence) return std::vector<double>{};
    return difference(whole.densities, collisional.densities);
  };
  Evidence evidence;
  evidence.plot = {.title = "Zero lines at the centre", .xlabel = "e_n", .ylabel = "area fraction"};
  for (const Density density : {Density::mean, Density::local})
    for (const StressPart part : {StressPart::both, StressPart::collisional}) {
      Series points{.label = fmt::format("{} = 0, {}", symbol_of(part), name_of(density))};
      for (const SceneRow& row : rows) add_point(points, row.restitution, sign_change(row, part, density).densities);
      evidence.plot.series.push_back(std::move(points));
    }
  for (const SceneRow& row : rows) {
    append(evidence.notes, crossing_notes(row));
    for (const Density density : {Density::mean, Density::local}) {
      const std::string label = fmt::format("{}: {} of N_1 = 0 less that of N_1^c = 0", row.label(), name_of(density));
      if (row.restitution >= claim.parameter("elastic"))
        evidence.checks.push_back({.label = label, .values = gap(row, density), .band = {coincidence, INFINITY}});
      else
        evidence.checks.push_back({.label = label, .values = gap(row, density), .band = band_about(0, coincidence)});
    }
  }
  evidence.notes.emplace_back(centre_definition);
  return evidence;
}

}  // namespace gpf
