// n1.elastic, n1.dissipation: the first normal stress difference across the channel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/stress_values.hpp"

namespace gpf {
namespace {

/// Bins within 1.8 d of a wall, 1 and 18, are judged apart: contacts with the wall carry P_yy but no P_xx there.
constexpr int first_bulk_bin = 1;

std::vector<double> n1(const SceneValues& scene, int bin) {
  return first_normal_stress_difference(scene, bin, StressPart::both);
}

std::string bins_label(const SceneValues& scene, int bin) {
  return fmt::format("bins {} and {}", bin + 1, scene.bins() - bin);
}

Series profile(const SceneValues& scene, std::string label) {
  Series points{.label = std::move(label)};
  for (int bin = first_bulk_bin; bin < scene.half(); ++bin) add_point(points, scene.centre(bin), n1(scene, bin));
  return points;
}

/// Largest |N_1| over the bins but the wall's, of the means over replicas.
double largest(const SceneValues& scene) {
  double found = 0;
  for (int bin = first_bulk_bin; bin < scene.half(); ++bin)
    found = std::max(found, std::abs(over_replicas(n1(scene, bin)).mean));
  return found;
}

/// |N_1| between rough walls less N_1 between smooth ones|, in a bin.
std::vector<double> wall_effect(const SceneValues& smooth, const SceneValues& rough, int bin) {
  return magnitude(difference(n1(rough, bin), n1(smooth, bin)));
}

const char definition[] =
    "N_1 = (P_xx - P_yy)/p, p = (P_xx + P_yy)/2, P compressive positive (eqs. 4.4, 4.6); kinetic part about the "
    "instantaneous mean of the bin. Bins y and W - y are averaged. The wall's bins are not judged: a wall takes up "
    "P_yy "
    "and no P_xx, so N_1 is -.2 to -.6 there.";

}  // namespace

// Claim n1.elastic (fig. 4.6). |N_1| within tolerance_total() in every bin but the wall's, between smooth and rough
// walls (the rows with the largest and the smallest beta_w). What the wall's roughness changes at the centre: in dilute
// flow (nu up to `dilute`) more than in dense (from `dense` on); in dense flow more in bin 1 than at the centre, where
// it is at most centre_margin.
Evidence estimate_n1_elastic(const Claim& claim, Tier, const SceneRecords& records) {
  const Interval positive{0, INFINITY};
  Evidence evidence;
  evidence.plot = {.title = "First normal stress difference, smooth walls (left) and rough walls (right)",
                   .xlabel = "y/W (right half, mirrored: rough walls)",
                   .ylabel = "N_1",
                   .xrange = {{0, 1}},
                   .series = {{.label = "band",
                               .style = SeriesStyle::band,
                               .x = {0, 1},
                               .y = {0, 0},
                               .lower = std::vector<double>(2, -claim.tolerance_total()),
                               .upper = std::vector<double>(2, claim.tolerance_total())}}};
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  std::vector<const SceneValues*> dilute, dense;  // smooth and rough by turns
  for (const SceneValues* smooth : rows.front().scenes) {
    const double nu = smooth->scene().area_fraction();
    const SceneValues* rough = find_scene(rows.back(), nu);
    if (rough == nullptr) continue;
    for (const SceneValues* scene : {smooth, rough}) {
      for (int bin = first_bulk_bin; bin < scene->half(); ++bin)
        evidence.checks.push_back({.label = fmt::format("{}: N_1 of {}", scene->name(), bins_label(*scene, bin)),
                                   .values = n1(*scene, bin),
                                   .band = band_about(0, claim.tolerance_total()),
                                   .x = scene->centre(bin)});
      Series points = profile(*scene, scene == smooth ? fmt::format("nu {:.3g}", nu) : "");
      if (scene == rough)
        for (double& x : points.x) x = 1 - x;
      evidence.plot.series.push_back(std::move(points));
    }
    if (nu <= claim.parameter("dilute")) dilute.insert(dilute.end(), {smooth, rough});
    if (nu >= claim.parameter("dense")) dense.insert(dense.end(), {smooth, rough});
    const int centre = smooth->half() - 1;
    evidence.notes.push_back(fmt::format(
        "nu {:.3g}: largest |N_1| {:.3f} between smooth, {:.3f} between rough walls; rough less smooth {:.3f} in bin "
        "1, "
        "{:.3f} in bin 2, {:.3f} in bin 5, {:.3f} at the centre.",
        nu, largest(*smooth), largest(*rough), over_replicas(difference(n1(*rough, 0), n1(*smooth, 0))).mean,
        over_replicas(difference(n1(*rough, 1), n1(*smooth, 1))).mean,
        over_replicas(difference(n1(*rough, centre / 2), n1(*smooth, centre / 2))).mean,
        over_replicas(difference(n1(*rough, centre), n1(*smooth, centre))).mean));
  }
  for (std::size_t k = 0; k + 1 < dense.size(); k += 2) {
    const int centre = dense[k]->half() - 1;
    const double nu = dense[k]->scene().area_fraction();
    const std::vector<double> at_centre = wall_effect(*dense[k], *dense[k + 1], centre);
    evidence.checks.push_back({.label = fmt::format("nu {:.3g}: rough less smooth walls, N_1 at the centre", nu),
                               .values = difference(n1(*dense[k + 1], centre), n1(*dense[k], centre)),
                               .band = band_about(0, claim.parameter("centre_margin"))});
    evidence.checks.push_back({.label = fmt::format("nu {:.3g}: |rough less smooth| of N_1, bin 1 less the centre", nu),
                               .values = difference(wall_effect(*dense[k], *dense[k + 1], 0), at_centre),
                               .band = positive});
    for (std::size_t j = 0; j + 1 < dilute.size(); j += 2)
      evidence.checks.push_back(
          {.label = fmt::format("|rough less smooth| of N_1 at the centre, nu {:.3g} less nu {:.3g}",
                                dilute[j]->scene().area_fraction(), nu),
           .values = difference(wall_effect(*dilute[j], *dilute[j + 1], centre), at_centre),
           .band = positive});
  }
  evidence.notes.emplace_back(definition);
  return evidence;
}

// Claim n1.dissipation (fig. 4.7). In each pair of rows that differ in e_n alone: N_1 of bin `bin` and its mirror image
// is larger at the lower e_n, at every nu. Along the row of the lowest e_n, N_1 at the centre is not monotone in nu: it
// rises from nu `low` to `middle`, and falls from there to `high`.
Evidence estimate_n1_dissipation(const Claim& claim, Tier, const SceneRecords& records) {
  const Interval positive{0, INFINITY};
  const int shear_layer = static_cast<int>(claim.parameter("bin")) - 1;
  Evidence evidence;
  evidence.plot = {.title = "First normal stress difference across the channel",
                   .xlabel = "y/W",
                   .ylabel = "N_1",
                   .xrange = {{0, 0.5}}};
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const SceneRow &elastic = rows[k], &inelastic = rows[k + 1];
    if (elastic.wall_restitution != inelastic.wall_restitution) continue;
    for (const SceneValues* scene : inelastic.scenes) {
      const double nu = scene->scene().area_fraction();
      if (k == 0) evidence.plot.series.push_back(profile(*scene, fmt::format("{}, nu {:.3g}", inelastic.label(), nu)));
      const SceneValues* other = find_scene(elastic, nu);
      if (other == nullptr) continue;
      evidence.checks.push_back(
          {.label = fmt::format("{}, nu {:.3g}: N_1 of {} less that at e_n {:.3g}", inelastic.label(), nu,
                                bins_label(*scene, shear_layer), elastic.restitution),
           .values = difference(n1(*scene, shear_layer), n1(*other, shear_layer)),
           .band = positive,
           .x = nu});
      evidence.notes.push_back(fmt::format(
          "{}, nu {:.3g}: largest |N_1| {:.3f}, at e_n {:.3g} {:.3f}; at the centre {:.3f} and {:.3f}.",
          inelastic.label(), nu, largest(*scene), elastic.restitution, largest(*other),
          over_replicas(n1(*scene, scene->half() - 1)).mean, over_replicas(n1(*other, other->half() - 1)).mean));
    }
    const SceneValues* at[3] = {find_scene(inelastic, claim.parameter("low")),
                                find_scene(inelastic, claim.parameter("middle")),
                                find_scene(inelastic, claim.parameter("high"))};
    for (const int end : {0, 2}) {
      if (at[end] == nullptr || at[1] == nullptr) continue;
      evidence.checks.push_back(
          {.label = fmt::format("{}: N_1 at the centre, nu {:.3g} less nu {:.3g}", inelastic.label(),
                                at[1]->scene().area_fraction(), at[end]->scene().area_fraction()),
           .values = difference(n1(*at[1], at[1]->half() - 1), n1(*at[end], at[end]->half() - 1)),
           .band = positive});
    }
  }
  evidence.notes.emplace_back(definition);
  return evidence;
}

}  // namespace gpf
