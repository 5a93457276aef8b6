// Pictures of states: one dot a disk at its place, and the spectrum's peak where it belongs.
#include "gpf/io/snapshot.hpp"

#include <boost/test/unit_test.hpp>

#include "gpf/base/vec2.hpp"

using namespace gpf;

BOOST_AUTO_TEST_CASE(a_snapshot_shows_every_disk_and_the_peak) {
  Scene scene;
  scene.geometry = Geometry::channel;
  scene.width_over_diameter = 20;
  scene.length_over_width = 2;
  State state;
  for (int i = 0; i < 40; ++i)  // a slug: the left half
    for (int j = 0; j < 10; ++j) state.position.push_back({(i + 0.5) / 40, (j + 0.5) / 10});
  state.velocity.assign(state.position.size(), {});
  scene.particles = static_cast<std::int32_t>(state.position.size());
  const std::string svg = snapshot_svg(scene, state, "a <b> & c ]]>\n\xef\xbf\xbe\xff");
  std::size_t disks = 0;
  for (std::size_t at = 0; (at = svg.find("h0", at)) != std::string::npos; ++at) ++disks;
  BOOST_TEST(disks == 400U);
  BOOST_TEST(svg.find("stroke-width=\"20.00\"") != std::string::npos);  // d of W/20, 400 pixels to W
  BOOST_TEST(svg.find("M13,408h0") != std::string::npos);               // (1/80, 1/20)
  BOOST_TEST(svg.find("a &lt;b&gt; &amp; c ]]&gt; \xef\xbf\xbd\xef\xbf\xbd<") != std::string::npos);
  // Half of the length: 2 (nu 2/pi)^2 against 2 nu^2/N, N 4/pi^2 = 162 of the noise; black is beyond 10^4.
  BOOST_TEST(svg.find("<title>(1, 0): 162 of the noise") != std::string::npos);
  BOOST_TEST(svg.find("<title>(0, 0)") == std::string::npos);
}
