#include "gpf/scene/scene_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace gpf {
namespace {

using Words2 = std::array<std::string_view, 2>;
using Words3 = std::array<std::string_view, 3>;
constexpr Words2 geometries{"channel", "periodic"};
constexpr Words3 details{"profiles", "distributions", "correlations"};
constexpr Words3 lattices{"auto", "square", "triangular"};

constexpr double longest_time = 1e12;
constexpr double strongest_gravity = 1e12;
constexpr double integers = 0x1p63;  // TOML integers end at 2^63 - 1
constexpr std::string_view size_default = "follows from the three others";
constexpr std::string_view time_reason = "times are positive, and beyond 1e12 lose their fractions in a double";

constexpr std::array keys{
    SceneKey{.table = "scene",
             .name = "geometry",
             .kind = KeyKind::word,
             .words = geometries,
             .meaning = "walls at y = 0 and y = W, or periodic in x and y (then W is the period across)",
             .otherwise = "required"},
    SceneKey{.table = "scene",
             .name = "particles",
             .kind = KeyKind::integer,
             .least = 1,
             .most = 1e7,
             .range_reason = "a scene holds at least one disk, and ten million fill the memory of one machine",
             .meaning = "number of disks N",
             .otherwise = size_default},
    SceneKey{.table = "scene",
             .name = "area_fraction",
             .least = 0,
             .most = close_packing,
             .least_excluded = true,
             .range_reason = "equal disks cannot cover more than pi/(2 sqrt 3) of the plane",
             .meaning = "nu = pi N d^2/(4 L W)",
             .otherwise = size_default},
    SceneKey{.table = "scene",
             .name = "width_over_diameter",
             .least = narrowest_channel,
             .most = longest_side,
             .range_reason = "centres need room between the walls, a coordinate keeps about 15 digits of the width",
             .meaning = "W/d; at least 4 in a periodic scene",
             .otherwise = size_default},
    SceneKey{.table = "scene",
             .name = "length_over_width",
             .least = 0,
             .most = longest_side,
             .least_excluded = true,
             .range_reason = "the period along the channel is a length, between 4 d and 1e4 d",
             .meaning = "L/W; L is the period along x, at least 4 d",
             .otherwise = size_default},
    SceneKey{.table = "scene",
             .name = "normal_restitution",
             .least = 0,
             .most = 1,
             .range_reason = "a collision neither gains energy nor lets disks pass through each other",
             .meaning = "e_n of pairs",
             .otherwise = "required"},
    SceneKey{.table = "scene",
             .name = "wall_normal_restitution",
             .least = 0,
             .most = 1,
             .range_reason = "a wall neither adds energy nor lets disks through",
             .meaning = "e_w of both walls; channel only",
             .otherwise = "1"},
    SceneKey{.table = "scene",
             .name = "wall_tangential_restitution",
             .kind = KeyKind::wall_pair,
             .least = -1,
             .most = 1,
             .range_reason = "a wall adds no energy to the tangential motion",
             .meaning = "beta_w, or [lower, upper]; 1 smooth, -1 reverses the tangential velocity; channel only",
             .otherwise = "required in a channel"},
    SceneKey{.table = "scene",
             .name = "tc_time",
             .least = 0,
             .most = longest_time,
             .range_reason = "it is a duration of contacts; 0 switches the TC model off",
             .meaning = "t_c of the TC model: a contact sooner than this after either partner's last is elastic; at "
                        "most one mean free time",
             .otherwise = "1e-4 mean free times of the start (dissipation 2.4e-4 low there)"},
    SceneKey{.table = "scene",
             .name = "gravity",
             .least = 0,
             .most = strongest_gravity,
             .range_reason = "it points along +x and sets the unit of time, (W/g)^(1/2)",
             .meaning = "g; 0 in a periodic scene",
             .otherwise = "1 in a channel, 0 in a periodic scene"},
    SceneKey{.table = "scene",
             .name = "lattice",
             .kind = KeyKind::word,
             .words = lattices,
             .meaning = "start positions; auto: square below area fraction 0.78 where it fits, else triangular",
             .otherwise = "auto"},
    SceneKey{.table = "scene",
             .name = "seed",
             .kind = KeyKind::integer,
             .least = 0,
             .most = integers,
             .range_reason = "it is a whole number of 63 bits",
             .meaning = "of the start velocities",
             .otherwise = "1"},
    SceneKey{.table = "run",
             .name = "start_up",
             .least = 0,
             .most = longest_time,
             .range_reason = time_reason,
             .meaning = "time that is discarded before measurement begins",
             .otherwise = "50 (W/g)^(1/2) under gravity, else 50 mean free times"},
    SceneKey{.table = "run",
             .name = "duration",
             .least = 0,
             .most = longest_time,
             .least_excluded = true,
             .range_reason = time_reason,
             .meaning = "least measured time; this or collisions_per_particle, or both, must be given",
             .otherwise = "no such target"},
    SceneKey{.table = "run",
             .name = "collisions_per_particle",
             .least = 0,
             .most = longest_time,
             .least_excluded = true,
             .range_reason = "it is a positive number, 2 collisions/N",
             .meaning = "least number of measured pair collisions of a disk, 2 N_c/N",
             .otherwise = "no such target"},
    SceneKey{.table = "run",
             .name = "sample_interval",
             .least = 0,
             .most = longest_time,
             .least_excluded = true,
             .range_reason = time_reason,
             .meaning = "time between samples of the fields; not above duration",
             .otherwise = "largest power of two not above 4 mean free times, (1/4)(W/g)^(1/2) and duration"},
    SceneKey{.table = "run",
             .name = "bins",
             .kind = KeyKind::integer,
             .least = 1,
             .most = 1000,
             .range_reason = "profiles need at least one bin, and more than 1000 resolve nothing",
             .meaning = "bins across the width",
             .otherwise = "18 for W/d = 31, in proportion to W/d"},
    SceneKey{.table = "run",
             .name = "detail",
             .kind = KeyKind::word,
             .words = details,
             .meaning = "what is measured; distributions: of velocities, free paths and contact angles besides; "
                        "correlations: between disks and in time besides",
             .otherwise = "profiles"},
    SceneKey{.table = "run",
             .name = "density_modes",
             .kind = KeyKind::integer,
             .least = 0,
             .most = 1000,
             .range_reason = "it counts wavenumbers, and 1000 along the channel resolve every disk of a long one",
             .meaning =
                 "density waves: wavenumbers k = 1, 2, ... along the channel of which the power is measured, for "
                 "slugs, waves and varicose waves; channel only",
             .otherwise = "0: not measured"},
    SceneKey{.table = "run",
             .name = "snapshots",
             .kind = KeyKind::ascending,
             .least = 0,
             .most = longest_time,
             .least_excluded = true,
             .range_reason = time_reason,
             .meaning =
                 "one or several, [t1, t2, ...], ascending, from the start of the run: times of which the state is "
                 "kept, that of the nearest sample; at most 100, none beyond start_up + duration",
             .otherwise = "the last state only"}};

}  // namespace

std::string SceneKey::range() const {
  switch (kind) {
    case KeyKind::word:
      return fmt::format("\"{}\"", fmt::join(words, "\" | \""));
    case KeyKind::integer:
      return most == integers ? fmt::format("{} ... 2^63 - 1", least) : fmt::format("{} ... {:.0f}", least, most);
    default:
      return fmt::format("{}{}, {:.10g}]", least_excluded ? '(' : '[', least, most);
  }
}

std::span<const SceneKey> scene_keys() { return keys; }

std::string scene_key_help() {
  std::string text;
  std::string_view table;
  for (const SceneKey& key : keys) {
    if (key.table != table) text += fmt::format("{}[{}]\n", table.empty() ? "" : "\n", key.table);
    table = key.table;
    text +=
        fmt::format("  {:<28} {}\n      {}\n      default: {}\n", key.name, key.range(), key.meaning, key.otherwise);
  }
  return text;
}

}  // namespace gpf
