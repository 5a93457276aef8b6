// Channel hydrodynamics: balances, symmetry, order of the grid, and the limits that can be worked out by hand.
#include "gpf/methods/channel_flow.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"

using namespace gpf;

namespace {

Scene channel(double nu, double e, double beta) {
  Scene s;
  s.geometry = Geometry::channel;
  s.particles = 900;
  s.width_over_diameter = 31;
  s.length_over_width = std::numbers::pi * 900 / (4 * nu * 31 * 31);
  s.normal_restitution = e;
  s.wall_tangential_restitution = {beta, beta};
  s.gravity = 1;
  return s;
}

double integral(const ChannelProfile& p, const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum * (p.y[1] - p.y[0]);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(channel_flow_test)

BOOST_AUTO_TEST_CASE(walls_carry_the_weight_and_all_disks_are_there) {
  for (const double nu : {0.05, 0.3, 0.5}) {
    const Scene s = channel(nu, 0.95, 0.8);
    const ChannelProfile p = channel_flow(s);
    const double disks = s.particles / s.length();
    BOOST_TEST(std::abs(p.shear_lower + p.shear_upper - disks) < 1e-6 * disks);
    BOOST_TEST(std::abs(integral(p, p.area_fraction) - s.area_fraction()) < 1e-9);
    BOOST_TEST(p.pressure > 0);
    BOOST_TEST(p.mean_flow > p.slip_lower);
  }
}

BOOST_AUTO_TEST_CASE(equal_walls_give_symmetric_profiles_and_others_do_not) {
  ChannelProfile p = channel_flow(channel(0.3, 0.95, 0.9));
  for (std::size_t k = 0; k < p.y.size(); ++k) {
    const std::size_t m = p.y.size() - 1 - k;
    BOOST_TEST(std::abs(p.mean_velocity[k] - p.mean_velocity[m]) < 1e-6 * p.mean_flow);
    BOOST_TEST(std::abs(p.granular_temperature[k] - p.granular_temperature[m]) < 1e-6 * p.granular_temperature[0]);
  }
  BOOST_TEST(p.area_fraction[50] > p.area_fraction[0]);  // cold and dense in the middle
  BOOST_TEST(p.granular_temperature[50] < p.granular_temperature[0]);
  Scene s = channel(0.3, 0.95, 0.9);
  s.wall_tangential_restitution = {0.1, 0.9};
  p = channel_flow(s);
  BOOST_TEST(p.slip_lower < p.slip_upper);
  BOOST_TEST(p.shear_lower > p.shear_upper);
}

BOOST_AUTO_TEST_CASE(the_error_falls_with_the_square_of_the_cell) {
  const Scene s = channel(0.2, 0.98, 0.7);
  const double exact = channel_flow(s, 320).pressure;
  const double coarse = std::abs(channel_flow(s, 10).pressure - exact),
               fine = std::abs(channel_flow(s, 40).pressure - exact);
  BOOST_TEST(fine < coarse / 10);
  BOOST_TEST(coarse < 0.02 * exact);
}

// Nearly smooth walls: no shear to speak of, all heat is made at the walls' slip, which the boundary condition gives;
// U = (1 + beta)(1 + e_w)/(2(1 - beta)) sqrt(pi T/2) tau/P.
BOOST_AUTO_TEST_CASE(the_slip_is_that_of_a_maxwellian) {
  const ChannelProfile p = channel_flow(channel(0.1, 0.99, 0.9), 400);
  const double wall_temperature = 1.5 * p.granular_temperature[0] - 0.5 * p.granular_temperature[1];
  BOOST_TEST(std::abs(p.slip_lower / (1.9 / 0.1 * std::sqrt(std::numbers::pi * wall_temperature / 2) * p.shear_lower /
                                      p.pressure) -
                      1) < 0.01);
}

// An engine run of this scene (W/d 31, N 900, t from 60 to 260, seed 1) has mean flow 6.479(6), P_yy 1136, T 1.31 and
// nu .322 in the middle and T 1.61 in the second bin: within 3 %.
BOOST_AUTO_TEST_CASE(it_is_close_to_disks_where_it_should_be) {
  const ChannelProfile p = channel_flow(channel(0.3, 0.99, 0.9));
  BOOST_TEST(std::abs(p.mean_flow / 6.479 - 1) < 0.03);
  BOOST_TEST(std::abs(p.pressure / 1136 - 1) < 0.03);
  BOOST_TEST(std::abs(p.granular_temperature[50] / 1.31 - 1) < 0.03);
  BOOST_TEST(std::abs(p.granular_temperature[7] / 1.61 - 1) < 0.05);
  BOOST_TEST(std::abs(p.area_fraction[50] / 0.322 - 1) < 0.03);
}

// Everything scales: g to 4 g at the same geometry gives twice the velocities and four times the temperatures.
BOOST_AUTO_TEST_CASE(gravity_sets_the_unit_of_velocity) {
  Scene s = channel(0.3, 0.95, 0.9);
  const ChannelProfile one = channel_flow(s);
  s.gravity = 4;
  const ChannelProfile four = channel_flow(s);
  BOOST_TEST(std::abs(four.mean_flow / one.mean_flow - 2) < 1e-6);
  s.gravity = 1e10;
  BOOST_TEST(std::abs(channel_flow(s).mean_flow / one.mean_flow / 1e5 - 1) < 1e-6);
  BOOST_TEST(std::abs(four.granular_temperature[30] / one.granular_temperature[30] - 4) < 1e-6);
}

BOOST_AUTO_TEST_CASE(what_it_cannot_solve_is_refused) {
  Scene s = channel(0.3, 0.95, 1);
  BOOST_CHECK_THROW(channel_flow(s), InputError);
  s = channel(0.3, 0.95, 0.9);
  BOOST_CHECK_THROW(channel_flow(s, 7), InputError);
  BOOST_CHECK_THROW(channel_flow(channel(0.6, 0.6, 0.9)), PhysicsError);  // packed
  s.geometry = Geometry::periodic;
  BOOST_CHECK_THROW(channel_flow(s), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
