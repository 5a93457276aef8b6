#include "verify/estimators/departure.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/scene/start.hpp"
#include "verify/estimators/limit_scenes.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(departure_of_trajectories)

BOOST_AUTO_TEST_CASE(distances_are_those_of_nearest_images_in_diameters) {
  Scene scene = limit_gas(2, 0.1, 1);
  const double d = scene.diameter();
  const State a{{{0.99, 0.5}, {0.3, 0.01}}, {{}, {}}}, b{{{0.01, 0.5}, {0.3, 0.97}}, {{}, {}}};
  BOOST_TEST(distance_between(scene, a, a) == 0);
  BOOST_TEST(distance_between(scene, a, b) == std::sqrt((0.02 * 0.02 + 0.04 * 0.04) / 2) / d,
             boost::test_tools::tolerance(1e-12));
  scene.geometry = Geometry::channel;  // no period across
  BOOST_TEST(distance_between(scene, a, b) > 0.6 / d);
}

BOOST_AUTO_TEST_CASE(rounding_leaves_numbers_of_single_precision) {
  const State state = rounded_to_float({{{0.1, 0.25}}, {{1.0 / 3, -2}}});
  BOOST_TEST(state.position[0].x == static_cast<double>(0.1f));
  BOOST_TEST(state.position[0].y == 0.25);
  BOOST_TEST(state.velocity[0].x == static_cast<double>(1.0f / 3));
}

BOOST_AUTO_TEST_CASE(a_rate_and_a_delay_are_read_off_exponentials) {
  Departure d;
  for (int k = 0; k <= 60; ++k) {
    d.contacts.push_back(0.5 * k);
    d.single.push_back(1e-7 * std::exp(0.8 * d.contacts.back()));
    d.twofold.push_back(1e-16 * std::exp(1.2 * d.contacts.back()));
  }
  BOOST_TEST(d.rate(d.single, d.single, 1e-6, 1e-2) == 0.8, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(d.rate(d.twofold, d.single, 1e-6, 1e-2) == 1.2, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(d.contacts_to(0.1, d.single) == std::log(1e6) / 0.8, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::isnan(d.contacts_to(1e9, d.single)));
  BOOST_TEST(std::isnan(d.rate(d.single, d.single, 1e-6, 1.01e-6)));
}

BOOST_AUTO_TEST_CASE(double_departs_later_than_float) {
  const Scene scene = limit_gas(16, 0.3, 1);
  const Departure d = departure_from(scene, rounded_to_float(start_state(scene)), 0.1, 100);
  const double single = d.contacts_to(0.1, d.single), twofold = d.contacts_to(0.1, d.twofold);
  BOOST_TEST(single > 3);
  BOOST_TEST(twofold > 1.5 * single);
  BOOST_TEST(d.single.front() < 1e-3);
  BOOST_TEST(d.engine.front() < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
