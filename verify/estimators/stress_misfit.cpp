// stress.jr.limit, stress.divergence: where the constitutive relations of nearly elastic disks fail.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/vec2.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/stress_values.hpp"

namespace gpf {
namespace {

/// Root mean squares over the bins from the third to the centre, one value per replica.
struct Misfit {
  std::vector<double> pressure;      ///< of p over Jenkins-Richman's, less 1
  std::vector<double> shear_stress;  ///< of -P_xy less Jenkins-Richman's, over `scale`
  std::vector<double> viscosity;     ///< of mu over Jenkins-Richman's, less 1; the centre pair left out
};

Misfit misfit(const SceneValues& scene, double scale) {
  Misfit found{std::vector<double>(scene.replicas()), std::vector<double>(scene.replicas()),
               std::vector<double>(scene.replicas())};
  const int count = scene.half() - first_bin_with_shear_rate;
  for (int bin = first_bin_with_shear_rate; bin < scene.half(); ++bin) {
    const Rheology of_bin = rheology(scene, bin);
    for (std::size_t r = 0; r < scene.replicas(); ++r) {
      found.pressure[r] += square(of_bin.pressure[r] / of_bin.theory_pressure[r] - 1) / count;
      found.shear_stress[r] += square((of_bin.shear_stress[r] - of_bin.theory_shear_stress[r]) / scale) / count;
      if (bin + 1 < scene.half())
        found.viscosity[r] += square(of_bin.viscosity[r] / of_bin.theory_viscosity[r] - 1) / (count - 1);
    }
  }
  for (std::vector<double>* values : {&found.pressure, &found.shear_stress, &found.viscosity})
    for (double& value : *values) value = std::sqrt(value);
  return found;
}

/// The shear stress that a wall carries, (1/2) nu rho_p g W, of the densest scene: the height of a figure's panel.
double panel_height(const SceneRow& row) { return row.scenes.back()->scene().area_fraction() / 2; }

struct Judged {
  std::vector<double> Misfit::*values;
  const char* name;
};
constexpr Judged judged[] = {{&Misfit::pressure, "misfit of p"}, {&Misfit::shear_stress, "misfit of -P_xy"}};

}  // namespace

// Claim stress.jr.limit (figs. 4.1 to 4.5). In each row (one e_n, one kind of walls) the misfit of every scene at or
// above `dense` exceeds that of the scenes below, but in quasi-elastic rows; and from one e_n to the next lower one
// between the same walls it grows at every nu at or above `dense`. p: relative; -P_xy: in units of what a wall carries
// in the densest scene, as in a panel with all scenes.
Evidence estimate_stress_misfit(const Claim& claim, Tier, const SceneRecords& records) {
  const double dense = claim.parameter("dense"), quasi_elastic = claim.parameter("quasi_elastic");
  const Interval positive{0, INFINITY};
  Evidence evidence;
  evidence.plot = {.title = "Misfit of Jenkins-Richman's shear stress",
                   .xlabel = "mean area fraction",
                   .ylabel = "rms misfit, of a wall's stress at the largest nu"};
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const std::vector<SceneRow> rows = rows_of(scenes);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const SceneRow& row = rows[k];
    Series points{.label = row.label()};
    std::string note = row.label() + ": misfit of p, of -P_xy, and relative one of the viscosity:";
    for (const SceneValues* scene : row.scenes) {
      const double nu = scene->scene().area_fraction();
      const Misfit here = misfit(*scene, panel_height(row));
      add_point(points, nu, here.shear_stress);
      note += fmt::format(" nu {:.3g}: {:.4f}, {:.4f}, {:.3f};", nu, over_replicas(here.pressure).mean,
                          over_replicas(here.shear_stress).mean, over_replicas(here.viscosity).mean);
      if (nu < dense) continue;
      for (const Judged& quantity : judged) {
        for (const SceneValues* other : row.scenes) {
          if (other->scene().area_fraction() >= dense || row.restitution >= quasi_elastic) continue;
          evidence.checks.push_back(
              {.label = fmt::format("{}: {} at nu {:.3g} less that at nu {:.3g}", row.label(), quantity.name, nu,
                                    other->scene().area_fraction()),
               .values = difference(here.*quantity.values, misfit(*other, panel_height(row)).*quantity.values),
               .band = positive,
               .x = nu});
        }
        if (k == 0 || rows[k - 1].wall_restitution != row.wall_restitution) continue;
        const SceneValues* elastic = find_scene(rows[k - 1], nu);
        if (elastic == nullptr) continue;
        evidence.checks.push_back(
            {.label = fmt::format("{}, nu {:.3g}: {} less that at e_n {:.3g}", row.label(), nu, quantity.name,
                                  rows[k - 1].restitution),
             .values = difference(here.*quantity.values, misfit(*elastic, panel_height(rows[k - 1])).*quantity.values),
             .band = positive,
             .x = nu});
      }
    }
    note.back() = '.';
    evidence.notes.push_back(std::move(note));
    evidence.plot.series.push_back(std::move(points));
  }
  evidence.notes.emplace_back(
      "Root mean square over bins 3 to 16 of p over eq. 4.8 less 1, and of -P_xy less eq. 4.12 in units of the stress "
      "that a wall carries in the densest scene of the same e_n (as one sees it in a panel with all scenes).");
  return evidence;
}

