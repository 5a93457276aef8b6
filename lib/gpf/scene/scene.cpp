#include "gpf/scene/scene.hpp"

#include <cmath>
#include <numbers>

#include "gpf/base/vec2.hpp"

namespace gpf {

using std::numbers::pi;

double Scene::area_fraction() const { return pi * particles / (4 * length_over_width * square(width_over_diameter)); }

double Scene::velocity_scale() const { return gravity > 0 ? std::sqrt(gravity) : 1; }

double Scene::reference_collision_rate() const {
  const double nu = area_fraction(), d = diameter();
  const double number_density = particles / length_over_width;
  const double contact_value = (1 - 7 * nu / 16) / square(1 - nu);
  return 2 * std::sqrt(pi) * number_density * d * contact_value * velocity_scale();
}

}  // namespace gpf
