// The cell grid: who is found, when a disk leaves its cell, and that crossings lose nothing.
#include "gpf/event/cells.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "gpf/base/random.hpp"
#include "gpf/event/plan.hpp"
#include "gpf/event/position_grid.hpp"
#include "support/scenes.hpp"

using namespace gpf;

namespace {

/// A grid of cells with disks anywhere (overlaps do not matter here), all at time 0 unless said otherwise.
struct Filled {
  Filled(const Scene& scene_, double disks_per_cell)
      : scene(scene_),
        channel(scene.geometry == Geometry::channel),
        grid(scene.length(), 1),
        length(grid.round(scene.length())),
        lower(channel ? grid.round(scene.diameter() / 2) : 0),
        cells(scene, lower, 1 - lower, length, disks_per_cell),
        contact_time(scene.diameter()) {
    for (Index i = 0; i < scene.particles; ++i) {
      const auto words = random_words(scene.seed, 2, static_cast<std::uint64_t>(i));
      const Vec2 v = gaussian_pair(scene.seed, static_cast<std::uint64_t>(i));
      flights.push_back({grid.round(length * words[0] * 0x1p-32),
                         grid.round(lower + (1 - 2 * lower) * words[1] * 0x1p-32), v.x, v.y, 0});
      places.push_back(cells.locate(flights.back()));
      cells.insert(places.back(), i);
      disks.push_back({.flight = flights.back(), .id = i});
    }
    disks.push_back({.flight = {std::nan(""), std::nan(""), 0, 0, 0}});
  }

  FoundContact earliest(Index i, Block block, FoundContact known = {}) {
    const auto k = static_cast<std::size_t>(i);
    std::array questions{Cells::Question{places[k], disks[k].flight, known}};
    cells.answer<false>(questions, block, disks.data(), scene.particles, contact_time);
    return questions[0].contact;
  }

  /// All disks turn round, where they are.
  void turn() {
    for (std::size_t i = 0; i < flights.size(); ++i) {
      flights[i].vx *= -1, flights[i].vy *= -1;
      disks[i].flight = flights[i];
      cells.settle(places[i], static_cast<Index>(i), flights[i]);
    }
  }

  /// Whom disk i meets among a block of cells around it, and when: asks for the earliest until all are taken. None may
  /// be offered twice, nor out of order.
  std::map<Index, double> met(Index i, Block block) {
    std::map<Index, double> found;
    double last = 0;
    for (FoundContact next = earliest(i, block); next.partner >= 0; next = earliest(i, block)) {
      BOOST_REQUIRE(next.time >= last);
      BOOST_REQUIRE(found.emplace(next.partner, next.time).second);
      last = next.time;
      disks[static_cast<std::size_t>(next.partner)].contact = -never;  // now it is no partner
    }
    for (const auto& [j, time] : found) disks[static_cast<std::size_t>(j)].contact = never;
    return found;
  }

