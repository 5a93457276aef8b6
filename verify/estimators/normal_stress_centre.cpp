// n1.reversal, n1.critical, n1.kinetic, n1.collisional, n1.phase: N_1 and its parts at the centre of the channel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/normal_stress_crossing.hpp"

namespace gpf {
namespace {

const Interval positive{0, INFINITY}, negative{-INFINITY, 0};

const char definition[] =
    "N_1 = (P_xx - P_yy)/p in the centre pair of bins, P compressive positive; N_1^k and N_1^c are the shares of the "
    "kinetic and the collisional stress, over the same whole p. Kinetic part about the instantaneous mean of the bin.";

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

Check sign_check(const SceneRow& row, const SceneValues& scene, StressPart part, Interval band) {
  return {.label = fmt::format("{}, nu {:.3g}: {} at the centre is {}", row.label(), scene.scene().area_fraction(),
                               symbol_of(part), band.lo == 0 ? "positive" : "negative"),
          .values = centre_value(scene, part),
          .band = band,
          .x = scene.scene().area_fraction()};
}

/// Positive where nu is at most `positive_to`, negative where it is at least `negative_from`, free between.
void check_signs(const Claim& claim, const SceneRow& row, StressPart part, Evidence& evidence) {
  for (const SceneValues* scene : row.scenes) {
    const double nu = scene->scene().area_fraction();
    if (nu <= claim.parameter("positive_to")) evidence.checks.push_back(sign_check(row, *scene, part, positive));
    if (nu >= claim.parameter("negative_from")) evidence.checks.push_back(sign_check(row, *scene, part, negative));
  }
}

/// Where N_1 and its collisional part change sign, in every reading.
void note_crossings(const SceneRow& row, Evidence& evidence) {
  for (const StressPart part : {StressPart::both, StressPart::collisional})
    for (const Density density : {Density::mean, Density::local})
      evidence.notes.push_back(fmt::format("{}: {} changes sign at {}.", row.label(), symbol_of(part),
                                           text_of(sign_change(row, part, density), density)));
  evidence.notes.push_back(
      fmt::format("{}: about the long-time mean flow N_1 changes sign at {}.", row.label(),
                  text_of(sign_change(row, StressPart::both, Density::mean, MeanFlow::long_time), Density::mean)));
}

}  // namespace

// Claim n1.reversal (figs. 4.7, 4.8): in every row N_1 at the centre is positive up to nu `positive_to` and negative
// from nu `negative_from` on.
Evidence estimate_n1_reversal(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  Evidence evidence;
  evidence.plot = centre_plot(rows, StressPart::both, Density::mean);
  for (const SceneRow& row : rows) {
    check_signs(claim, row, StressPart::both, evidence);
    note_crossings(row, evidence);
  }
  evidence.notes.emplace_back(definition);
  return evidence;
}

// Claim n1.critical (figs. 4.8, 4.13): between the same walls, the density at which N_1 changes sign is higher in the
// row of the next lower e_n; as mean area fraction and as that of the centre bins.
Evidence estimate_n1_critical(const Claim&, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  Evidence evidence;
  evidence.plot = centre_plot(rows, StressPart::both, Density::local);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    note_crossings(rows[k], evidence);
    if (k == 0 || rows[k - 1].wall_restitution != rows[k].wall_restitution) continue;
    for (const Density density : {Density::mean, Density::local})
      evidence.checks.push_back({.label = fmt::format("{}: {} where N_1 changes sign, less that at e_n {:.3g}",
                                                      rows[k].label(), name_of(density), rows[k - 1].restitution),
                                 .values = difference(sign_change(rows[k], StressPart::both, density).densities,
                                                      sign_change(rows[k - 1], StressPart::both, density).densities),
                                 .band = positive});
  }
  evidence.notes.emplace_back(definition);
  return evidence;
}

// Claim n1.kinetic (figs. 4.10a, 4.11a): from nu `dense` on, N_1^k at the centre lies within tolerance_total() about 0;
// at the largest nu below `dense_start` it is larger than at any of these.
Evidence estimate_n1_kinetic(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  Evidence evidence;
  evidence.plot = centre_plot(rows, StressPart::kinetic, Density::mean);
  const Interval band = band_about(0, claim.tolerance_total());
  for (const SceneRow& row : rows) {
    std::string note = row.label() + ", N_1^k (about the long-time mean):";
    for (const SceneValues* scene : row.scenes) {
      const double nu = scene->scene().area_fraction();
      const std::vector<double> values = centre_value(*scene, StressPart::kinetic);
      note += fmt::format(" nu {:.3g} {:.4f} ({:.4f}),", nu, over_replicas(values).mean,
                          over_replicas(centre_value(*scene, StressPart::kinetic, MeanFlow::long_time)).mean);
      if (nu >= claim.parameter("dense"))
        evidence.checks.push_back({.label = fmt::format("{}, nu {:.3g}: N_1^k at the centre", row.label(), nu),
                                   .values = values,
                                   .band = band,
                                   .x = nu});
      if (nu <= claim.parameter("moderate"))
        evidence.checks.push_back({.label = fmt::format("{}, nu {:.3g}: N_1^k at the centre", row.label(), nu),
                                   .values = values,
                                   .band = {band.hi, INFINITY},
                                   .x = nu});
    }
    note.back() = '.';
    evidence.notes.push_back(std::move(note));
  }
  evidence.notes.emplace_back(definition);
  return evidence;
}

