#include "gpf/scene/canonical_text.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "gpf/base/hash.hpp"
#include "scene_text.hpp"

using namespace gpf;
using namespace gpf::test;

BOOST_AUTO_TEST_SUITE(canonical_text_test)

BOOST_AUTO_TEST_CASE(the_text_is_known) {
  Scene scene;
  scene.particles = 900;
  scene.width_over_diameter = 31;
  scene.length_over_width = 0.1 + 0.2;  // seventeen digits are needed to read this back
  scene.normal_restitution = 0.99;
  scene.wall_tangential_restitution = {0.5, -1};
  scene.tc_time = 1e-7;
  scene.gravity = 1;
  scene.seed = 42;
  BOOST_TEST(canonical_text(scene) == R"([scene]
geometry = "channel"
particles = 900
width_over_diameter = 31
length_over_width = 0.30000000000000004
normal_restitution = 0.99
wall_normal_restitution = 1
wall_tangential_restitution = [0.5, -1]
tc_time = 1e-07
gravity = 1
lattice = "auto"
seed = 42
)");
  // Records are named after this: it may only change together with the format of the records.
  BOOST_TEST(hexadecimal(scene_hash(scene)) == "acf9aca392360fb1");
}

BOOST_AUTO_TEST_CASE(the_text_reads_back_to_the_same_scene) {
  for (const std::string& text :
       {channel_text, periodic_text, with(channel_text, "0.3", "0.31459"), with(channel_text, "= 0.5", "= [0.1, 0.7]"),
        with(channel_text, "[run]", "lattice = \"square\"\ntc_time = 0\ngravity = 0.3\nseed = 0\n[run]")}) {
    const std::string canonical = canonical_text(parse_scene(text, "t").scene);
    BOOST_TEST(canonical_text(parse_scene(canonical + "[run]\nduration = 1\n", "t").scene) == canonical);
  }
}

BOOST_AUTO_TEST_CASE(the_hash_depends_on_every_value_but_the_seed) {
  const Scene scene = parse_scene(channel_text, "t").scene;
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene&) {},
      [](Scene& s) { s.geometry = Geometry::periodic; },
      [](Scene& s) { ++s.particles; },
      [](Scene& s) { s.width_over_diameter = std::nextafter(s.width_over_diameter, 100); },
      [](Scene& s) { s.length_over_width = std::nextafter(s.length_over_width, 100); },
      [](Scene& s) { s.normal_restitution = std::nextafter(s.normal_restitution, 1); },
      [](Scene& s) { s.wall_normal_restitution = 0.5; },
      [](Scene& s) { s.wall_tangential_restitution[0] = 0.25; },
      [](Scene& s) { s.wall_tangential_restitution[1] = 0.25; },
      [](Scene& s) { s.tc_time = 0; },
      [](Scene& s) { s.gravity = 0; },
      [](Scene& s) { s.lattice = Lattice::square; }};
  std::set<std::uint64_t> hashes;
  for (const auto& change : changes) {
    Scene changed = scene;
    change(changed);
    hashes.insert(scene_hash(changed));
    changed.seed += 7;
    hashes.insert(scene_hash(changed));  // the seed must add none
  }
  BOOST_TEST(hashes.size() == changes.size());
}

BOOST_AUTO_TEST_SUITE_END()
