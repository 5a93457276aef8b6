#include "gpf/flow/range.hpp"

#include <fmt/format.h>

#include "gpf/theory/contact_value.hpp"
#include "gpf/theory/enskog.hpp"

namespace gpf {

double knudsen_number(const Scene& scene) {
  const double nu = scene.area_fraction();
  return mean_free_path({nu, 1, scene.diameter(), henderson_contact_value(nu)});
}

namespace {

void add_hydrodynamics(const Scene& scene, std::vector<std::string>& warnings) {
  const double nu = scene.area_fraction(), inelasticity = 1 - scene.normal_restitution;
  const double knudsen = knudsen_number(scene);
  if (knudsen > range::hydrodynamics_knudsen)
    warnings.push_back(
        fmt::format("the Knudsen number is {:.2g}, hydrodynamics was found to hold up to {} "
                    "(limits.hydrodynamics.knudsen)",
                    knudsen, range::hydrodynamics_knudsen));
  if (inelasticity > range::hydrodynamics_inelasticity + 1e-9)
    warnings.push_back(
        fmt::format("1 - e_n is {:.2g}, hydrodynamics was found to hold up to {} "
                    "(limits.hydrodynamics.restitution)",
                    inelasticity, range::hydrodynamics_inelasticity));
  if (nu > range::hydrodynamics_density)
    warnings.push_back(
        fmt::format("nu is {:.2g}, hydrodynamics was found to hold up to {} (limits.hydrodynamics.density)", nu,
                    range::hydrodynamics_density));
}

void add_monte_carlo(const Scene& scene, const MonteCarloSetting& setting, std::vector<std::string>& warnings) {
  const double inelasticity = 1 - scene.normal_restitution, nu = scene.area_fraction();
  if (nu > 1.001 * range::monte_carlo_density)
    warnings.push_back(
        fmt::format("nu is {:.2g}, Enskog Monte Carlo was found to hold up to {} (limits.monte-carlo.density)", nu,
                    range::monte_carlo_density));
  const double cell = (1 - scene.diameter()) / setting.cells / knudsen_number(scene);
  if (cell > range::monte_carlo_cell)
    warnings.push_back(
        fmt::format("a cell is {:.2g} mean free paths high, Enskog Monte Carlo was found to hold up to {} "
                    "(limits.monte-carlo)",
                    cell, range::monte_carlo_cell));
  if (inelasticity > range::monte_carlo_inelasticity + 1e-9)
    warnings.push_back(
        fmt::format("1 - e_n is {:.2g}, Enskog Monte Carlo was found to hold up to {} (limits.monte-carlo)",
                    inelasticity, range::monte_carlo_inelasticity));
  else if (nu > 1.001 * range::monte_carlo_dense && inelasticity > range::monte_carlo_dense_inelasticity + 1e-9)
    warnings.push_back(fmt::format(
        "1 - e_n is {:.2g} at nu {:.2g}: above nu {} Enskog Monte Carlo was found to hold up to {}, beyond it "
        "there is a plug (limits.monte-carlo.density)",
        inelasticity, nu, range::monte_carlo_dense, range::monte_carlo_dense_inelasticity));
}

void add_soft_disks(const MethodSetting& setting, std::vector<std::string>& warnings) {
  if (setting.contact > range::soft_disks_contact)
    warnings.push_back(
        fmt::format("a contact lasts {:.2g} mean free times, soft disks were found to be hard enough up "
                    "to {} (limits.soft-disks.stiffness)",
                    setting.contact, range::soft_disks_contact));
  if (setting.steps < range::soft_disks_steps)
    warnings.push_back(
        fmt::format("a contact has {} steps, soft disks were found to keep their energy from {} on "
                    "(limits.soft-disks.step)",
                    setting.steps, range::soft_disks_steps));
}

void add_hard_disks(const Scene& scene, std::vector<std::string>& warnings) {
  const double rate = scene.tc_time * scene.reference_collision_rate();
  if (rate > range::tc_rate)
    warnings.push_back(
        fmt::format("t_c is {:.2g} mean free times of the start, the flow was found not to depend on it up "
                    "to {} (limits.tc)",
                    rate, range::tc_rate));
  if (scene.tc_time > 0 && scene.normal_restitution <= range::tc_restitution)
    warnings.push_back(fmt::format("e_n is {}: at and below {} the flow was found to depend on t_c (limits.tc)",
                                   scene.normal_restitution, range::tc_restitution));
  if (scene.tc_time == 0 && scene.normal_restitution <= range::collapse_restitution)
    warnings.push_back(
        fmt::format("e_n is {} without the TC model, where runs were found to collapse (limits.collapse)",
                    scene.normal_restitution));
}

}  // namespace

std::vector<std::string> range_warnings(const Scene& scene, const MethodSetting& setting) {
  std::vector<std::string> warnings;
  if (setting.method == Method::event_driven || setting.method == Method::all_pairs) add_hard_disks(scene, warnings);
  if (setting.method == Method::hydrodynamics) add_hydrodynamics(scene, warnings);
  if (setting.method == Method::monte_carlo) add_monte_carlo(scene, setting.monte_carlo, warnings);
  if (setting.method == Method::soft_disks) add_soft_disks(setting, warnings);
  return warnings;
}

}  // namespace gpf
