// fields.smooth: how strongly U, T and the area fraction vary across the channel, against the mean area fraction.
#include <fmt/format.h>

#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {
namespace {

/// Variations across half a channel, one value per replica: centre less edge, in units of the thermal velocity, of the
/// mean temperature (here edge less centre) and of the mean area fraction.
struct Variations {
  std::vector<double> velocity, temperature, density;
  std::vector<double> plain_velocity, relative_velocity;  // other readings: in (g W)^(1/2), and over the mean flow
};

Variations variations(const SceneValues& scene, int edge) {
  const int centre = scene.half() - 1;
  const auto bins = static_cast<double>(scene.bins());
  const auto difference = [&](std::string_view quantity) {
    std::vector<double> a = scene.mirrored(quantity, centre);
    const std::vector<double> b = scene.mirrored(quantity, edge);
    for (std::size_t r = 0; r < a.size(); ++r) a[r] -= b[r];
    return a;
  };
  // Means over the disks.
  std::vector<double> temperature(scene.replicas(), 0.0), density(scene.replicas(), 0.0);
  for (int bin = 0; bin < scene.bins(); ++bin) {
    const std::vector<double> t = scene.of("granular_temperature", bin), nu = scene.of("area_fraction", bin);
    for (std::size_t r = 0; r < t.size(); ++r) temperature[r] += nu[r] * t[r], density[r] += nu[r];
  }
  Variations v;
  v.plain_velocity = difference("mean_velocity");
  const std::vector<double> dt = difference("granular_temperature"), dnu = difference("area_fraction"),
                            flow = scene.of("mean_flow");
  for (std::size_t r = 0; r < scene.replicas(); ++r) {
    const double mean_temperature = temperature[r] / density[r];
    v.velocity.push_back(v.plain_velocity[r] / std::sqrt(mean_temperature));
    v.relative_velocity.push_back(v.plain_velocity[r] / flow[r]);
    v.temperature.push_back(-dt[r] / mean_temperature);
    v.density.push_back(dnu[r] * bins / density[r]);
  }
  return v;
}

struct Field {
  std::vector<double> Variations::*values;
  const char *symbol, *label;
};
constexpr Field fields[] = {{&Variations::velocity, "U", "U, over the thermal velocity"},
                            {&Variations::temperature, "T", "T, over its mean"},
                            {&Variations::density, "nu", "area fraction, over its mean"}};

}  // namespace

Evidence estimate_smooth_fields(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  const int edge = static_cast<int>(claim.parameter("edge_bin")) - 1;
  std::vector<Variations> all;
  for (const SceneValues& scene : scenes) all.push_back(variations(scene, edge));

  Evidence evidence;
  const Interval positive{0, INFINITY};
  for (const Field& field : fields) {
    Series points{.label = field.label};
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      const double nu = scenes[k].scene().area_fraction();
      add_point(points, nu, all[k].*field.values);
      if (k > 0)
        evidence.checks.push_back({.label = fmt::format("{}: variation at nu {:.3g} less that at nu {:.3g}",
                                                        field.symbol, nu, scenes[k - 1].scene().area_fraction()),
                                   .values = difference(all[k].*field.values, all[k - 1].*field.values),
                                   .band = positive,
                                   .x = nu});
      if (field.values != &Variations::velocity)
        evidence.checks.push_back({.label = fmt::format("nu {:.3g}: variation of U less that of {}", nu, field.symbol),
                                   .values = difference(all[k].velocity, all[k].*field.values),
                                   .band = positive,
                                   .x = nu});
    }
    evidence.plot.series.push_back(std::move(points));
  }
  evidence.plot.title = "Variation across half the channel";
  evidence.plot.xlabel = "mean area fraction";
  evidence.plot.ylabel = "difference of centre and edge";
  evidence.plot.logx = true;

  evidence.notes.push_back(fmt::format(
      "Variation: bins {} and {} at the centre against bins {} and {} at the edge (bin 1 is not used: centres reach "
      "only "
      "71 % of it, and disks are layered there). U in units of the thermal velocity T^(1/2), which does not depend on "
      "the frame; T and the area fraction over their means.",
      scenes.front().half(), scenes.front().bins() + 1 - scenes.front().half(), edge + 1,
      scenes.front().bins() - edge));
  for (std::size_t k = 0; k < scenes.size(); ++k)
    evidence.notes.push_back(fmt::format(
        "nu {:.3g}: U differs by {:.3f} (g W)^(1/2), which is {:.3f} of the mean flow; T by {:.3f} of its mean.",
        scenes[k].scene().area_fraction(), over_replicas(all[k].plain_velocity).mean,
        over_replicas(all[k].relative_velocity).mean, over_replicas(all[k].temperature).mean));
  return evidence;
}

}  // namespace gpf
