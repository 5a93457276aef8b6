// The guess at a contact to come against the rules for elastic disks.
#include "gpf/event/after_contact.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/random.hpp"
#include "gpf/event/rules.hpp"

using namespace gpf;

namespace {

constexpr double time_of_contact = 1.5;

/// A disk that is at `r` with velocity `v` at that time, and has flown for `flight_time`.
Flight flight_to(Vec2 r, Vec2 v, double flight_time) {
  return {r.x - v.x * flight_time, r.y - v.y * flight_time, v.x, v.y, time_of_contact - flight_time};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(after_a_contact)

BOOST_AUTO_TEST_CASE(velocities_are_those_of_elastic_disks) {
  Scene scene;
  scene.width_over_diameter = 7.4;
  scene.normal_restitution = 1;
  const SmoothDisks elastic(scene);
  for (std::uint64_t k = 0; k < 200; ++k) {
    const Vec2 direction = gaussian_pair(3, k), r = gaussian_pair(6, k), v = gaussian_pair(4, k),
               w = gaussian_pair(5, k);
    const Vec2 r_12 = (scene.diameter() / std::sqrt(dot(direction, direction))) * direction;
    const auto [a, b] =
        after_contact(flight_to(r, v, 0.7), flight_to(r + r_12, w, 0.2), time_of_contact, scene.diameter());
    const Vec2 impulse = elastic(r_12, v - w, never).impulse;
    // Positions of order 1 lose some epsilon, of which the direction, 1/d = 7.4 times as many, is made: below 1e-13.
    const std::array errors{a.x - r.x,
                            a.y - r.y,
                            b.x - (r + r_12).x,
                            b.y - (r + r_12).y,
                            a.vx - (v - impulse).x,
                            a.vy - (v - impulse).y,
                            b.vx - (w + impulse).x,
                            b.vy - (w + impulse).y};
    for (const double error : errors) BOOST_TEST(std::abs(error) < 1e-13);
    BOOST_TEST(a.time == time_of_contact);
    BOOST_TEST(b.time == time_of_contact);
  }
}

BOOST_AUTO_TEST_CASE(of_one_disk_twice_it_flies_on) {
  const Flight f = flight_to({0.3, 0.5}, {0.25, -2}, 0.5);
  for (const Flight& then : after_contact(f, f, time_of_contact, 0.1)) {
    BOOST_TEST(then.x == 0.3);
    BOOST_TEST(then.y == 0.5);
    BOOST_TEST(then.vx == 0.25);
    BOOST_TEST(then.vy == -2);
  }
}

BOOST_AUTO_TEST_SUITE_END()