// Claim n1.collisional (figs. 4.10b, 4.11b, 4.12). In the rows at or below e_n `inelastic`: N_1^c at the centre is
// positive up to nu `positive_to`, negative from nu `negative_from` on, and there larger in size than N_1^k from nu
// `dense` on. In the rows above: negative from nu `weak_from` on, within weak_size of 0 up to nu `weak_to`, and more
// negative at the largest nu than at any of these.
Evidence estimate_n1_collisional(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  Evidence evidence;
  evidence.plot = centre_plot(rows, StressPart::collisional, Density::mean);
  for (const SceneRow& row : rows) {
    note_crossings(row, evidence);
    if (row.restitution <= claim.parameter("inelastic")) {
      check_signs(claim, row, StressPart::collisional, evidence);
      for (const SceneValues* scene : row.scenes)
        if (scene->scene().area_fraction() >= claim.parameter("dense"))
          evidence.checks.push_back(
              {.label = fmt::format("{}, nu {:.3g}: |N_1^c| less |N_1^k|", row.label(), scene->scene().area_fraction()),
               .values = difference(magnitude(centre_value(*scene, StressPart::collisional)),
                                    magnitude(centre_value(*scene, StressPart::kinetic))),
               .band = positive});
      continue;
    }
    const SceneValues& densest = *row.scenes.back();
    for (const SceneValues* scene : row.scenes) {
      const double nu = scene->scene().area_fraction();
      if (nu < claim.parameter("weak_from") || nu > claim.parameter("weak_to")) continue;
      evidence.checks.push_back({.label = fmt::format("{}, nu {:.3g}: N_1^c slightly negative", row.label(), nu),
                                 .values = centre_value(*scene, StressPart::collisional),
                                 .band = {-claim.parameter("weak_size"), 0},
                                 .x = nu});
      evidence.checks.push_back({.label = fmt::format("{}: N_1^c at nu {:.3g} less that at nu {:.3g}", row.label(),
                                                      densest.scene().area_fraction(), nu),
                                 .values = difference(centre_value(densest, StressPart::collisional),
                                                      centre_value(*scene, StressPart::collisional)),
                                 .band = negative});
    }
  }
  evidence.notes.emplace_back(definition);
  return evidence;
}

// Claim n1.phase (fig. 4.13): the density where N_1 changes sign less that where N_1^c does, the gap. In rows at or
// above e_n `elastic` it is positive; and it is larger there than in the row of the lowest e_n between the same walls,
// where the two coincide within `coincidence`.
Evidence estimate_n1_phase(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  const auto gap = [](const SceneRow& row, Density density) {
    return difference(sign_change(row, StressPart::both, density).densities,
                      sign_change(row, StressPart::collisional, density).densities);
  };
  Evidence evidence;
  evidence.plot = {.title = "Zero lines at the centre", .xlabel = "e_n", .ylabel = "area fraction"};
  for (const Density density : {Density::mean, Density::local})
    for (const StressPart part : {StressPart::both, StressPart::collisional}) {
      Series points{.label = fmt::format("{} = 0, {}", symbol_of(part), name_of(density))};
      for (const SceneRow& row : rows) add_point(points, row.restitution, sign_change(row, part, density).densities);
      evidence.plot.series.push_back(std::move(points));
    }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    note_crossings(rows[k], evidence);
    for (const Density density : {Density::mean, Density::local}) {
      const std::string label =
          fmt::format("{}: {} of N_1 = 0 less that of N_1^c = 0", rows[k].label(), name_of(density));
      if (rows[k].restitution >= claim.parameter("elastic"))
        evidence.checks.push_back({.label = label, .values = gap(rows[k], density), .band = positive});
      else
        evidence.checks.push_back(
            {.label = label, .values = gap(rows[k], density), .band = band_about(0, claim.parameter("coincidence"))});
    }
  }
  evidence.notes.emplace_back(definition);
  return evidence;
}

}  // namespace gpf
