// What is said before a method is trusted beyond where it was found to hold.
#include "gpf/flow/range.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace gpf;

namespace {

/// A scene that is within the range of every method.
Scene channel() {
  Scene s;
  s.width_over_diameter = 60;
  s.particles = 900;
  s.length_over_width = 900 * 3.14159265358979 / (4 * 0.15 * 60 * 60);
  s.normal_restitution = 0.99;
  s.wall_tangential_restitution = {0.9, 0.9};
  s.gravity = 1;
  return s;
}

/// Whether exactly one warning names the claim.
bool warns(const Scene& scene, const char* method, const std::string& claim) {
  const auto warnings = range_warnings(scene, parse_method(method));
  return warnings.size() == 1 && warnings.front().find("(" + claim + ")") != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(range)

BOOST_AUTO_TEST_CASE(nothing_is_said_within) {
  for (const char* method : {"event_driven", "all_pairs", "soft_disks", "monte_carlo cells=60", "hydrodynamics"})
    BOOST_TEST(range_warnings(channel(), parse_method(method)).empty(), method);
}

BOOST_AUTO_TEST_CASE(each_limit_is_named_with_its_claim) {
  Scene thin = channel();
  thin.length_over_width *= 10;
  BOOST_TEST(warns(thin, "hydrodynamics", "limits.hydrodynamics.knudsen"));
  BOOST_TEST(range_warnings(thin, parse_method("monte_carlo")).empty());
  Scene dense = channel();
  dense.length_over_width /= 3;
  BOOST_TEST(warns(dense, "hydrodynamics", "limits.hydrodynamics.density"));
  BOOST_TEST(warns(dense, "monte_carlo cells=60", "limits.monte-carlo"));  // cells too high
  BOOST_TEST(range_warnings(dense, parse_method("monte_carlo cells=600")).empty());
  Scene plug = dense;
  plug.normal_restitution = 0.95;
  BOOST_TEST(warns(plug, "monte_carlo cells=600", "limits.monte-carlo.density"));
  Scene packed = dense;
  packed.length_over_width *= 0.8;
  BOOST_TEST(warns(packed, "monte_carlo cells=600", "limits.monte-carlo.density"));
  Scene lossy = channel();
  lossy.normal_restitution = 0.8;
  BOOST_TEST(warns(lossy, "hydrodynamics closure=garzo_dufty", "limits.hydrodynamics.restitution"));
  BOOST_TEST(warns(lossy, "monte_carlo cells=60", "limits.monte-carlo"));
  BOOST_TEST(warns(channel(), "soft_disks contact=0.2", "limits.soft-disks.stiffness"));
  BOOST_TEST(warns(channel(), "soft_disks steps=4", "limits.soft-disks.step"));
  BOOST_TEST(warns(lossy, "event_driven", "limits.collapse"));  // tc_time is 0
  lossy.tc_time = 1e-4 / lossy.reference_collision_rate();
  BOOST_TEST(range_warnings(lossy, {}).empty());
  Scene lossiest = lossy;
  lossiest.normal_restitution = 0.3;
  BOOST_TEST(warns(lossiest, "event_driven", "limits.tc"));
  lossy.tc_time *= 1000;
  BOOST_TEST(warns(lossy, "event_driven", "limits.tc"));
}

BOOST_AUTO_TEST_SUITE_END()