// Claim stress.divergence (figs. 4.3c, 4.4c). Between one pair of bins and the next towards the centre, from
// `first_bin` on, the fluidity (dU/dy)/(-P_xy), the inverse of the viscosity, falls; and from there to the centre the
// viscosity grows by more than eq. 4.9 does with the same nu and T: fluidity over Jenkins-Richman's falls too.
Evidence estimate_stress_divergence(const Claim& claim, Tier, const SceneRecords& records) {
  const int first = static_cast<int>(claim.parameter("first_bin")) - 1;
  const Interval positive{0, INFINITY};
  Evidence evidence;
  evidence.plot = {.title = "Viscosity in and around the plug: measured (points) and Jenkins-Richman (lines)",
                   .xlabel = "y/W",
                   .ylabel = "viscosity/(rho_p g^(1/2) W^(3/2))",
                   .logy = true,
                   .xrange = {{0, 0.5}}};
  for (const SceneValues& scene : by_area_fraction(records)) {
    const auto fluidity = [&](int bin) {
      const Rheology found = rheology(scene, bin);
      return per_replica(scene.replicas(), [&](std::size_t r) { return 1 / found.viscosity[r]; });
    };
    const auto over_theory = [&](int bin) {
      const Rheology found = rheology(scene, bin);
      return per_replica(scene.replicas(),
                         [&](std::size_t r) { return found.theory_viscosity[r] / found.viscosity[r]; });
    };
    const int centre = scene.half() - 1;
    for (int bin = first; bin < centre; ++bin)
      evidence.checks.push_back(
          {.label = fmt::format("{}: fluidity of bin {} less that of bin {}", scene.name(), bin + 1, bin + 2),
           .values = difference(fluidity(bin), fluidity(bin + 1)),
           .band = positive,
           .x = scene.centre(bin)});
    evidence.checks.push_back(
        {.label = fmt::format("{}: fluidity over Jenkins-Richman's, bin {} less the centre", scene.name(), first + 1),
         .values = difference(over_theory(first), over_theory(centre)),
         .band = positive,
         .x = 0.5});
    Series points{.label = scene.name()}, line{.style = SeriesStyle::line};
    for (int bin = first_bin_with_shear_rate; bin < scene.half(); ++bin) {
      const Rheology found = rheology(scene, bin);
      add_point(points, scene.centre(bin), found.viscosity);
      line.x.push_back(scene.centre(bin));
      line.y.push_back(over_replicas(found.theory_viscosity).mean);
    }
    evidence.notes.push_back(fmt::format(
        "{}: from bin {} to the centre, where nu is {:.3f}, the viscosity grows {:.3g} times, Jenkins-Richman's {:.3g} "
        "times.",
        scene.name(), first + 1, over_replicas(scene.mirrored("area_fraction", centre)).mean,
        over_replicas(fluidity(first)).mean / over_replicas(fluidity(centre)).mean,
        line.y.back() / line.y[static_cast<std::size_t>(first - first_bin_with_shear_rate)]));
    evidence.plot.series.push_back(std::move(points));
    evidence.plot.series.push_back(std::move(line));
  }
  evidence.notes.emplace_back(
      "Fluidity (dU/dy)/(-P_xy): what vanishes where the viscosity diverges, and what has an error that can be judged "
      "there. A crystal plug has no viscosity; what is measured is how little it is sheared.");
  return evidence;
}

}  // namespace gpf
