#include "gpf/measure/measurement.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"

using namespace gpf;
namespace tt = boost::test_tools;

namespace {

Scene scene_of(std::int32_t disks, double gravity) {
  Scene s;
  s.geometry = Geometry::channel;
  s.particles = disks;
  s.width_over_diameter = 5;  // d = 0.2
  s.length_over_width = 2;
  s.gravity = gravity;
  return s;
}

double last(const Measurement& m, Tally t, int k = 0) {
  const auto sums = m.series().sums();
  return sums[(m.series().blocks() - 1) * m.layout().size() + m.layout().at(t, k)];
}

}  // namespace

BOOST_AUTO_TEST_SUITE(measurement)

BOOST_AUTO_TEST_CASE(fields_are_sums_over_the_disks_of_a_bin) {
  Measurement m(scene_of(3, 0), 2);
  const State state{{{0, 0.2}, {0, 0.4}, {0, 0.7}}, {{1, 2}, {3, -2}, {5, 0.5}}};
  m.begin(0, state);
  m.sample(0.25, state);
  BOOST_TEST(last(m, Tally::measured_time) == 0.25);
  BOOST_TEST(last(m, Tally::count, 0) == 2);
  BOOST_TEST(last(m, Tally::freedom, 0) == 1);
  BOOST_TEST(last(m, Tally::freedom, 1) == 0);
  BOOST_TEST(last(m, Tally::cx, 0) == 4);
  BOOST_TEST(last(m, Tally::cx2, 0) == 10);
  BOOST_TEST(last(m, Tally::cx4, 0) == 82);
  BOOST_TEST(last(m, Tally::cy3, 1) == 0.125);
  BOOST_TEST(last(m, Tally::cxcy, 0) == -4);
  BOOST_TEST(last(m, Tally::ux2, 0) == 2);  // 1 and 3 about 2
  BOOST_TEST(last(m, Tally::ux4, 0) == 2);
  BOOST_TEST(last(m, Tally::ux2, 1) == 0);  // a single disk has no fluctuation
  BOOST_TEST(last(m, Tally::momentum) == 9);
  BOOST_TEST(last(m, Tally::energy) == 0.5 * (5 + 13 + 25.25));
}

BOOST_AUTO_TEST_CASE(a_pair_contact_spreads_its_stress_along_the_line_of_centres) {
  Measurement m(scene_of(2, 0), 4);
  const State state{{{0, 0.2}, {0, 0.3}}, {{0, 0}, {0, 0}}};
  m.begin(0, state);
  // Centres at y = .2 and .3, the line crosses the side between the bins at .25 in its middle.
  m.on_pair({0.1, 0, 1, {0, 0.2}, {0.15, 0.1}, {0, 0}, {0, 0}, {3, 2}, 0.7});
  m.sample(1, state);
  BOOST_TEST(last(m, Tally::virial) == 3 * 0.15 + 2 * 0.1, tt::tolerance(1e-14));
  BOOST_TEST(last(m, Tally::pair_loss) == 0.7);
  for (const int bin : {0, 1}) {
    BOOST_TEST(last(m, Tally::stress_xx, bin) == 0.5 * 3 * 0.15, tt::tolerance(1e-12));
    BOOST_TEST(last(m, Tally::stress_xy, bin) == 0.5 * 3 * 0.1, tt::tolerance(1e-12));
    BOOST_TEST(last(m, Tally::stress_yy, bin) == 0.5 * 2 * 0.1, tt::tolerance(1e-12));
  }
  BOOST_TEST(last(m, Tally::stress_xx, 2) == 0);
}

