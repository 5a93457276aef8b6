// Channel hydrodynamics: balances, symmetry, order of the grid, and the limits that can be worked out by hand.
#include "gpf/methods/channel_flow.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"
#include "gpf/theory/contact_value.hpp"
#include "gpf/theory/garzo_dufty.hpp"

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

constexpr auto closures = {Closure::jenkins_richman, Closure::garzo_dufty};

double integral(const ChannelProfile& p, const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum * (p.y[1] - p.y[0]);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(channel_flow_test)

BOOST_AUTO_TEST_CASE(walls_carry_the_weight_and_all_disks_are_there) {
  for (const Closure closure : closures)
    for (const double nu : {0.05, 0.3, 0.5}) {
      const Scene s = channel(nu, 0.95, 0.8);
      const ChannelProfile p = channel_flow(s, {.closure = closure});
      const double disks = s.particles / s.length();
      BOOST_TEST(std::abs(p.shear_lower + p.shear_upper - disks) < 1e-6 * disks);
      BOOST_TEST(std::abs(integral(p, p.area_fraction) - s.area_fraction()) < 1e-9);
      BOOST_TEST(p.pressure > 0);
      BOOST_TEST(p.mean_flow > p.slip_lower);
    }
}

// Gravity's power goes into collisions, into the walls' heat and into friction at the slip. Sums over the cells
// telescope, so that this holds on any grid.
BOOST_AUTO_TEST_CASE(power_of_gravity_is_dissipated) {
  for (const Closure closure : closures) {
    Scene s = channel(0.3, 0.8, 0.5);
    s.wall_normal_restitution = 0.9;
    s.wall_tangential_restitution[1] = -0.3;
    s.gravity = 2;
    const ChannelProfile p = channel_flow(s, {.cells = 40, .closure = closure});
    std::vector<double> loss;
    for (std::size_t k = 0; k < p.y.size(); ++k) {
      const double nu = p.area_fraction[k];
      const Gas gas{nu, p.granular_temperature[k], s.diameter(), henderson_contact_value(nu)};
      loss.push_back(closure == Closure::garzo_dufty ? garzo_dufty_dissipation_rate(gas, 0.8)
                                                     : dissipation_rate(gas, 0.8));
    }
    const double power = s.particles / s.length() * s.gravity * p.mean_flow;
    const double walls = p.heat_lower + p.heat_upper + p.shear_lower * p.slip_lower + p.shear_upper * p.slip_upper;
    BOOST_TEST(p.heat_lower > 0);
    BOOST_TEST(p.heat_upper > p.heat_lower);
    BOOST_TEST(std::abs((integral(p, loss) + walls) / power - 1) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(elastic_disks_do_not_tell_the_closures_apart) {
  const Scene s = channel(0.3, 1, 0.5);
  const ChannelProfile one = channel_flow(s), other = channel_flow(s, {.closure = Closure::garzo_dufty});
  for (std::size_t k = 0; k < one.y.size(); ++k) {
    BOOST_TEST(std::abs(one.mean_velocity[k] / other.mean_velocity[k] - 1) < 1e-7);
    BOOST_TEST(std::abs(one.granular_temperature[k] / other.granular_temperature[k] - 1) < 1e-7);
    BOOST_TEST(std::abs(one.area_fraction[k] / other.area_fraction[k] - 1) < 1e-7);
  }
}

// 24 engine runs of this scene (W/d 31, N 900, t from 100 to 180) have mean flow 20.25(3): Jenkins & Richman are 15 %
// below, Garzo & Dufty 8 %. The density gradient drives heat out of the dense plug, which is colder and denser for it.
BOOST_AUTO_TEST_CASE(inelastic_disks_flow_faster_with_the_inelastic_closure) {
  const Scene s = channel(0.3, 0.8, 0.9);
  const ChannelProfile near_elastic = channel_flow(s), inelastic = channel_flow(s, {.closure = Closure::garzo_dufty});
  BOOST_TEST(std::abs(near_elastic.mean_flow / 20.25 + 0.15 - 1) < 0.02);
  BOOST_TEST(std::abs(inelastic.mean_flow / 20.25 + 0.08 - 1) < 0.02);
  BOOST_TEST(inelastic.area_fraction[50] > near_elastic.area_fraction[50]);
  BOOST_TEST(inelastic.granular_temperature[50] < near_elastic.granular_temperature[50]);
}

// The walls hardly hold such a gas: one-sided differences do not get there.
BOOST_AUTO_TEST_CASE(thin_gases_between_nearly_smooth_walls_converge) {
  Scene s = channel(0.0019, 0.839, 0.93);
  s.wall_normal_restitution = 0.58;
  for (const Closure closure : closures) {
    const ChannelProfile p = channel_flow(s, {.closure = closure});
    BOOST_TEST(p.newton_steps < 40);
    BOOST_TEST(std::abs(p.shear_lower / p.shear_upper - 1) < 1e-6);
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

// Richardson: three grids, each twice as fine, give the ratio of the errors' differences, 4 at second order.
BOOST_AUTO_TEST_CASE(the_error_falls_with_the_square_of_the_cell) {
  for (const Closure closure : closures)
    for (const double e : {0.98, 0.8}) {
      const Scene s = channel(0.2, e, 0.7);
      const auto at = [&](int cells) { return channel_flow(s, {.cells = cells, .closure = closure}); };
      const ChannelProfile coarse = at(40), middle = at(80), fine = at(160);
      const double pressures = (coarse.pressure - middle.pressure) / (middle.pressure - fine.pressure),
                   flows = (coarse.mean_flow - middle.mean_flow) / (middle.mean_flow - fine.mean_flow);
      BOOST_TEST(std::abs(pressures - 4) < 0.1);
      if (e < 0.9) BOOST_TEST(std::abs(flows - 4) < 0.2);  // at .98 the errors of the flow are round-off, 1e-6
      BOOST_TEST(std::abs(coarse.pressure / fine.pressure - 1) < 0.01);
      BOOST_TEST(std::abs(coarse.mean_flow / fine.mean_flow - 1) < 0.001);
    }
}

// Nearly smooth walls: no shear to speak of, all heat is made at the walls' slip, which the boundary condition gives;
// U = (1 + beta)(1 + e_w)/(2(1 - beta)) sqrt(pi T/2) tau/P.
BOOST_AUTO_TEST_CASE(the_slip_is_that_of_a_maxwellian) {
  const ChannelProfile p = channel_flow(channel(0.1, 0.99, 0.9), {.cells = 400});
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
  BOOST_CHECK_THROW(channel_flow(s, {.cells = 7}), InputError);
  for (const Closure closure : closures)
    BOOST_CHECK_THROW(channel_flow(channel(0.6, 0.6, 0.9), {.closure = closure}), PhysicsError);  // packed
  s.geometry = Geometry::periodic;
  BOOST_CHECK_THROW(channel_flow(s), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
