#include "verify/main_fields.hpp"

#include <boost/test/unit_test.hpp>

#include "unit/verify/fake_run.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(main_fields_of_a_run)

BOOST_AUTO_TEST_CASE(a_scene_is_steady_when_what_drives_it_is_taken_up) {
  Scene channel = parse_scene(test::channel_scene, "channel.toml").scene;
  BOOST_TEST(has_steady_state(channel));
  channel.wall_tangential_restitution = {1, -1};  // gravity without friction
  BOOST_TEST(!has_steady_state(channel));
  channel.wall_tangential_restitution = {1, 0.9};  // one rough wall is enough
  BOOST_TEST(has_steady_state(channel));
  channel.gravity = 0;  // rough walls without gravity: the flow dies
  BOOST_TEST(!has_steady_state(channel));
  channel.wall_tangential_restitution = {1, -1};
  BOOST_TEST(!has_steady_state(channel));  // e_n 0.9: it cools
  channel.normal_restitution = 1;
  BOOST_TEST(has_steady_state(channel));
  channel.wall_normal_restitution = 0.9;
  BOOST_TEST(!has_steady_state(channel));

  Scene periodic = parse_scene(test::periodic_scene, "periodic.toml").scene;
  BOOST_TEST(has_steady_state(periodic));
  periodic.normal_restitution = 0.99;  // a cooling gas
  BOOST_TEST(!has_steady_state(periodic));
}

BOOST_AUTO_TEST_CASE(a_channel_shows_flow_energy_and_temperature_per_disk) {
  // Every field 10 in every bin, 18 disks in each of two bins (fake_run.hpp).
  const auto constant = [](std::size_t, std::size_t, double) { return 10.0; };
  const auto fields = main_fields(test::fake_record(parse_scene(test::channel_scene, "channel.toml"), 40, constant));
  BOOST_REQUIRE(fields.size() == 3U);
  BOOST_TEST(fields[0].name == "mean flow");
  BOOST_TEST(fields[1].name == "kinetic energy");
  BOOST_TEST(fields[2].name == "granular temperature");
  for (const BlockedField& field : fields) BOOST_TEST(field.blocks.size() == 40U);
  BOOST_TEST(fields[0].blocks[7] == 10.0 / 36);
  BOOST_TEST(fields[1].blocks[7] == 10.0 / 36);
  BOOST_TEST(fields[2].blocks[7] == 0.5 * (20.0 / 36 + 20.0 / 36));
}

BOOST_AUTO_TEST_CASE(an_elastic_gas_shows_virial_and_collision_rate) {
  const SceneFile file = parse_scene(test::periodic_scene, "periodic.toml");
  const auto index = [](std::size_t block, std::size_t, double) { return static_cast<double>(block); };
  const auto fields = main_fields(test::fake_record(file, 40, index));
  BOOST_REQUIRE(fields.size() == 2U);
  BOOST_TEST(fields[0].name == "virial");
  BOOST_TEST(fields[1].name == "collision rate");
  BOOST_TEST(fields[1].blocks[7] == 7.0);
  SceneFile cooling = file;
  cooling.scene.normal_restitution = 0.5;
  BOOST_TEST(main_fields(test::fake_record(cooling)).empty());
}

BOOST_AUTO_TEST_SUITE_END()
