#include "verify/estimators/stress_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"
#include "gpf/theory/garzo_dufty.hpp"
#include "gpf/theory/jenkins_richman.hpp"

namespace gpf {
namespace {

/// rho_p g W for m = g = W = 1, and rho_p g^(1/2) W^(3/2) too.
double thesis_unit(const Scene& scene) { return 4 / (std::numbers::pi * square(scene.diameter())); }

double theory_pressure(Constitutive theory, const Gas& gas, double restitution) {
  return theory == Constitutive::jenkins_richman ? jenkins_richman_pressure(gas)
                                                 : garzo_dufty_pressure(gas, restitution);
}

double theory_viscosity(Constitutive theory, const Gas& gas, double restitution) {
  return theory == Constitutive::jenkins_richman ? shear_viscosity(gas) : garzo_dufty_viscosity(gas, restitution);
}

}  // namespace

std::string symbol_of(StressPart part) {
  return part == StressPart::both ? "N_1" : part == StressPart::kinetic ? "N_1^k" : "N_1^c";
}

std::vector<double> first_normal_stress_difference(const SceneValues& scene, int bin, StressPart part, MeanFlow mean) {
  const auto of = [&](const char* quantity) { return scene.mirrored(quantity, bin); };
  std::vector<double> kinetic_xx = of("kinetic_stress_xx");
  const std::vector<double> kinetic_yy = of("kinetic_stress_yy"), collisional_xx = of("collisional_stress_xx"),
                            collisional_yy = of("collisional_stress_yy");
  if (mean == MeanFlow::long_time) {  // T = (var_x + var_y)/2, and kinetic_yy = n var_y
    const std::vector<double> t = of("granular_temperature_long_time"), var_y = of("velocity_variance_y");
    for (std::size_t r = 0; r < t.size(); ++r) kinetic_xx[r] = kinetic_yy[r] * (2 * t[r] - var_y[r]) / var_y[r];
  }
  return per_replica(scene.replicas(), [&](std::size_t r) {
    const double kinetic = kinetic_xx[r] - kinetic_yy[r], collisional = collisional_xx[r] - collisional_yy[r];
    const double p = (kinetic_xx[r] + kinetic_yy[r] + collisional_xx[r] + collisional_yy[r]) / 2;
    const double kept = part == StressPart::kinetic       ? kinetic
                        : part == StressPart::collisional ? collisional
                                                          : kinetic + collisional;
    return kept / p;
  });
}

std::vector<double> shear_rate(const SceneValues& scene, int bin) {
  const int neighbours = std::min(bin - 1, 2);
  if (neighbours < 1 || bin >= scene.half())
    throw InputError(fmt::format("no shear rate in bin {} of {}", bin + 1, scene.name()),
                     "its slope needs neighbours other than the wall's bin", "ask from the third bin to the centre");
  std::vector<double> slope(scene.replicas(), 0.0);
  double squares = 0;
  for (int k = 1; k <= neighbours; ++k) {
    const std::vector<double> inner = scene.mirrored("mean_velocity", bin + k),
                              outer = scene.mirrored("mean_velocity", bin - k);
    for (std::size_t r = 0; r < slope.size(); ++r) slope[r] += k * (inner[r] - outer[r]) * scene.bins();
    squares += 2 * k * k;
  }
  for (double& s : slope) s /= squares;
  return slope;
}

Rheology rheology(const SceneValues& scene, int bin, Constitutive theory) {
  const double unit = thesis_unit(scene.scene()), e = scene.scene().normal_restitution;
  const auto of = [&](const char* quantity) { return scene.mirrored(quantity, bin); };
  const std::vector<double> nu = of("area_fraction"), temperature = of("granular_temperature"), xx = of("pressure_xx"),
                            yy = of("pressure_yy"), xy = scene.mirrored("pressure_xy", bin, Parity::odd),
                            rate = shear_rate(scene, bin);
  Rheology found;
  for (std::size_t r = 0; r < scene.replicas(); ++r) {
    const Gas gas = jenkins_richman_gas(nu[r], temperature[r], scene.scene().diameter());
    found.pressure.push_back((xx[r] + yy[r]) / 2 / unit);
    found.shear_stress.push_back(-xy[r] / unit);
    found.viscosity.push_back(found.shear_stress[r] / rate[r]);
    found.theory_pressure.push_back(theory_pressure(theory, gas, e) / unit);
    found.theory_viscosity.push_back(theory_viscosity(theory, gas, e) / unit);
    found.theory_shear_stress.push_back(found.theory_viscosity[r] * rate[r]);
  }
  return found;
}

BinRange bulk_bins(const SceneValues& scene) {
  const double nu = scene.scene().area_fraction(), d = scene.scene().diameter();
  const double path = mean_free_path(jenkins_richman_gas(nu, 1, d));  // does not depend on T
  int first = first_bin_with_shear_rate;
  while (first < scene.half() && scene.centre(first) < d / 2 + path) ++first;
  return {first, scene.half()};
}

std::string SceneRow::label() const { return fmt::format("e_n {:.3g}, beta_w {:.3g}", restitution, wall_restitution); }

std::vector<SceneRow> rows_of(const std::vector<SceneValues>& scenes) {
  std::vector<SceneRow> rows;
  for (const SceneValues& scene : scenes) {
    const double e = scene.scene().normal_restitution, beta = scene.scene().wall_tangential_restitution[0];
    auto row = std::find_if(rows.begin(), rows.end(), [&](const SceneRow& known) {
      return known.restitution == e && known.wall_restitution == beta;
    });
    if (row == rows.end()) row = rows.insert(rows.end(), {e, beta, {}});
    row->scenes.push_back(&scene);
  }
  std::sort(rows.begin(), rows.end(), [](const SceneRow& a, const SceneRow& b) {
    return a.wall_restitution != b.wall_restitution ? a.wall_restitution > b.wall_restitution
                                                    : a.restitution > b.restitution;
  });
  return rows;
}

const SceneValues* find_scene(const SceneRow& row, double area_fraction) {
  for (const SceneValues* scene : row.scenes)
    if (std::abs(scene->scene().area_fraction() - area_fraction) < 1e-9) return scene;
  return nullptr;
}

}  // namespace gpf
