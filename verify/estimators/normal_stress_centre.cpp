// n1.reversal, n1.dilute, n1.kinetic, n1.collisional: N_1 and its parts at the centre of the channel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/normal_stress_crossing.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {
namespace {

const Interval positive{0, INFINITY}, negative{-INFINITY, 0};

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
    append(evidence.notes, crossing_notes(row));
  }
  evidence.notes.emplace_back(centre_definition);
  return evidence;
}

// Claim n1.dilute (fig. 4.8, ch. 6): in every row N_1 at the centre rises from one nu to the next, up to nu `maximum`;
// at the lowest nu it is less than half as large as there.
Evidence estimate_n1_dilute(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  Evidence evidence;
  evidence.plot = centre_plot(rows, StressPart::both, Density::mean);
  evidence.plot.logx = true;
  for (const SceneRow& row : rows) {
    std::string note = row.label() + ", N_1 (its kinetic part) at Kn:";
    for (std::size_t k = 0; k < row.scenes.size(); ++k) {
      const SceneValues& scene = *row.scenes[k];
      const std::vector<double> values = centre_value(scene, StressPart::both);
      note += fmt::format(" {:.2g} {:.3f} ({:.3f}),", over_replicas(scene.of("knudsen_number_lab")).mean,
                          over_replicas(values).mean, over_replicas(centre_value(scene, StressPart::kinetic)).mean);
      const double nu = scene.scene().area_fraction();
      if (k == 0 || nu > claim.parameter("maximum") + 1e-6) continue;
      evidence.checks.push_back({.label = fmt::format("{}: N_1 at the centre, nu {:.3g} less nu {:.3g}", row.label(),
                                                      nu, row.scenes[k - 1]->scene().area_fraction()),
                                 .values = difference(values, centre_value(*row.scenes[k - 1], StressPart::both)),
                                 .band = positive,
                                 .x = nu});
    }
    if (const SceneValues* most = find_scene(row, claim.parameter("maximum"))) {
      const double nu = row.scenes.front()->scene().area_fraction();
      evidence.checks.push_back(
          {.label = fmt::format("{}: |N_1| at the centre, nu {:.3g}, less half of that at nu {:.3g}", row.label(), nu,
                                claim.parameter("maximum")),
           .values = combined(magnitude(centre_value(*row.scenes.front(), StressPart::both)),
                              centre_value(*most, StressPart::both),
                              [](double dilute, double largest) { return dilute - largest / 2; }),
           .band = negative,
           .x = nu});
    }
    note.back() = '.';
    evidence.notes.push_back(std::move(note));
  }
  evidence.notes.emplace_back(centre_definition);
  return evidence;
}

// Claim n1.kinetic (figs. 4.10a, 4.11a): from nu `dense` on, N_1^k at the centre lies within tolerance_total() about 0;
// at the largest nu up to `moderate` it is larger than at any of these.
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
  evidence.notes.emplace_back(centre_definition);
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
    append(evidence.notes, crossing_notes(row));
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
  evidence.notes.emplace_back(centre_definition);
  return evidence;
}

}  // namespace gpf