  Scene scene;
  bool channel;
  PositionGrid grid;
  double length, lower;
  Cells cells;
  ContactTime contact_time;
  std::vector<Flight> flights;
  std::vector<Place> places;
  std::vector<Disk> disks;  // the last is nobody
};

/// The cell at a position.
Place cell_at(const Cells& cells, double x, double y) { return cells.locate({x, y, 0, 0, 0}); }

std::vector<Scene> scenes() {
  Scene one_row = test::channel(40, 0.3, 1.8);
  Scene smallest = test::gas(12, 0.3);
  smallest.length_over_width = 1;
  smallest.width_over_diameter = 3.1;
  return {test::gas(400, 0.1), test::gas(50, 0.6), test::channel(300, 0.4, 9.3), one_row, smallest};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cells)

BOOST_AUTO_TEST_CASE(no_narrower_than_a_disk_and_about_as_many_as_asked_for) {
  for (const Scene& scene : scenes())
    for (const double per_cell : {0.3, 1.0, 4.0, 50.0}) {
      const Filled f(scene, per_cell);
      // Two places a diameter apart in x lie in the same cell or in neighbours, the last and the first included.
      const double d = scene.diameter();
      for (double x = 0; x < scene.length(); x += 0.13 * d) {
        const Index from = cell_at(f.cells, x, 0.5).column, last = cell_at(f.cells, f.length, 0.5).column;
        const Index to = cell_at(f.cells, std::fmod(x + d, f.length), 0.5).column;
        BOOST_TEST((to - from == 0 || to - from == 1 || (from == last && to == 0)));
      }
      BOOST_TEST(f.cells.size() >= 3u);
      if (per_cell * scene.particles < 0.1 * scene.length() / square(d) && !f.channel)
        BOOST_TEST(static_cast<double>(f.cells.size()) <= scene.particles / per_cell * 1.01 + 9);
    }
}

BOOST_AUTO_TEST_CASE(a_row_has_a_number_that_a_plan_has_room_for) {
  Scene scene;
  scene.geometry = Geometry::periodic;
  scene.particles = 10;
  scene.width_over_diameter = 1e5;
  scene.length_over_width = 1e-4;
  const double length = scene.length();
  Cells cells(scene, 0, 1, length, 1e-12);
  BOOST_TEST(cells.size() == std::size_t{9} * 65536u);
  Plan plan;
  plan.move_to(cells.locate({length * (1 - 0x1p-40), 1 - 0x1p-40, 0, 0, 0}));
  BOOST_TEST((plan.place() == Place{8, 65535}));
}

BOOST_AUTO_TEST_CASE(each_cell_has_an_order_of_its_own_and_tiles_lie_together) {
  for (const Scene& scene : scenes()) {
    const Filled f(scene, 1);
    const Place last = f.cells.locate({f.length, 1, 0, 0, 0});
    std::map<std::size_t, Place> cells;
    for (Index row = 0; row <= last.row; ++row)
      for (Index column = 0; column <= last.column; ++column) {
        BOOST_REQUIRE(f.cells.order({column, row}) < f.cells.orders());
        BOOST_REQUIRE(f.cells.order({column, row}) / 64 == f.cells.order({column / 8 * 8, row / 8 * 8}) / 64);
        cells[f.cells.order({column, row})] = {column, row};
      }
    BOOST_TEST(cells.size() == f.cells.size());
  }
}

BOOST_AUTO_TEST_CASE(places_outside_belong_to_the_nearest_cell) {
  const Filled f(test::gas(400, 0.1), 1);
  for (const double y : {-1e-16, 0.0, 0.7, 1.0}) {
    BOOST_TEST(cell_at(f.cells, -1e-15, y).column == 0);
    BOOST_TEST(cell_at(f.cells, f.length, y).column == cell_at(f.cells, f.length * (1 - 1e-9), y).column);
  }
  BOOST_TEST(cell_at(f.cells, 0.5, -1e-17).row == 0);
  BOOST_TEST(cell_at(f.cells, 0.5, 1).row == cell_at(f.cells, 0.5, 0.999999).row);
}

BOOST_AUTO_TEST_CASE(a_removed_disk_is_met_no_more) {
  Filled f(test::gas(400, 0.1), 1);
  // Half of the disks go; the others must meet exactly the rest of whom they met before.
  std::vector<std::map<Index, double>> before;
  for (Index i = 0; i < 400; ++i) before.push_back(f.met(i, Block::all));
  for (Index i = 1; i < 400; i += 2) f.cells.remove(f.places[static_cast<std::size_t>(i)], i);
  for (Index i = 0; i < 400; i += 2) {
    auto expected = before[static_cast<std::size_t>(i)];
    std::erase_if(expected, [](const auto& met) { return met.first % 2 == 1; });
    BOOST_TEST((f.met(i, Block::all) == expected));
  }
  f.cells.divide(1);
  BOOST_TEST(f.met(0, Block::all).empty());
}

BOOST_AUTO_TEST_CASE(whoever_meets_within_a_cell_side_is_found_at_the_time_of_the_nearest_image) {
  // Few and many disks per cell (cells overflow), edges and corners included. A pair that touches before either could
  // come from beyond the neighbouring cells is within a diameter of reach of it, hence nearer than a cell's side.
  for (const Scene& scene : scenes())
    for (const double per_cell : {0.5, 2.0, 20.0, 400.0}) {
      Filled f(scene, per_cell);
      const double d = scene.diameter();
      for (Index i = 0; i < scene.particles; ++i) {
        const auto found = f.met(i, Block::all);
        const Flight a = f.flights[static_cast<std::size_t>(i)];
        for (Index j = 0; j < scene.particles; ++j) {
          const Flight b = f.flights[static_cast<std::size_t>(j)];
          const double shift_x = -f.length * std::round((b.x - a.x) / f.length);
          const double shift_y = f.channel ? 0 : -std::round(b.y - a.y);
          if (std::hypot(b.x - a.x + shift_x, b.y - a.y + shift_y) > d) continue;
          const auto e = f.contact_time.encounter(a, b, shift_x, shift_y);
          const auto known = found.find(j);
          BOOST_REQUIRE((known != found.end()) == e.meet());
          if (e.meet()) BOOST_REQUIRE(known->second == f.contact_time.contact(e, 0, 0.0));
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(the_earliest_is_that_of_all_and_of_those_known_and_of_equal_times_the_lowest_id) {
  for (const double per_cell : {0.5, 20.0}) {
    Filled f(test::gas(400, 0.1), per_cell);
    for (Index i = 0; i < 400; ++i) {
      const auto all = f.met(i, Block::all);
      if (all.size() < 2) continue;
      const FoundContact first = f.earliest(i, Block::all);
      for (const auto& [j, time] : all) BOOST_REQUIRE(first.time <= time);
      BOOST_REQUIRE(all.at(first.partner) == first.time);
      // A contact known before stays unless another is earlier, or as early and of a lower id.
      const Index other = first.partner == 7 ? 8 : 7;
      BOOST_REQUIRE(f.earliest(i, Block::all, {first.time / 2, other}).partner == other);
      BOOST_REQUIRE(f.earliest(i, Block::all, {2 * first.time + 1, other}).partner == first.partner);
      BOOST_REQUIRE(f.earliest(i, Block::all, {first.time, other}).partner == std::min(other, first.partner));
      // A partner that collides before is none.
      auto& theirs = f.disks[static_cast<std::size_t>(first.partner)].contact;
      theirs = first.time;
      BOOST_REQUIRE(f.earliest(i, Block::all).partner == first.partner);
      theirs = std::nextafter(first.time, -1);
      BOOST_REQUIRE(f.earliest(i, Block::all).partner != first.partner);
      theirs = never;
    }
  }
}

BOOST_AUTO_TEST_CASE(two_that_ask_together_find_what_each_finds_alone) {
  // Some with neighbours round the box and some without, few and many disks in a cell, overflowing ones too.
  for (const Scene& scene : scenes())
    for (const double per_cell : {0.5, 5.0, 20.0}) {
      Filled f(scene, per_cell);
      for (Index i = 0; i + 1 < scene.particles; ++i) {
        std::array<FoundContact, 2> found;
        std::array<Cells::Question, 2> both;
        for (std::size_t n = 0; n < 2; ++n) {
          const std::size_t k = static_cast<std::size_t>(i) + n;
          both[n] = {f.places[k], f.disks[k].flight, {}};
          found[n] = f.earliest(static_cast<Index>(k), Block::all);
        }
        f.cells.answer<false>(both, Block::all, f.disks.data(), scene.particles, f.contact_time);
        for (std::size_t n = 0; n < 2; ++n)
          BOOST_REQUIRE((both[n].contact.partner == found[n].partner && both[n].contact.time == found[n].time));
      }
    }
}

BOOST_AUTO_TEST_CASE(what_one_disk_finds_the_other_finds_at_the_same_time_to_the_bit) {
  for (const Scene& scene : scenes())
    for (const double per_cell : {0.5, 5.0}) {
      Filled f(scene, per_cell);
      for (Index i = 0; i < scene.particles; ++i)
        for (const auto& [j, time] : f.met(i, Block::all)) {
          const auto back = f.met(j, Block::all);
          BOOST_REQUIRE(back.count(i) == 1u);
          BOOST_REQUIRE(back.at(i) == time);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_disk_leaves_its_cell_when_and_where_it_should) {
  for (const Scene& scene : scenes()) {
    Filled f(scene, 1);
    for (std::size_t i = 0; i < f.flights.size(); ++i) {
      const Flight a = f.flights[i];
      const Cells::Exit exit = f.cells.exit(f.places[i], a);
      BOOST_REQUIRE(exit.time >= 0);
      const Vec2 out{a.x + a.vx * exit.time, a.y + a.vy * exit.time};
      if (f.cells.is_wall(f.places[i], exit.side)) {
        BOOST_TEST(f.channel);
        BOOST_TEST((exit.side == (a.vy < 0 ? Side::lower : Side::upper)));
        BOOST_TEST(std::abs(out.y - (a.vy < 0 ? f.lower : 1 - f.lower)) < 1e-15);
        continue;
      }
      const Cells::Beyond beyond = f.cells.beyond(f.places[i], exit.side);
      if (beyond.x != 0 || beyond.y != 0) {  // at the side of the box, no later
        const double round = beyond.x != 0 ? out.x - (beyond.x > 0 ? f.length : 0) : out.y - (beyond.y > 0 ? 1 : 0);
        BOOST_TEST(std::abs(round) < 1e-15 * (1 + f.length));
        continue;
      }
      // It is well inside the next cell when it leaves; it may have been outside of the other two sides before.
      const Place next = cell_at(f.cells, out.x, out.y);
      const Index columns = next.column - f.places[i].column, rows = next.row - f.places[i].row;
      const bool sideways = exit.side == Side::left || exit.side == Side::right;
      BOOST_TEST((sideways ? columns : rows) == (exit.side == Side::right || exit.side == Side::upper ? 1 : -1));
      BOOST_TEST(std::abs(sideways ? rows : columns) <= 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(disks_whose_cells_are_no_neighbours_do_not_touch_before_one_leaves) {
  for (const Scene& scene : scenes())
    for (const double per_cell : {0.5, 1.0, 5.0}) {
      Filled f(scene, per_cell);
      f.turn();
      std::size_t asked = 0;
      double nearest = never;
      for (std::size_t i = 0; i < f.flights.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const Flight &a = f.flights[i], &b = f.flights[j];
          const auto reaches = [&] {
            for (const auto& [x, y] :
                 {std::pair{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}) {
              Place place = f.places[i];
              if (x != 0) place = f.cells.beyond(place, x < 0 ? Side::left : Side::right).place;
              if (y != 0) place = f.cells.beyond(place, y < 0 ? Side::lower : Side::upper).place;
              if (place.column == f.places[j].column && place.row == f.places[j].row) return true;
            }
            return false;
          };
          if (reaches()) continue;
          ++asked;
          const double until = std::min(f.cells.exit(f.places[i], a).time, f.cells.exit(f.places[j], b).time);
          double x = b.x - a.x, y = b.y - a.y;
          x -= f.length * std::round(x / f.length), y -= f.channel ? 0 : std::round(y);
          // Nearest on the way there, if that is still to come: at -r.u/u^2.
          const double ux = b.vx - a.vx, uy = b.vy - a.vy;
          const double t = std::clamp(-(x * ux + y * uy) / (ux * ux + uy * uy), 0.0, until);
          nearest = std::min(nearest, std::hypot(x + ux * t, y + uy * t));
        }
      BOOST_TEST((asked == 0 || nearest >= scene.diameter()));
      if (per_cell == 1.0 && f.cells.size() > 9) BOOST_TEST(asked > 0U);
    }
}

BOOST_AUTO_TEST_CASE(a_disk_that_begins_a_flight_is_put_where_it_stays_longest) {
  // Of the cells around it that it is in, or outside of by no more than half of what they are wider than a disk.
  for (const Scene& scene : scenes())
    for (const double per_cell : {0.5, 1.0, 5.0}) {
      Filled f(scene, per_cell);
      const Place last = cell_at(f.cells, f.length, 1 - f.lower);
      const double width = f.length / (last.column + 1), height = (1 - 2 * f.lower) / (last.row + 1);
      const auto outside = [d = scene.diameter()](double r, Index cell, double side) {
        return std::max({0.0, cell * side - r, r - (cell + 1) * side}) - std::max(0.0, (side - d) / 2) - 1e-12;
      };
      std::size_t moved = 0;
      for (std::size_t i = 0; i < f.flights.size(); ++i) {
        const Flight& a = f.flights[i];
        const Place here = cell_at(f.cells, a.x, a.y), there = f.places[i];
        double longest = 0;
        for (Index row = std::max(here.row - 1, 0); row <= std::min(here.row + 1, last.row); ++row)
          for (Index column = std::max(here.column - 1, 0); column <= std::min(here.column + 1, last.column);
               ++column) {
            const bool may = outside(a.x, column, width) <= 0 && outside(a.y - f.lower, row, height) <= 0;
            if (may) longest = std::max(longest, f.cells.exit({column, row}, a).time);
            if (column == there.column && row == there.row) BOOST_TEST(may);
          }
        BOOST_TEST(std::abs(f.cells.exit(there, a).time - longest) <= 1e-9 * longest);
        moved += here.column != there.column || here.row != there.row ? 1 : 0;
      }
      BOOST_TEST((moved > f.flights.size() / 10 || width < 1.5 * scene.diameter()));
      // It was moved to its place, and is nowhere else: when all are taken out of their places, nobody is left.
      f.turn();
      for (Index i = 0; i < scene.particles; ++i) f.cells.remove(f.places[static_cast<std::size_t>(i)], i);
      for (Index i = 0; i < scene.particles; ++i) BOOST_REQUIRE(f.met(i, Block::all).empty());
    }
}

BOOST_AUTO_TEST_CASE(in_roomy_cells_disks_that_turn_round_often_change_them) {
  // In cells 1.2 d wide a sixth of the places along each side may belong to either of two: 1 - (5/6)^2 = .31.
  for (const double area_fraction : {0.05, 0.3, 0.5, 0.58, 0.7}) {
    Filled f(test::gas(4000, area_fraction), 1);
    const std::vector<Place> before = f.places;
    f.turn();
    int moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) moved += before[i] == f.places[i] ? 0 : 1;
    BOOST_TEST(f.cells.are_roomy() == (moved > 0.31 * f.scene.particles));
    BOOST_TEST(f.cells.are_roomy() == (area_fraction < 0.54));
  }
}

BOOST_AUTO_TEST_CASE(a_disk_at_rest_never_leaves) {
  Filled f(test::gas(50, 0.1), 1);
  const Cells::Exit exit = f.cells.exit(f.places[0], {f.flights[0].x, f.flights[0].y, 0, 0, 0});
  BOOST_TEST(exit.time == never);
}

BOOST_AUTO_TEST_CASE(beyond_its_last_side_a_disk_leaves_at_once) {
  // Round-off may put a disk a hair outside its cell: it leaves now, not in the past.
  Filled f(test::gas(50, 0.1), 1);
  const Place corner = cell_at(f.cells, 0, 0);
  BOOST_TEST(f.cells.exit(corner, {-1e-15, 0.01, -1, 0, 3}).time == 3);
  Filled c(test::channel(50, 0.1, 9.3), 1);
  const Cells::Exit exit = c.cells.exit(cell_at(c.cells, 0.1, c.lower), {0.1, c.lower - 1e-15, 0, -1, 3});
  BOOST_TEST(exit.time == 3);
  BOOST_TEST((exit.side == Side::lower && c.cells.is_wall(cell_at(c.cells, 0.1, c.lower), exit.side)));
}

BOOST_AUTO_TEST_CASE(crossing_shows_all_new_neighbours_and_shifts_by_a_period_exactly) {
  // Disks walk through the grid, sideways, up and down, until they go round the box. After each step the cells ahead
  // must offer whatever the old neighbourhood did not.
  for (const Scene& scene : scenes())
    for (const double per_cell : {0.5, 5.0}) {
      Filled f(scene, per_cell);
      for (Index i = 0; i < std::min(scene.particles, 40); ++i) {
        const auto k = static_cast<std::size_t>(i);
        for (int step = 0; step < 30; ++step) {
          const Flight a = f.disks[k].flight;
          const Cells::Exit exit = f.cells.exit(f.places[k], a);
          if (f.cells.is_wall(f.places[k], exit.side)) break;
          auto known = f.met(i, Block::all);
          const bool round = f.cells.cross(f.places[k], i, exit.side, f.disks[k].flight);
          const Flight b = f.disks[k].flight;
          BOOST_REQUIRE((b.x == a.x || b.x == a.x - f.length || b.x == a.x + f.length));
          BOOST_REQUIRE((b.y == a.y || b.y == a.y - 1 || b.y == a.y + 1));
          BOOST_REQUIRE(round == (b.x != a.x || b.y != a.y));
          BOOST_REQUIRE((b.vx == a.vx && b.vy == a.vy && b.time == a.time));
          // In a box of three cells the disks ahead were behind as well, in another image.
          for (const auto& [j, time] : f.met(i, ahead(exit.side))) known[j] = time;
          for (const auto& [j, time] : f.met(i, Block::all)) {
            BOOST_REQUIRE(known.count(j) == 1u);
            BOOST_REQUIRE(known[j] == time);
          }
          if (round) break;  // here the engine lets the disk enter the box with a new flight
        }
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
