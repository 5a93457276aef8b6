#include "gpf/scene/lattice.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <optional>

#include "gpf/base/error.hpp"

using namespace gpf;

namespace {

Scene scene_at(double area_fraction, std::int32_t particles, double width_over_diameter, Geometry geometry,
               Lattice lattice = Lattice::automatic) {
  Scene scene;
  scene.geometry = geometry;
  scene.particles = particles;
  scene.width_over_diameter = width_over_diameter;
  scene.length_over_width = std::numbers::pi * particles / (4 * area_fraction * square(width_over_diameter));
  scene.lattice = lattice;
  return scene;
}

/// Least gap between two disks, periodic images included, in diameters; 1 if larger. Shares nothing with the
/// lattice: a sweep along x over all disks and the images that lie within 2 d of the box.
double least_gap(const Scene& scene, const std::vector<Vec2>& positions) {
  const double d = scene.diameter(), reach = 2 * d, length = scene.length();
  std::vector<Vec2> all = positions;
  for (const Vec2 r : positions)
    if (r.x < reach) all.push_back({r.x + length, r.y});
  if (scene.geometry == Geometry::periodic)
    for (std::size_t i = 0, count = all.size(); i < count; ++i)
      if (all[i].y < reach) all.push_back({all[i].x, all[i].y + 1});
  if (scene.geometry == Geometry::periodic)  // diagonal neighbours round the corner x = 0, y = 1
    for (const Vec2 r : positions)
      if (r.y < reach && r.x > length - reach) all.push_back({r.x - length, r.y + 1});
  std::sort(all.begin(), all.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  double least = square(reach);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size() && all[j].x - all[i].x < reach; ++j)
      least = std::min(least, dot(all[j] - all[i], all[j] - all[i]));
  return std::sqrt(least) / d - 1;
}

/// Positions if the scene fits; an InputError is checked to say so rightly.
std::optional<std::vector<Vec2>> placed(const Scene& scene) {
  const double most = largest_area_fraction(scene, scene.lattice);
  try {
    auto positions = place_on_lattice(scene);
    BOOST_TEST(scene.area_fraction() <= most * (1 + 1e-9));
    return positions;
  } catch (const InputError& error) {
    BOOST_TEST(scene.area_fraction() > most * (1 - 1e-9), error.what());
    return std::nullopt;
  }
}

void check_lies_well(const Scene& scene, const std::vector<Vec2>& positions) {
  const double d = scene.diameter();
  BOOST_TEST(positions.size() == static_cast<std::size_t>(scene.particles));
  // Coordinates are rounded a few times to 2^-53 of a side of 1e4 d at most: some 1e-12 d.
  BOOST_TEST(least_gap(scene, positions) > 1e-6 - 1e-11);
  for (const Vec2 r : positions) {
    const bool inside_x = r.x >= 0 && r.x < scene.length();
    const bool inside_y = scene.geometry == Geometry::channel ? r.y > d / 2 && r.y < 1 - d / 2 : r.y >= 0 && r.y < 1;
    if (!inside_x || !inside_y) BOOST_ERROR("outside: " << r.x << ", " << r.y);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(lattice_test)

BOOST_AUTO_TEST_CASE(disks_lie_inside_and_apart_over_a_grid_of_scenes) {
  int fitted = 0, refused = 0;
  for (const Geometry geometry : {Geometry::channel, Geometry::periodic})
    for (const Lattice lattice : {Lattice::automatic, Lattice::square, Lattice::triangular})
      for (const std::int32_t n : {1, 2, 3, 7, 64, 100, 900, 3601, 10007})
        for (const double wd : {1.01, 1.4, 1.9, 2.5, 4.0, 5.25, 10.3, 31.0, 62.0, 303.0})
          for (const double nu :
               {1e-4, 0.015, 0.05, 0.15, 0.3, 0.45, 0.56, 0.65, 0.72, 0.77, 0.78, 0.82, 0.85, 0.88, 0.9}) {
            const Scene scene = scene_at(nu, n, wd, geometry, lattice);
            const double length = scene.length() * wd;  // in d
            if (length < 4 || length > 1e4 || (geometry == Geometry::periodic && wd < 4)) continue;
            BOOST_TEST_CONTEXT("nu " << nu << " N " << n << " W/d " << wd << " geometry " << static_cast<int>(geometry)
                                     << " lattice " << static_cast<int>(lattice)) {
              if (const auto positions = placed(scene)) {
                check_lies_well(scene, *positions);
                ++fitted;
              } else {
                ++refused;
              }
            }
          }
  BOOST_TEST(fitted > 2000);
  BOOST_TEST(refused > 300);
}

BOOST_AUTO_TEST_CASE(the_square_lattice_reaches_0_78) {
  for (const Geometry geometry : {Geometry::channel, Geometry::periodic}) {
    const Scene scene = scene_at(0.78, 900, 30.1, geometry, Lattice::square);  // 30 rows of 30
    BOOST_TEST((plan_lattice(scene).kind == Lattice::square));
    check_lies_well(scene, place_on_lattice(scene));
  }
}

BOOST_AUTO_TEST_CASE(a_square_lattice_of_rows_that_would_touch_is_made_to_zigzag) {
  for (const Geometry geometry : {Geometry::channel, Geometry::periodic}) {
    const Scene scene = scene_at(0.78, 900, 30, geometry, Lattice::square);
    const LatticePlan plan = plan_lattice(scene);
    BOOST_TEST(plan.rows == 30);
    BOOST_TEST(plan.row_shift == 0.1);
    check_lies_well(scene, place_on_lattice(scene));
    // Columns 1.007 d apart shifted by a tenth: rows at d would be sqrt(1 + 0.0101) d = 1.005 d apart.
    BOOST_TEST(plan.nearest * 30 > 1.004);
    BOOST_TEST(plan_lattice(scene_at(0.70, 900, 30.1, geometry, Lattice::square)).row_shift == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_triangular_lattice_reaches_0_90) {
  // 35 rows need W = d (1 + 34 sqrt 3/2) = 30.445 d, where 30 columns at contact are 0.9029.
  const Scene channel = scene_at(0.90, 35 * 30, 30.445, Geometry::channel);
  // 26 rows need W = 26 sqrt 3/2 d = 22.517 d, where columns at contact are 0.9069.
  const Scene periodic = scene_at(0.90, 26 * 30, 22.517, Geometry::periodic);
  for (const Scene& scene : {channel, periodic}) {
    BOOST_TEST((plan_lattice(scene).kind == Lattice::triangular));
    BOOST_TEST(plan_lattice(scene).along_x);
    check_lies_well(scene, place_on_lattice(scene));
  }
}

BOOST_AUTO_TEST_CASE(the_largest_area_fractions_are_those_worked_out_by_hand) {
  const auto largest = [](std::int32_t n, double wd, Geometry geometry, Lattice lattice) {
    return largest_area_fraction(scene_at(0.3, n, wd, geometry, lattice), lattice);
  };
  using std::numbers::pi, std::numbers::sqrt3;
  // All to 5e-6: the least gap of 1e-6 d costs 1e-6 to 2e-6 of nu, a little more where rows interlock.
  // 30 rows or, in zigzag, 31, of 30: pi 900/(4 31 30).
  BOOST_TEST(std::abs(largest(900, 31, Geometry::channel, Lattice::square) - pi * 900 / (4 * 31 * 30)) < 5e-6);
  // The thesis' scene. 35 rows of 26 at contact give pi 900/(4 31 26) = 0.8770; 36 rows of 25, pressed to b = 30 d/35,
  // so that columns are 2 sqrt(1 - (6/7)^2) = 1.0302 d apart, hold more: 0.8853.
  BOOST_TEST(std::abs(largest(900, 31, Geometry::channel, Lattice::triangular) -
                      pi * 900 / (4 * 31 * 25 * 2 * std::sqrt(1 - 36.0 / 49))) < 5e-6);
  // Commensurate: close packing.
  BOOST_TEST(std::abs(largest(676, 13 * sqrt3 * (1 + 2e-6), Geometry::periodic, Lattice::triangular) -
                      pi / (2 * sqrt3)) < 5e-6);
  BOOST_TEST(std::abs(largest(144, 12 * (1 + 2e-6), Geometry::periodic, Lattice::square) - pi / 4) < 5e-6);
  // Rows pressed into zigzag until columns are d apart: b = sqrt(1 - 0.01) d, W/b = 12 at W = 11.9398 d.
  BOOST_TEST(std::abs(largest(144, 12 * std::sqrt(0.99) * (1 + 2e-6), Geometry::periodic, Lattice::square) -
                      pi / (4 * std::sqrt(0.99))) < 5e-6);
  // One row: pi d/(4 W).
  BOOST_TEST(std::abs(largest(10, 1.5, Geometry::channel, Lattice::square) - pi / 6) < 5e-6);
  // Two staggered rows, W = 1.5 d: b = d/2, columns sqrt 3 d apart.
  BOOST_TEST(std::abs(largest(10, 1.5, Geometry::channel, Lattice::triangular) - pi * 10 / (4 * 1.5 * 5 * sqrt3)) <
             5e-6);
  // The period along x stays at least 4 d, however few the disks.
  BOOST_TEST(std::abs(largest(1, 5, Geometry::channel, Lattice::automatic) - pi / (4 * 5 * 4)) < 5e-6);
}

BOOST_AUTO_TEST_CASE(the_largest_area_fraction_fits_and_a_larger_one_does_not) {
  for (const Geometry geometry : {Geometry::channel, Geometry::periodic})
    for (const Lattice lattice : {Lattice::automatic, Lattice::square, Lattice::triangular})
      for (const std::int32_t n : {90, 900, 5000})
        for (const double wd : {4.1, 7.7, 31.0}) {
          const double most = largest_area_fraction(scene_at(0.3, n, wd, geometry), lattice);
          BOOST_TEST_CONTEXT("N " << n << " W/d " << wd << " most " << most) {
            BOOST_CHECK_NO_THROW(
                static_cast<void>(plan_lattice(scene_at(most * (1 - 1e-9), n, wd, geometry, lattice))));
            if (most * 16 * wd > std::numbers::pi * n * (1 - 1e-9)) continue;  // the period itself ends at 4 d
            BOOST_CHECK_THROW(static_cast<void>(plan_lattice(scene_at(most * (1 + 1e-6), n, wd, geometry, lattice))),
                              InputError);
          }
        }
}

BOOST_AUTO_TEST_CASE(auto_is_square_below_0_78_where_it_fits) {
  const auto kind = [](double nu, double wd) { return plan_lattice(scene_at(nu, 900, wd, Geometry::channel)).kind; };
  BOOST_TEST((kind(0.3, 31) == Lattice::square));
  BOOST_TEST((kind(0.76, 31) == Lattice::square));
  BOOST_TEST((kind(0.77, 31) == Lattice::triangular));  // the square lattice ends at 0.7601 here
  BOOST_TEST((kind(0.77, 30) == Lattice::square));
  BOOST_TEST((kind(0.85, 31) == Lattice::triangular));
  BOOST_TEST((kind(0.781, 30.1) == Lattice::triangular));
}

BOOST_AUTO_TEST_CASE(the_dense_scene_of_the_thesis_has_its_rows_along_the_walls) {
  const LatticePlan plan = plan_lattice(scene_at(0.85, 900, 31, Geometry::channel));
  BOOST_TEST(plan.along_x);
  BOOST_TEST(plan.rows == 35);
  BOOST_TEST(plan.columns == 26);
}

BOOST_AUTO_TEST_CASE(the_lattice_is_the_roomiest) {
  // A square box and a square number: equal spacings both ways.
  Scene box = scene_at(0.3, 900, std::sqrt(900 * std::numbers::pi / 1.2), Geometry::periodic);
  box.length_over_width = 1;
  const LatticePlan plan = plan_lattice(box);
  BOOST_TEST(plan.rows == 30);
  BOOST_TEST(plan.nearest == 1.0 / 30);
  // No other number of rows does better, for a few scenes; gaps in x and y only, worked out directly.
  for (const double nu : {0.015, 0.3, 0.7})
    for (const std::int32_t n : {300, 900, 5003}) {
      const Scene scene = scene_at(nu, n, 31, Geometry::channel, Lattice::square);
      const double nearest = plan_lattice(scene).nearest;
      for (std::int32_t rows = 1; rows <= n; ++rows)
        BOOST_TEST(std::min(1.0 / rows, scene.length() / std::ceil(static_cast<double>(n) / rows)) <=
                   nearest * (1 + 1e-15));
    }
}

BOOST_AUTO_TEST_CASE(nearest_is_the_distance_found) {
  for (const Lattice lattice : {Lattice::square, Lattice::triangular})
    for (const Geometry geometry : {Geometry::channel, Geometry::periodic}) {
      const Scene scene = scene_at(0.6, 880, 30, geometry, lattice);
      const double found = (least_gap(scene, place_on_lattice(scene)) + 1) * scene.diameter();
      BOOST_TEST(std::abs(found / plan_lattice(scene).nearest - 1) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(walls_are_as_far_as_a_mirror_image) {
  for (const Lattice lattice : {Lattice::square, Lattice::triangular}) {
    const Scene scene = scene_at(0.5, 900, 31, Geometry::channel, lattice);
    const auto positions = place_on_lattice(scene);
    const auto [low, high] =
        std::minmax_element(positions.begin(), positions.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
    BOOST_TEST(2 * low->y >= plan_lattice(scene).nearest * (1 - 1e-12));
    BOOST_TEST(std::abs(low->y - (1 - high->y)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(vacant_sites_are_spread_over_the_area) {
  for (const std::int32_t n : {871, 885, 899, 9901, 10099}) {
    const Scene scene = scene_at(0.5, n, 31, Geometry::periodic, Lattice::square);
    const LatticePlan plan = plan_lattice(scene);
    const auto positions = place_on_lattice(scene);
    const double vacant = static_cast<double>(plan.rows) * plan.columns - n;
    BOOST_TEST(vacant < plan.rows);
    // Vacant sites per half of the box; the golden-ratio sequence and equal steps both stay within 3 of an even share
    // for less than 1000 terms, and a column or row cut by the half counts for one site more.
    const double half_columns = std::floor(plan.columns / 2.0), half_rows = std::floor(plan.rows / 2.0);
    double left = 0, low = 0;
    for (const Vec2 r : positions) {
      if (r.x < half_columns * plan.column_spacing) ++left;
      if (r.y < half_rows * plan.row_spacing) ++low;
    }
    BOOST_TEST(std::abs(half_columns * plan.rows - left - vacant * half_columns / plan.columns) <= 4);
    BOOST_TEST(std::abs(half_rows * plan.columns - low - vacant * half_rows / plan.rows) <= 4);
  }
}

BOOST_AUTO_TEST_CASE(an_error_says_what_fits_and_what_to_do) {
  const auto message = [](const Scene& scene) -> std::string {
    try {
      static_cast<void>(plan_lattice(scene));
    } catch (const InputError& error) {
      return error.what();
    }
    return "fits";
  };
  BOOST_TEST(message(scene_at(0.89, 900, 31, Geometry::channel)) ==
             "no lattice holds 900 disks at area fraction 0.89 (with W/d = 31 the most that fits is 0.8853): lower "
             "area_fraction (or particles, or lengthen the channel), or choose W/d to suit whole rows");
  BOOST_TEST(
      message(scene_at(0.77, 900, 31, Geometry::channel, Lattice::square)) ==
      "no square lattice holds 900 disks at area fraction 0.77 (with W/d = 31 the most that fits is 0.7600): set "
      "lattice = \"auto\"");
  BOOST_TEST(message(scene_at(0.8853, 900, 31, Geometry::channel)) == "fits");
  BOOST_TEST(message(scene_at(0.7600, 900, 31, Geometry::channel, Lattice::square)) == "fits");
}

BOOST_AUTO_TEST_CASE(a_million_disks_are_placed) {
  const Scene scene = scene_at(0.7, 1000003, 1000, Geometry::periodic);
  BOOST_TEST(place_on_lattice(scene).size() == 1000003u);
}

BOOST_AUTO_TEST_SUITE_END()
