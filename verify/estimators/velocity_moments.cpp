#include "verify/estimators/velocity_moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

/// Greatest difference between two moments in any bin, of means over replicas.
double greatest_difference(const SceneValues& scene, const std::array<VelocityMoment, 2>& moments) {
  double greatest = 0;
  for (int bin = 0; bin < scene.half(); ++bin)
    greatest = std::max(greatest, std::abs(over_replicas(moment(scene, moments[0], bin)).mean -
                                           over_replicas(moment(scene, moments[1], bin)).mean));
  return greatest;
}

/// Mean number of disks in the emptiest bin.
double fewest_disks(const SceneValues& scene) {
  const double bin_area = scene.scene().length() / scene.bins();
  const double disk_area = scene.scene().area_fraction() * scene.scene().length() / scene.scene().particles;
  const std::vector<double> fractions = scene.mean_profile("area_fraction");
  return *std::min_element(fractions.begin(), fractions.end()) * bin_area / disk_area;
}

}  // namespace

std::vector<SceneValues> by_restitution(const SceneRecords& records) {
  std::vector<SceneValues> scenes = by_area_fraction(records);
  std::stable_sort(scenes.begin(), scenes.end(), [](const SceneValues& a, const SceneValues& b) {
    return a.scene().normal_restitution > b.scene().normal_restitution;
  });
  return scenes;
}

std::string flow_name(const SceneValues& scene) {
  const Scene& s = scene.scene();
  return fmt::format("nu {:.3g}, e_n {:.3g}, beta_w {:.3g}", s.area_fraction(), s.normal_restitution,
                     s.wall_tangential_restitution[lower]);
}

std::string bin_names(const SceneValues& scene, int bin) {
  const int mirror = scene.bins() - 1 - bin;
  return bin == mirror ? fmt::format("bin {}", bin + 1) : fmt::format("bins {} and {}", bin + 1, mirror + 1);
}

int bin_parameter(const Claim& claim, std::string_view name, const SceneValues& scene) {
  const int bin = static_cast<int>(claim.parameter(name)) - 1;
  if (bin < 0 || bin >= scene.half())
    throw InputError(fmt::format("{} = {} of scene {}", name, bin + 1, scene.name()),
                     fmt::format("bins of one side are 1 ... {}", scene.half()), "correct the claim's [parameters]");
  return bin;
}

std::vector<double> moment(const SceneValues& scene, const VelocityMoment& which, int bin) {
  return scene.mirrored(which.quantity, bin, which.parity);
}

std::vector<double> departure(const SceneValues& scene, const VelocityMoment& which, int bin, double centre) {
  std::vector<double> values = moment(scene, which, bin);
  for (double& value : values) value = std::abs(value - centre);
  return values;
}

Check moment_check(const SceneValues& scene, const VelocityMoment& which, int bin, Interval band) {
  return {.label = fmt::format("{}, {}: {}", flow_name(scene), bin_names(scene, bin), which.name),
          .values = moment(scene, which, bin),
          .band = band,
          .x = scene.centre(bin),
          .reference = std::isfinite(band.width()) ? band.centre() : NAN};
}

Series moment_profile(const SceneValues& scene, const VelocityMoment& which, std::string label) {
  Series points{.label = std::move(label)};
  const double sign = which.parity == Parity::even ? 1 : -1;
  for (int bin = 0; bin < scene.bins(); ++bin) {
    const bool measured = bin < scene.half();
    std::vector<double> values = moment(scene, which, measured ? bin : scene.bins() - 1 - bin);
    if (!measured)
      for (double& value : values) value *= sign;
    add_point(points, scene.centre(bin), values);
  }
  return points;
}

Series band_across(Interval band, std::string label) {
  const double centre = band.centre();
  return {.label = std::move(label),
          .style = SeriesStyle::band,
          .x = {0, 1},
          .y = {centre, centre},
          .lower = {band.lo, band.lo},
          .upper = {band.hi, band.hi}};
}

std::vector<std::string> notes_on_definitions(const std::vector<SceneValues>& scenes) {
  double fewest = INFINITY;
  for (const SceneValues& scene : scenes) fewest = std::min(fewest, fewest_disks(scene));
  // For n independent disks the third cumulant of u = c - (mean of the n) is (n-1)(n-2)/n^2, the fourth
  // (n-1)(n^2-3n+3)/n^3, and the variance (n-1)/n of that of c.
  const double n = fewest, skewness_factor = (n - 2) / std::sqrt(n * (n - 1)),
               excess_factor = (n * n - 3 * n + 3) / (n * (n - 1));
  std::vector<std::string> notes{fmt::format(
      "u_x is taken about the instantaneous mean of its bin (eq. 2.10), and about the long-time mean as well; u_y = "
      "c_y "
      "about its long-time mean, which vanishes (no instantaneous mean of c_y is recorded). Temperatures divide sums "
      "of "
      "squares by the number of disks less one; skewness and kurtosis are plain ratios of sums. The instantaneous mean "
      "leaves a Gaussian at 0 and 3 and shrinks a departure: for independent disks, at the {:.0f} of the emptiest bin "
      "here, the skewness to {:.3f} and the excess kurtosis to {:.3f} of it. Neither can change a sign. The bins y and "
      "W - y are averaged, u_y with its sign turned.",
      n, skewness_factor, excess_factor)};
  for (const SceneValues& scene : scenes)
    notes.push_back(fmt::format(
        "{}: between the two means the skewness of u_x differs by at most {:.3f} in any bin, "
        "the kurtosis by {:.3f}.",
        flow_name(scene), greatest_difference(scene, skewnesses_x), greatest_difference(scene, kurtoses_x)));
  return notes;
}

}  // namespace gpf