BOOST_AUTO_TEST_CASE(a_wall_contact_counts_impulse_loss_and_the_half_diameter_to_the_wall) {
  Measurement m(scene_of(1, 0), 5);  // bins of 0.2: the wall's line of d/2 = 0.1 lies in the outermost ones
  const State state{{{0, 0.1}}, {{2, -1}}};
  m.begin(0, state);
  m.on_wall({0.5, 0, Wall::lower, {0, 0.1}, {2, -1}, {1.5, 1}});
  m.on_wall({0.6, 0, Wall::upper, {0, 0.9}, {1.5, 1}, {1.2, -1}});
  m.sample(1, state);
  BOOST_TEST(last(m, Tally::wall_normal, 0) == 2);
  BOOST_TEST(last(m, Tally::wall_normal, 1) == 2);
  BOOST_TEST(last(m, Tally::wall_tangential, 0) == 0.5);
  BOOST_TEST(last(m, Tally::wall_loss, 0) == 0.5 * (4 - 2.25), tt::tolerance(1e-14));
  BOOST_TEST(last(m, Tally::stress_yy, 0) == 2 * 0.1, tt::tolerance(1e-14));
  BOOST_TEST(last(m, Tally::stress_yy, 4) == 2 * 0.1, tt::tolerance(1e-14));
  BOOST_TEST(last(m, Tally::stress_xy, 0) == -0.5 * 0.1, tt::tolerance(1e-14));  // momentum flows to the wall, along -y
  BOOST_TEST(last(m, Tally::stress_xy, 4) == 0.3 * 0.1, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(gravity_work_is_weight_times_fall_through_wall_contacts) {
  // One disk under g = 3: from rest for 0.5, then the wall halves its velocity, then 0.25 more.
  const double g = 3, v1 = g * 0.5, v2 = v1 / 2, v3 = v2 + g * 0.25;
  Measurement m(scene_of(1, g), 1);
  m.begin(0, {{{0, 0.5}}, {{0, 0}}});
  m.on_wall({0.5, 0, Wall::lower, {0, 0.1}, {v1, -1}, {v2, 1}});
  m.sample(0.75, {{{0, 0.5}}, {{v3, 0}}});
  const double fall = 0.5 * g * 0.25 + v2 * 0.25 + 0.5 * g * 0.0625;
  BOOST_TEST(last(m, Tally::gravity_work) == g * fall, tt::tolerance(1e-14));
  BOOST_TEST(last(m, Tally::energy_change) == 0.5 * v3 * v3, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_free_path_is_the_lab_displacement_between_pair_contacts_of_a_disk) {
  Measurement m(scene_of(2, 2), 1);  // g = 2
  const State state{{{0, 0.3}, {0.2, 0.3}}, {{1, 0}, {0, 0}}};
  m.begin(0, state);
  const auto touch = [&](double t, Vec2 v1, Vec2 v2) { m.on_pair({t, 0, 1, {0, 0.3}, {0.2, 0}, v1, v2, {1, 0}, 0}); };
  touch(1, {0, 3}, {-1, 0});
  m.on_wall({1.5, 0, Wall::upper, {0, 0.9}, {1, 3}, {0.5, -3}});  // disk 0 turns round half-way
  touch(2, {0, 0}, {0, 0});
  m.sample(3, state);
  // Disk 0: (0, 1.5) + g/2 .25 along x, then (.25, -1.5) + g/2 .25: displacement (0.75, 0).
  // Disk 1: (-1, 0) + g/2 along x for one unit: (0, 0).
  BOOST_TEST(last(m, Tally::free_paths) == 2);
  BOOST_TEST(last(m, Tally::free_path) == 0.75, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(contacts_before_the_beginning_do_not_count) {
  Measurement m(scene_of(2, 0), 1);
  const State state{{{0, 0.3}, {0.2, 0.3}}, {{1, 0}, {0, 0}}};
  m.on_pair({0.5, 0, 1, {0, 0.3}, {0.2, 0}, {}, {}, {1, 0}, 0.1});
  m.on_wall({0.6, 0, Wall::lower, {0, 0.1}, {1, -1}, {1, 1}});
  m.begin(1, state);
  m.sample(2, state);
  BOOST_TEST(last(m, Tally::pair_contacts) == 0);
  BOOST_TEST(last(m, Tally::wall_contacts, 0) == 0);
}

BOOST_AUTO_TEST_CASE(memory_of_another_scene_is_refused) {
  Measurement two(scene_of(2, 1), 4), three(scene_of(3, 1), 4);
  BOOST_CHECK_THROW(three.restore(two.memory()), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
