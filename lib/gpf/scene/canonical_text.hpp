// The one text of a scene, and the hash that names it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "gpf/scene/scene.hpp"

namespace gpf {

/// A [scene] table with every key in a fixed order and numbers that read back to the same bits. Equal scenes have equal
/// texts; parse_scene gives the scene back. (Of the four size keys N, W/d and L/W; no wall keys in a periodic scene.)
[[nodiscard]] std::string canonical_text(const Scene& scene);

/// hash_text of the canonical text without its seed: replicas of a scene share it.
[[nodiscard]] std::uint64_t scene_hash(const Scene& scene);

/// "channel", "periodic"; "auto", "square", "triangular": as in scene files.
[[nodiscard]] std::string_view name_of(Geometry geometry);
[[nodiscard]] std::string_view name_of(Lattice lattice);
std::string_view name_of(Detail detail);

}  // namespace gpf
