// What the tests of the all-pairs oracle share: a small scene, and comparisons with numbers worked out by hand.
#pragma once

#include <algorithm>
#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <exception>
#include <initializer_list>
#include <string>

#include "gpf/scene/scene.hpp"

namespace gpf::test {

using Reals = boost::mpl::list<double, long double>;

// A handful of roundings of numbers of order one, each 1.1e-16; contact times divide by relative speeds near 1.
inline constexpr double close = 4e-15;

inline Scene scene(Geometry geometry, std::int32_t particles) {
  Scene s;
  s.geometry = geometry;
  s.particles = particles;
  s.width_over_diameter = 7.4;
  s.length_over_width = 2.1;
  return s;
}

inline void check_vector(Vec2 found, Vec2 expected, double tolerance = close) {
  BOOST_TEST(std::abs(found.x - expected.x) <= tolerance, "x is " << found.x << ", expected " << expected.x);
  BOOST_TEST(std::abs(found.y - expected.y) <= tolerance, "y is " << found.y << ", expected " << expected.y);
}

inline void check_near(double found, double expected, double tolerance = close) {
  BOOST_TEST(std::abs(found - expected) <= tolerance, found << " differs from " << expected);
}

inline bool mentions(const std::exception& error, std::initializer_list<const char*> words) {
  const std::string text = error.what();
  return std::all_of(words.begin(), words.end(), [&](auto* word) { return text.find(word) != std::string::npos; });
}

}  // namespace gpf::test
