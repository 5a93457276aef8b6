#include "gpf/scene/canonical_text.hpp"

#include <fmt/format.h>

#include "gpf/base/hash.hpp"

namespace gpf {
namespace {

std::string text_without_seed(const Scene& scene) {
  // {} writes the shortest decimal that reads back to the same double.
  std::string text = fmt::format(
      "[scene]\ngeometry = \"{}\"\nparticles = {}\nwidth_over_diameter = {}\nlength_over_width = {}\n"
      "normal_restitution = {}\n",
      name_of(scene.geometry), scene.particles, scene.width_over_diameter, scene.length_over_width,
      scene.normal_restitution);
  if (scene.geometry == Geometry::channel)
    text += fmt::format("wall_normal_restitution = {}\nwall_tangential_restitution = [{}, {}]\n",
                        scene.wall_normal_restitution, scene.wall_tangential_restitution[Wall::lower],
                        scene.wall_tangential_restitution[Wall::upper]);
  return text + fmt::format("tc_time = {}\ngravity = {}\nlattice = \"{}\"\n", scene.tc_time, scene.gravity,
                            name_of(scene.lattice));
}

}  // namespace

std::string_view name_of(Geometry geometry) { return geometry == Geometry::channel ? "channel" : "periodic"; }

std::string_view name_of(Lattice lattice) {
  switch (lattice) {
    case Lattice::square:
      return "square";
    case Lattice::triangular:
      return "triangular";
    default:
      return "auto";
  }
}

std::string_view name_of(Detail detail) {
  switch (detail) {
    case Detail::distributions:
      return "distributions";
    case Detail::correlations:
      return "correlations";
    default:
      return "profiles";
  }
}

std::string canonical_text(const Scene& scene) {
  return text_without_seed(scene) + fmt::format("seed = {}\n", scene.seed);
}

std::uint64_t scene_hash(const Scene& scene) { return hash_text(text_without_seed(scene)); }

}  // namespace gpf
