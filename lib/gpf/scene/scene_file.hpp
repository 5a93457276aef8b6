// Scene files: TOML text in, Scene and Run out, or an error that says where, why and what to do.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gpf/scene/canonical_text.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/scene_keys.hpp"

namespace gpf {

struct SceneFile {
  Scene scene;
  Run run;
  std::string text;  ///< as read
  std::string name;  ///< of the file, for messages
};

/// Reads a scene from TOML `text`; `name_for_messages` stands for it in errors. scene_key_help() lists keys, ranges and
/// defaults; the defaults that are computed are these:
/// - tc_time: 1e-4/omega with omega = Scene::reference_collision_rate(). The TC model lowers the dissipation by
///   2.37 omega t_c in two dimensions, here by 2.4e-4 at the temperature of the start; a bias below 1e-3 needs
///   omega t_c < 4e-4. It scales with (W/g)^(1/2), so that a change of g changes no trajectory.
/// - start_up: 50 (W/g)^(1/2) under gravity, else 50/omega. Strong dissipation or dense flow needs more.
/// - sample_interval: the largest power of two not above 4/omega (fields further apart are almost independent), a
///   quarter of W/velocity_scale() and a given duration. A power of two adds up without round-off.
/// - bins: round(18/31 W/d), at least 1, at most 1000: the thesis' 18 bins at W/d = 31.
/// Throws InputError: whatever KeyValues, resolve_size and plan_lattice refuse; a missing key that has no default; wall
/// keys or gravity in a periodic scene; t_c beyond a mean free time; a run without a target, or with a sample_interval
/// beyond its duration.
[[nodiscard]] SceneFile parse_scene(std::string_view text, std::string_view name_for_messages);

/// parse_scene of a file's text. Throws StorageError when the file cannot be read.
[[nodiscard]] SceneFile load_scene(const std::filesystem::path& path);

}  // namespace gpf
