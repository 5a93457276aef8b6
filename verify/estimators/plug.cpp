// plug.forms, plug.density, fields.dense: the plug that dissipation makes, and the layers that shear beside it (thesis
// figs. 3.15, 3.21).
#include <fmt/format.h>

#include <cmath>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {
namespace {

constexpr Interval positive{0, INFINITY}, negative{-INFINITY, 0};

struct Field {
  const char *quantity, *symbol;
};
constexpr Field fields[] = {{"mean_velocity", "U"}, {"granular_temperature", "T"}, {"area_fraction", "nu"}};

/// Bins that a gradient is taken between, from 0.
struct Stretch {
  int from, to;
  [[nodiscard]] double length() const { return to - from; }
};

/// Size of the mean gradient over the stretch, per bin; one value per replica.
std::vector<double> gradient(const SceneValues& scene, const Field& field, Stretch stretch) {
  std::vector<double> change =
      difference(scene.mirrored(field.quantity, stretch.to), scene.mirrored(field.quantity, stretch.from));
  for (double& value : change) value = std::abs(value) / stretch.length();
  return change;
}

/// Gradient in the plug over that in the shear layer.
std::vector<double> flatness(const SceneValues& scene, const Field& field, Stretch plug, Stretch shear) {
  std::vector<double> ratio = gradient(scene, field, plug);
  const std::vector<double> steep = gradient(scene, field, shear);
  for (std::size_t r = 0; r < ratio.size(); ++r) ratio[r] /= steep[r];
  return ratio;
}

/// The same ratio of a parabola about the centre plane: the profile of U without a plug.
double flatness_of_parabola(int bins, Stretch plug, Stretch shear) {
  const auto value = [&](int bin) { return std::pow(bin + 0.5 - 0.5 * bins, 2); };
  const auto slope = [&](Stretch s) { return (value(s.from) - value(s.to)) / s.length(); };
  return slope(plug) / slope(shear);
}

/// Part of the velocity difference between bin 1 and the centre that is found within the `bins` steps next to bin 1.
std::vector<double> share_beside_wall(const SceneValues& scene, int bins) {
  const std::vector<double> wall = scene.mirrored("mean_velocity", 0), edge = scene.mirrored("mean_velocity", bins),
                            centre = scene.mirrored("mean_velocity", scene.half() - 1);
  return per_replica(wall.size(), [&](std::size_t r) { return (edge[r] - wall[r]) / (centre[r] - wall[r]); });
}

}  // namespace

// plug.forms. Ratio for U, T and nu: mean gradient between `plug_from` and the centre over that between `shear_from`
// and `shear_to`. It is smaller at the lowest e_n than at the highest, for U smaller than that of a parabola, the
// profile without a plug; and the gradient in the shear layer itself (per bin; U in (g W)^(1/2), T in g W) is steeper.
Evidence estimate_plug_forms(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_restitution(records);
  const SceneValues &elastic = scenes.front(), &last = scenes.back();
  const Stretch plug{bin_parameter(claim, "plug_from", last), last.half() - 1},
      shear{bin_parameter(claim, "shear_from", last), bin_parameter(claim, "shear_to", last)};
  const double parabola = flatness_of_parabola(last.bins(), plug, shear);
  const double lowest = last.scene().normal_restitution, highest = elastic.scene().normal_restitution;
  Evidence evidence;
  evidence.plot = {
      .title = "Gradient in the plug over gradient in the shear layer",
      .xlabel = "e_n",
      .ylabel = "ratio of gradients",
      .series = {{.label = "parabola", .style = SeriesStyle::line, .x = {lowest, highest}, .y = {parabola, parabola}}}};
  for (const Field& field : fields) {
    Series points{.label = field.symbol};
    for (const SceneValues& scene : scenes)
      add_point(points, scene.scene().normal_restitution, flatness(scene, field, plug, shear));
    const std::vector<double> ratio = flatness(last, field, plug, shear);
    evidence.checks.push_back({.label = fmt::format("{}: ratio of gradients of {} less that at e_n {:.3g}",
                                                    flow_name(last), field.symbol, highest),
                               .values = difference(ratio, flatness(elastic, field, plug, shear)),
                               .band = negative,
                               .x = lowest});
    if (&field == &fields[0])
      evidence.checks.push_back(
          {.label = fmt::format("{}: ratio of gradients of {}, against a parabola", flow_name(last), field.symbol),
           .values = ratio,
           .band = {-INFINITY, parabola},
           .x = lowest});
    evidence.checks.push_back({.label = fmt::format("{}: gradient of {} in the shear layer less that at e_n {:.3g}",
                                                    flow_name(last), field.symbol, highest),
                               .values = difference(gradient(last, field, shear), gradient(elastic, field, shear)),
                               .band = positive,
                               .x = lowest});
    evidence.plot.series.push_back(std::move(points));
  }
  evidence.notes.push_back(fmt::format(
      "Plug: bins {} to {}; shear layer: bins {} to {}; with their mirror images. A parabola has the ratio {:.3f}.",
      plug.from + 1, plug.to + 1, shear.from + 1, shear.to + 1, parabola));
  for (const SceneValues& scene : scenes)
    for (const Field& field : fields)
      evidence.notes.push_back(fmt::format(
          "{}: {} changes by {:.4f} per bin in the plug and by {:.4f} in the shear layer; at the centre it is {:.4f}.",
          flow_name(scene), field.symbol, over_replicas(gradient(scene, field, plug)).mean,
          over_replicas(gradient(scene, field, shear)).mean,
          over_replicas(scene.mirrored(field.quantity, plug.to)).mean));
  return evidence;
}

