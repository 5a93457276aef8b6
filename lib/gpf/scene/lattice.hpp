// Start positions: square and triangular lattices, the roomiest that holds the scene's disks.
#pragma once

#include <cstdint>
#include <vector>

#include "gpf/base/vec2.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

/// Rows run along x: row r lies at y = lowest_row + r row_spacing and has `columns` sites at a distance column_spacing.
/// Odd rows are shifted against even ones by row_shift columns. All lengths in W.
struct LatticePlan {
  Lattice kind = Lattice::square;
  double row_shift = 0;  ///< 1/2 triangular, 0 square; 1/10 square where straight rows would touch
  std::int32_t rows = 0, columns = 0;
  double column_spacing = 0, row_spacing = 0, lowest_row = 0;
  double nearest = 0;  ///< least distance between sites, periodic images included
  /// Closest-packed lines run along x: column_spacing <= 2 row_spacing.
  bool along_x = true;
};

/// The lattice on which a scene starts: of all with rows columns >= N that keep the disks apart - from each other, from
/// their periodic images and from their mirror images in the walls, by 1e-6 d at least - the one whose nearest sites
/// are furthest apart. Triangular ones are taken with closest-packed lines along x if any such fits. Straight rows of a
/// square lattice would touch at whole W/d: a zigzag of a tenth of a column is used where they do not fit.
/// Lattice::automatic is square below area fraction 0.78 (thesis sec. 3.2.2) if a square lattice fits there, else
/// triangular, else square.
/// Throws InputError, with the largest area fraction that fits for this N and W/d, if none does.
[[nodiscard]] LatticePlan plan_lattice(const Scene& scene);

/// Largest area fraction at which plan_lattice finds a place for N disks at this W/d (L/W is free, but L >= 4 d).
[[nodiscard]] double largest_area_fraction(const Scene& scene, Lattice lattice);

/// N positions on plan_lattice(scene), row by row, x in [0, L) and y in (d/2, 1 - d/2) in a channel, [0, 1) otherwise.
/// Surplus sites, fewer than there are rows, are left vacant evenly over the area, at most one per row.
/// Uses + - * / sqrt only: the same bits everywhere.
[[nodiscard]] std::vector<Vec2> place_on_lattice(const Scene& scene);

}  // namespace gpf
