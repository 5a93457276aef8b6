#include "gpf/scene/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/scene/canonical_text.hpp"
#include "gpf/scene/scene_keys.hpp"

namespace gpf {
namespace {

constexpr double square_limit = 0.78;

/// Least distance of sites. Disks packed between walls or round a period with gaps g collide of the order of
/// sqrt(d/g) times each before they loosen, because sideways motion opens a gap only quadratically: without limit at
/// contact, a thousand times here. Far beyond the rounding of coordinates (1e-12 d) too.
double contact_distance(const Scene& scene) { return scene.diameter() * (1 + 1e-6); }

std::int64_t divide_up(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

/// Row counts worth a look: more than two per diameter touch, and more than N + 1 stay empty.
std::int32_t most_rows(const Scene& scene) {
  return static_cast<std::int32_t>(std::min(2 * scene.width_over_diameter + 1, scene.particles + 1.0));
}

/// Shifts between rows, in columns, that a lattice may have; the first that fits is taken.
std::vector<double> row_shifts(Lattice kind) {
  return kind == Lattice::square ? std::vector{0.0, 0.1} : std::vector{0.5};
}

/// Shifted rows come in pairs, which have to close on themselves round a period.
bool row_count_allowed(const Scene& scene, double shift, std::int32_t rows) {
  return shift == 0 || scene.geometry == Geometry::channel || rows % 2 == 0;
}

/// Distance D of sites in neighbouring rows of a channel, shifted by s, when the outermost rows lie D/2 from the walls:
/// D^2 = s^2 + b^2 with k b = 1 - D, k = rows - 1, hence (k^2 - 1) D^2 + 2 D = c = 1 + (k s)^2. Rows two apart are 2 b
/// apart, so D may not exceed 2/(k + 2) either.
double row_clearance(double s, std::int32_t rows) {
  const double k = rows - 1, c = 1 + square(k * s);
  const double clearance = c / (1 + std::sqrt(1 + (k * k - 1) * c));
  return std::min(clearance, rows > 2 ? 2 / (k + 2) : 1.0);
}

LatticePlan lay_out(const Scene& scene, Lattice kind, double shift, std::int32_t rows) {
  LatticePlan plan{kind, shift, rows, static_cast<std::int32_t>(divide_up(scene.particles, rows))};
  const double a = plan.column_spacing = scene.length() / plan.columns;
  double clearance = 1;  // from a row to the next, to its image in a wall, or round the period
  if (scene.geometry == Geometry::channel) {
    clearance = row_clearance(shift * a, rows);
    plan.row_spacing = rows > 1 ? (1 - clearance) / (rows - 1) : 1;
    plan.lowest_row = clearance / 2;
  } else {
    const double b = plan.row_spacing = 1.0 / rows;
    if (rows > 1) clearance = std::min(std::sqrt(square(shift * a) + square(b)), 2 * b);
    plan.lowest_row = b / 2;
  }
  plan.nearest = std::min(a, clearance);
  plan.along_x = rows == 1 || a <= 2 * plan.row_spacing;
  return plan;
}

std::optional<LatticePlan> roomiest(const Scene& scene, Lattice kind) {
  const double contact = contact_distance(scene);
  std::optional<LatticePlan> best;
  const auto better = [&best](const LatticePlan& plan) {
    return !best || std::pair(plan.along_x, plan.nearest) > std::pair(best->along_x, best->nearest);
  };
  for (const double shift : row_shifts(kind)) {
    for (std::int32_t rows = 1; rows <= most_rows(scene); ++rows) {
      if (!row_count_allowed(scene, shift, rows)) continue;
      const LatticePlan plan = lay_out(scene, kind, shift, rows);
      if (plan.nearest >= contact && better(plan)) best = plan;
    }
    if (best) break;
  }
  return best;
}

/// Least distance between the columns of `rows` rows at contact; nothing if the rows themselves are too close.
std::optional<double> least_column_spacing(const Scene& scene, double shift, std::int32_t rows, double contact) {
  if (rows * contact <= 1) return contact;
  if (shift == 0 || rows == 1) return std::nullopt;
  const double b = scene.geometry == Geometry::channel ? (1 - contact) / (rows - 1) : 1.0 / rows;
  if (rows > 2 && 2 * b < contact) return std::nullopt;
  return std::max(contact, std::sqrt(std::max(0.0, square(contact) - square(b))) / shift);
}

/// Least period along x that holds the scene's disks at its W/d.
double least_length(const Scene& scene, Lattice kind) {
  const double contact = contact_distance(scene);
  double least = longest_side * scene.diameter();
  for (const double shift : row_shifts(kind))
    for (std::int32_t rows = 1; rows <= most_rows(scene); ++rows) {
      if (!row_count_allowed(scene, shift, rows)) continue;
      if (const auto a = least_column_spacing(scene, shift, rows, contact))
        least = std::min(least, static_cast<double>(divide_up(scene.particles, rows)) * *a);
    }
  return std::max(least, shortest_period * scene.diameter());
}

[[noreturn]] void fail_to_fit(const Scene& scene) {
  const auto rounded_down = [](double nu) { return std::floor(nu * 1e4) / 1e4; };
  const double most = largest_area_fraction(scene, scene.lattice);
  const double any = largest_area_fraction(scene, Lattice::automatic);
  const std::string where =
      scene.lattice == Lattice::automatic ? "no lattice" : fmt::format("no {} lattice", name_of(scene.lattice));
  const bool other_fits = scene.lattice != Lattice::automatic && scene.area_fraction() <= any;
  throw InputError(
      fmt::format("{} holds {} disks at area fraction {:.6g}", where, scene.particles, scene.area_fraction()),
      fmt::format("with W/d = {:.6g} the most that fits is {:.4f}", scene.width_over_diameter, rounded_down(most)),
      other_fits ? "set lattice = \"auto\""
                 : "lower area_fraction (or particles, or lengthen the channel), or choose W/d to suit whole rows");
}

/// Column left vacant in each row, or -1.
std::vector<std::int32_t> vacancies(const LatticePlan& plan, std::int64_t particles) {
  std::vector<std::int32_t> column(static_cast<std::size_t>(plan.rows), -1);
  const std::int64_t vacant = std::int64_t{plan.rows} * plan.columns - particles;
  for (std::int64_t j = 0; j < vacant; ++j) {
    // Rows at equal steps; columns along the golden-ratio sequence, which fills [0, 1) evenly for any number of terms.
    const auto row = static_cast<std::size_t>((2 * j + 1) * plan.rows / (2 * vacant));
    const std::uint64_t golden = (static_cast<std::uint64_t>(j) * 0x9e3779b97f4a7c15u) >> 32;
    column[row] = static_cast<std::int32_t>((golden * static_cast<std::uint64_t>(plan.columns)) >> 32);
  }
  return column;
}

}  // namespace

LatticePlan plan_lattice(const Scene& scene) {
  std::optional<LatticePlan> plan;
  if (scene.lattice != Lattice::automatic) {
    plan = roomiest(scene, scene.lattice);
  } else {
    if (scene.area_fraction() < square_limit) plan = roomiest(scene, Lattice::square);
    if (!plan) plan = roomiest(scene, Lattice::triangular);
    if (!plan) plan = roomiest(scene, Lattice::square);
  }
  if (!plan) fail_to_fit(scene);
  return *plan;
}

double largest_area_fraction(const Scene& scene, Lattice lattice) {
  if (lattice == Lattice::automatic)
    return std::max(largest_area_fraction(scene, Lattice::square), largest_area_fraction(scene, Lattice::triangular));
  return std::numbers::pi * scene.particles * square(scene.diameter()) / (4 * least_length(scene, lattice));
}

std::vector<Vec2> place_on_lattice(const Scene& scene) {
  const LatticePlan plan = plan_lattice(scene);
  const std::vector<std::int32_t> vacant = vacancies(plan, scene.particles);
  std::vector<Vec2> positions;
  positions.reserve(static_cast<std::size_t>(scene.particles));
  for (std::int32_t row = 0; row < plan.rows; ++row) {
    const double middle = 0.5 + (row % 2 == 0 ? -0.5 : 0.5) * plan.row_shift;
    const double y = plan.lowest_row + row * plan.row_spacing;
    for (std::int32_t column = 0; column < plan.columns; ++column)
      if (column != vacant[static_cast<std::size_t>(row)])
        positions.push_back({(column + middle) * plan.column_spacing, y});
  }
  return positions;
}

}  // namespace gpf