// plug.density. Area fraction at the centre: within the tolerance of `close_packing` at every e_n up to `saturated`,
// and rising more slowly per unit of e_n below `saturated` than above it.
Evidence estimate_plug_density(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_restitution(records);
  const double close_packing = claim.parameter("close_packing"), saturated = claim.parameter("saturated");
  const Interval band = band_about(close_packing, claim.tolerance_total());
  const auto centre = [](const SceneValues& scene) { return scene.mirrored("area_fraction", scene.half() - 1); };
  const auto restitution = [](const SceneValues& scene) { return scene.scene().normal_restitution; };
  const double lowest = restitution(scenes.back()), highest = restitution(scenes.front());
  Evidence evidence;
  evidence.plot = {.title = "Area fraction at the centre",
                   .xlabel = "e_n",
                   .ylabel = "area fraction",
                   .series = {{.label = "band",
                               .style = SeriesStyle::band,
                               .x = {std::min(lowest, saturated - 0.05), saturated},  // wide enough to be seen
                               .y = {close_packing, close_packing},
                               .lower = {band.lo, band.lo},
                               .upper = {band.hi, band.hi}}}};
  Series points{.label = "simulation"};
  const SceneValues* knee = nullptr;
  for (const SceneValues& scene : scenes) {
    add_point(points, restitution(scene), centre(scene));
    evidence.notes.push_back(fmt::format("{}: area fraction at the centre {:.4f}.", flow_name(scene), points.y.back()));
    if (restitution(scene) > saturated * (1 + 1e-9)) continue;
    if (knee == nullptr) knee = &scene;
    evidence.checks.push_back({.label = fmt::format("{}: area fraction at the centre", flow_name(scene)),
                               .values = centre(scene),
                               .band = band,
                               .x = restitution(scene),
                               .reference = close_packing});
  }
  evidence.plot.series.push_back(std::move(points));
  if (knee == nullptr || knee == &scenes.front() || knee == &scenes.back()) return evidence;
  const std::vector<double> below = difference(centre(scenes.back()), centre(*knee)),
                            above = difference(centre(*knee), centre(scenes.front()));
  evidence.checks.push_back(
      {.label = fmt::format("rise per unit of e_n below e_n {:.3g} less that above", restitution(*knee)),
       .values = per_replica(std::min(below.size(), above.size()),
                             [&](std::size_t r) {
                               return below[r] / (restitution(*knee) - lowest) -
                                      above[r] / (highest - restitution(*knee));
                             }),
       .band = negative,
       .x = restitution(*knee)});
  return evidence;
}

// fields.dense. Of the difference of U between bin 1 and the centre, the part that is found within `layer_bins` bins of
// bin 1: at least `least_share` (a parabola across 18 bins has 0.42 within two; fig. 3.21).
Evidence estimate_shear_layer(const Claim& claim, Tier, const SceneRecords& records) {
  const std::vector<SceneValues> scenes = by_restitution(records);
  const int layer = bin_parameter(claim, "layer_bins", scenes.front()) + 1;
  const double least = claim.parameter("least_share");
  Evidence evidence;
  evidence.plot = {.title = "Mean velocity across a dense flow",
                   .xlabel = "y/W",
                   .ylabel = "(U - U of bin 1)/(U of the centre - U of bin 1)",
                   .xrange = {{0, 0.5}}};
  for (const SceneValues& scene : scenes) {
    const std::vector<double> share = share_beside_wall(scene, layer);
    evidence.checks.push_back(
        {.label = fmt::format("{}: part of the velocity difference within {} bins of bin 1", flow_name(scene), layer),
         .values = share,
         .band = {least, INFINITY},
         .x = scene.scene().normal_restitution});
    Series points{.label = flow_name(scene)};
    for (int bin = 0; bin < scene.half(); ++bin) add_point(points, scene.centre(bin), share_beside_wall(scene, bin));
    evidence.plot.series.push_back(std::move(points));
    evidence.notes.push_back(fmt::format(
        "{}: U is {:.4f} in bin 1, {:.4f} in bin {} and {:.4f} at the centre; {:.3f} of the difference lies beside the "
        "wall.",
        flow_name(scene), over_replicas(scene.mirrored("mean_velocity", 0)).mean,
        over_replicas(scene.mirrored("mean_velocity", layer)).mean, layer + 1,
        over_replicas(scene.mirrored("mean_velocity", scene.half() - 1)).mean, over_replicas(share).mean));
  }
  return evidence;
}

}  // namespace gpf
