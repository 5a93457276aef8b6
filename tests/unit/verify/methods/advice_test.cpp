// Advice from a table of measured errors.
#include "verify/methods/advice.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"

using namespace gpf;

namespace {

Scene channel(double nu) {
  Scene s;
  s.width_over_diameter = 31;
  s.particles = 900;
  s.length_over_width = 900 * 3.14159265358979 / (4 * nu * 31 * 31);
  s.normal_restitution = 0.99;
  s.wall_tangential_restitution = {0.9, 0.9};
  s.gravity = 1;
  return s;
}

ChartPoint point(const char* series, const char* scene, double nu, double cost, double bias, double noise) {
  ChartPoint p;
  p.scene = scene, p.series = series, p.parameters = channel(nu), p.cpu_seconds = cost;
  p.run_length = 50, p.start_share = 0.8;  // measured for 10
  p.misfits["mean_velocity"] = {bias, 0.001, noise};
  return p;
}

std::vector<ChartPoint> table() {
  return {
      point("hydrodynamics cells=100", "thin", 0.1, 0.01, 0.02, 0),
      point("hydrodynamics cells=100", "thick", 0.2, 0.01, 0.03, 0),
      point("event_driven length x0.25", "thin", 0.1, 5, 0, 0.04),
      point("event_driven length x0.25", "thick", 0.2, 5, 0, 0.03),
      point("monte_carlo cells=36 length x0.25", "thin", 0.1, 1, 0.005, 0.02),
      point("monte_carlo cells=36 length x0.25", "thick", 0.2, 1, 0.005, 0.02),
      point("event_driven t_c x1000", "thin", 0.1, 0.1, 0, 0),
  };
}

Run run() {
  Run r;
  r.start_up = 40, r.duration = 80, r.sample_interval = 0.1;
  return r;
}

Advice ask(const std::vector<ChartPoint>& points, double nu, double tolerance) {
  return advise(points, channel(nu), run(), observable_named("mean_velocity"), tolerance);
}

const Candidate& of(const Advice& advice, const std::string& method) {
  for (const Candidate& c : advice.candidates)
    if (c.method == method) return c;
  throw std::logic_error(method);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(advice)

BOOST_AUTO_TEST_CASE(the_cheapest_that_is_accurate_enough_comes_first) {
  BOOST_TEST(ask(table(), 0.15, 0.05).best().method == "hydrodynamics cells=100");
  // Its bias may be .03: too much for two per cent. Monte Carlo's is .006, and its noise falls with the run's length.
  const Advice sharper = ask(table(), 0.15, 0.02);
  BOOST_TEST(sharper.best().method == "monte_carlo cells=36");
  BOOST_TEST(sharper.best().error_at_most() <= 0.02 + 1e-12);
  const double room = (0.02 - Misfit{0.005, 0.001, 0}.bias_at_most()) / 2;
  BOOST_TEST(sharper.best().duration == 10 * std::pow(0.02 / room, 2), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(sharper.best().cpu_seconds == (40 + sharper.best().duration) / 50, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(!of(sharper, "hydrodynamics cells=100").usable());
  // Below every bias only the engine is left.
  BOOST_TEST(ask(table(), 0.15, 0.005).best().method == "event_driven");
  // Series in which t_c was varied are no evidence.
  BOOST_TEST(sharper.candidates.size() == 3U);
}

BOOST_AUTO_TEST_CASE(no_advice_beyond_what_was_tried) {
  // Thinner, denser, or of another sort than every scene of the table.
  for (const double nu : {0.06, 0.3, 0.7}) BOOST_TEST(ask(table(), nu, 0.05).best().method == "event_driven");
  Scene other = channel(0.15);
  other.normal_restitution = 0.9;
  BOOST_TEST(!alike(channel(0.15), other));
  other = channel(0.15);
  other.wall_tangential_restitution = {0.9, 0.6};
  BOOST_TEST(!alike(channel(0.15), other));
  other.wall_tangential_restitution = {0.6, 0.6};  // slip 4 against 19
  BOOST_TEST(!alike(channel(0.15), other));
  other.wall_tangential_restitution = {0.75, 0.75};
  BOOST_TEST(alike(channel(0.15), other));
  other.wall_normal_restitution = 0.9;
  BOOST_TEST(!alike(channel(0.15), other));
}

BOOST_AUTO_TEST_CASE(a_method_that_gave_up_on_a_like_scene_is_not_advised) {
  auto points = table();
  points[1].failure = "packed";
  points[1].misfits.clear();
  const Advice advice = ask(points, 0.15, 0.05);
  BOOST_TEST(of(advice, "hydrodynamics cells=100").why_not.find("gave up on thick: packed") != std::string::npos);
  points = table();
  points[0].misfits["mean_velocity"].bias = NAN;
  BOOST_TEST(!of(ask(points, 0.15, 0.05), "hydrodynamics cells=100").usable());
}

BOOST_AUTO_TEST_CASE(a_scene_outside_the_like_ones_in_anything_gets_the_engine) {
  Scene between = channel(0.15), outside = channel(0.15);
  outside.normal_restitution = 0.985;  // alike, but all that was tried is at .99
  BOOST_TEST(alike(channel(0.15), outside));
  const auto best = [](const Scene& scene) {
    return advise(table(), scene, run(), observable_named("mean_velocity"), 0.05).best().method;
  };
  BOOST_TEST(best(between) != "event_driven");
  BOOST_TEST(best(outside) == "event_driven");
  outside = channel(0.15);
  outside.wall_tangential_restitution = {0.8, 0.8};
  BOOST_TEST(best(outside) == "event_driven");
  // Two lengths of one scene are one scene.
  std::vector<ChartPoint> one = table();
  for (ChartPoint& p : one) p.scene = "thin";
  BOOST_TEST(ask(one, 0.15, 0.05).best().method == "event_driven");
}

BOOST_AUTO_TEST_CASE(times_go_with_gravity) {
  Scene slow = channel(0.15);
  slow.gravity = 0.01;
  const auto at = [](const Scene& scene) {
    return of(advise(table(), scene, run(), observable_named("mean_velocity"), 0.02), "event_driven");
  };
  const Candidate fast = at(channel(0.15)), slower = at(slow);
  BOOST_TEST(slower.duration == 10 * fast.duration, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(slower.noise == fast.noise, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_engine_is_never_out_of_the_question) {
  auto points = table();
  for (ChartPoint& p : points) p.failure = "out of memory", p.misfits.clear();
  BOOST_TEST(ask(points, 0.15, 0.05).best().method == "event_driven");
  BOOST_TEST(ask(points, 0.15, 0.05).best().usable());
}

BOOST_AUTO_TEST_CASE(an_engine_without_evidence_has_no_cost) {
  const Advice advice = ask({}, 0.15, 0.05);
  BOOST_TEST(advice.best().method == "event_driven");
  BOOST_TEST(advice.best().duration == 80);
  BOOST_TEST(std::isinf(advice.best().cpu_seconds));
}

BOOST_AUTO_TEST_CASE(questions_that_cannot_be_answered_are_refused) {
  BOOST_CHECK_THROW(ask(table(), 0.15, 0), InputError);
  BOOST_CHECK_THROW(ask(table(), 0.15, 5), InputError);
  BOOST_CHECK_THROW(ask(table(), 0.15, 1e-12), InputError);
  Scene smooth = channel(0.15);
  smooth.wall_tangential_restitution = {0.9, 1};
  BOOST_CHECK_THROW(advise(table(), smooth, run(), observable_named("mean_velocity"), 0.05), InputError);
  Run endless = run();
  endless.duration = 0;
  BOOST_CHECK_THROW(advise(table(), channel(0.15), endless, observable_named("mean_velocity"), 0.05), InputError);
  Scene box = channel(0.15);
  box.geometry = Geometry::periodic;
  BOOST_CHECK_THROW(advise(table(), box, run(), observable_named("mean_velocity"), 0.05), InputError);
  BOOST_CHECK_THROW(observable_named("speed"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
