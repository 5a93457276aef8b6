#include "gpf/scene/scene_file.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>

#include "scene_text.hpp"

using namespace gpf;
using namespace gpf::test;

namespace {

SceneFile parsed(const std::string& text) { return parse_scene(text, "test.toml"); }

}  // namespace

BOOST_AUTO_TEST_SUITE(scene_file_test)

BOOST_AUTO_TEST_CASE(every_key_arrives) {
  const std::string text = R"([scene]
geometry = "channel"
particles = 400
width_over_diameter = 20.5
length_over_width = 1.5
normal_restitution = 0.85
wall_normal_restitution = 0.95
wall_tangential_restitution = [0.9, -0.25]
tc_time = 1e-6
gravity = 2.5
lattice = "triangular"
seed = 9223372036854775807
[run]
start_up = 0
duration = 7.5
collisions_per_particle = 250
sample_interval = 0.125
bins = 12
density_modes = 4
snapshots = [1, 7.5]
)";
  const SceneFile file = parsed(text);
  const Scene& s = file.scene;
  BOOST_TEST((s.geometry == Geometry::channel));
  BOOST_TEST(s.particles == 400);
  BOOST_TEST(s.width_over_diameter == 20.5);
  BOOST_TEST(s.length_over_width == 1.5);
  BOOST_TEST(s.normal_restitution == 0.85);
  BOOST_TEST(s.wall_normal_restitution == 0.95);
  BOOST_TEST(s.wall_tangential_restitution[Wall::lower] == 0.9);
  BOOST_TEST(s.wall_tangential_restitution[Wall::upper] == -0.25);
  BOOST_TEST(s.tc_time == 1e-6);
  BOOST_TEST(s.gravity == 2.5);
  BOOST_TEST((s.lattice == Lattice::triangular));
  BOOST_TEST(s.seed == 9223372036854775807u);
  BOOST_TEST(file.run.start_up == 0);
  BOOST_TEST(file.run.duration == 7.5);
  BOOST_TEST(file.run.collisions_per_particle == 250);
  BOOST_TEST(file.run.sample_interval == 0.125);
  BOOST_TEST(file.run.bins == 12);
  BOOST_TEST(file.run.density_modes == 4);
  BOOST_TEST(file.run.snapshots == (std::vector<double>{1, 7.5}), boost::test_tools::per_element());
  BOOST_TEST(file.text == text);
  BOOST_TEST(file.name == "test.toml");
}

BOOST_AUTO_TEST_CASE(defaults_of_a_channel) {
  const SceneFile file = parsed(channel_text);
  BOOST_TEST(file.scene.wall_normal_restitution == 1);
  BOOST_TEST(file.scene.wall_tangential_restitution[Wall::lower] == 0.5);  // one number is meant for both
  BOOST_TEST(file.scene.wall_tangential_restitution[Wall::upper] == 0.5);
  BOOST_TEST(file.scene.gravity == 1);
  BOOST_TEST((file.scene.lattice == Lattice::automatic));
  BOOST_TEST(file.scene.seed == 1u);
  BOOST_TEST(file.scene.tc_time == 1e-4 * (1 / file.scene.reference_collision_rate()));
  BOOST_TEST(file.run.start_up == 50);
  BOOST_TEST(file.run.duration == 10);
  BOOST_TEST(file.run.collisions_per_particle == 0);
  BOOST_TEST(file.run.bins == 18);
  BOOST_TEST(parsed(with(channel_text, "duration", "start_up = 3\nduration")).run.start_up == 3);
}

BOOST_AUTO_TEST_CASE(defaults_of_a_periodic_scene) {
  const SceneFile file = parsed(periodic_text);
  const double mean_free_time = 1 / file.scene.reference_collision_rate();
  BOOST_TEST((file.scene.geometry == Geometry::periodic));
  BOOST_TEST(file.scene.gravity == 0);
  BOOST_TEST(file.run.start_up == 50 * mean_free_time);
  BOOST_TEST(file.run.duration == 0);
  BOOST_TEST(file.run.collisions_per_particle == 100);
  // Without gravity a channel's start-up is in mean free times too.
  const SceneFile still = parsed(with(channel_text, "[run]", "gravity = 0\n[run]"));
  BOOST_TEST(still.run.start_up == 50 / still.scene.reference_collision_rate(), boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(times_scale_with_gravity) {
  const SceneFile one = parsed(channel_text), four = parsed(with(channel_text, "[run]", "gravity = 4\n[run]"));
  BOOST_TEST(four.run.start_up == one.run.start_up / 2);
  BOOST_TEST(four.run.sample_interval == one.run.sample_interval / 2);
  BOOST_TEST(four.scene.tc_time == one.scene.tc_time / 2);
}

BOOST_AUTO_TEST_CASE(the_sample_interval_is_the_largest_power_of_two_allowed) {
  for (const std::string nu : {"0.003", "0.01", "0.1", "0.3", "0.7"})
    for (const std::string g : {"0", "0.3", "1", "7"}) {
      const SceneFile file = parsed(with(with(channel_text, "0.3", nu), "[run]", "gravity = " + g + "\n[run]"));
      const double most = std::min(4 / file.scene.reference_collision_rate(), 0.25 / file.scene.velocity_scale());
      int exponent = 0;
      BOOST_TEST(std::frexp(file.run.sample_interval, &exponent) == 0.5);  // a power of two
      BOOST_TEST(file.run.sample_interval <= most);
      BOOST_TEST(2 * file.run.sample_interval > most);
    }
  BOOST_TEST(parsed(with(channel_text, "duration = 10", "duration = 0.001")).run.sample_interval == 0x1p-10);
}

BOOST_AUTO_TEST_CASE(bins_grow_with_the_width) {
  const auto bins = [](const std::string& wd) { return parsed(with(channel_text, "= 31", "= " + wd)).run.bins; };
  BOOST_TEST(bins("31") == 18);
  BOOST_TEST(bins("62") == 36);
  BOOST_TEST(bins("30") == 17);                                                             // 17.4
  BOOST_TEST(parsed(with(with(channel_text, "= 31", "= 1.5"), "900", "3")).run.bins == 1);  // 0.87
  BOOST_TEST(parsed(with(with(channel_text, "= 31", "= 5000"), "900", "1000000")).run.bins == 1000);
}

BOOST_AUTO_TEST_CASE(integers_are_numbers_too) {
  const SceneFile file = parsed(with(channel_text, "= 0.9", "= 1"));
  BOOST_TEST(file.scene.normal_restitution == 1);
  BOOST_TEST(parsed(with(channel_text, "= 0.5", "= [1, -1]")).scene.wall_tangential_restitution[1] == -1);
}

BOOST_AUTO_TEST_CASE(tables_and_keys_may_come_in_any_order_and_style) {
  const Scene scene = parsed(channel_text).scene;
  const std::string shuffled = R"(run = { duration = 10 } # inline
scene.geometry = 'channel'
scene.wall_tangential_restitution = 5e-1
scene."area_fraction" = 0.3
scene.width_over_diameter = 3_1
scene.normal_restitution = +0.9
scene.particles = 0x384
)";
  BOOST_TEST(canonical_text(parsed(shuffled).scene) == canonical_text(scene));
}

BOOST_AUTO_TEST_CASE(unknown_tables_and_misplaced_keys_are_refused) {
  check_refused(channel_text + "[runs]\n", "10:2", {"unknown table or key 'runs'", "did you mean [run]?"});
  check_refused("particles = 3\n" + channel_text, "1:1", {"unknown table or key 'particles'", "move it below [scene]"});
  check_refused(channel_text + "particles = 3\n", "10:1",
                {"unknown key 'particles' in [run]", "move it below [scene]"});
  check_refused(with(channel_text, "[run]", "bins = 3\n[run]"), "8:1",
                {"unknown key 'bins' in [scene]", "move it below [run]"});
  check_refused(with(channel_text, "particles", "partciles"), "3:1",
                {"unknown key 'partciles'", "did you mean 'particles'?"});
  check_refused(with(channel_text, "particles", R"("a\nb")"), "3:1", {"unknown key 'a?b'"});
  check_refused(with(channel_text, "particles", "particles.x"), "3:1", {"particles is a table"});
}

BOOST_AUTO_TEST_CASE(all_mistakes_in_keys_are_named_a_line_each) {
  const std::string text =
      "[scene]\ngeometry = \"chanel\"\nparticles = -5\npartciles = 5\n[runs]\n[run]\nduration = \"1\"\n";
  try {
    static_cast<void>(parse_scene(text, "two.toml"));
    BOOST_ERROR("accepted");
  } catch (const InputError& error) {
    std::istringstream lines(error.what());
    std::string line;
    for (const std::string_view wanted :
         {"two.toml:2:12: geometry = 'chanel' is unknown", "two.toml:3:13: particles = -5 is out of range",
          "two.toml:4:1: unknown key 'partciles'", "two.toml:5:2: unknown table or key 'runs'",
          "two.toml:7:12: duration is a string"}) {
      BOOST_REQUIRE(std::getline(lines, line));
      BOOST_TEST(line.starts_with(wanted), line);
      BOOST_TEST(line.find("): ") != std::string::npos, line);
    }
    BOOST_TEST(!std::getline(lines, line));
  }
}

BOOST_AUTO_TEST_CASE(missing_tables_are_refused) {
  check_refused("", "1:1", {"the table [scene] is missing", "add [scene]"});
  check_refused(with(channel_text, "[run]\nduration = 10\n", ""), "1:1",
                {"the table [run] is missing", "how long", "collisions_per_particle = 1000"});
  check_refused("[run]\nduration = 1\n", "1:1", {"the table [scene] is missing"});
  check_refused("scene = 3\n", "1:1", {"'scene' is an integer", "write [scene]"});
  check_refused("[[scene]]\n", "1:3", {"'scene' is an array", "write [scene]"});
}

BOOST_AUTO_TEST_CASE(missing_keys_without_default_are_refused) {
  check_refused(with(channel_text, "geometry = \"channel\"\n", ""), "1:2",
                {"geometry is missing in [scene]", "add geometry = "});
  check_refused(with(channel_text, "normal_restitution = 0.9\n", ""), "1:2",
                {"normal_restitution is missing in [scene]", "add normal_restitution = "});
  check_refused(with(channel_text, "wall_tangential_restitution = 0.5\n", ""), "1:2",
                {"wall_tangential_restitution is missing in [scene]", "add wall_tangential_restitution = "});
  check_refused(with(channel_text, "duration = 10\n", ""), "8:2",
                {"[run] has no target", "neither duration nor collisions_per_particle", "add collisions_per_particle"});
}

BOOST_AUTO_TEST_CASE(so_many_collisions_of_a_gas_that_cools_are_refused) {
  const auto gas = [](double restitution, double collisions) {
    return fmt::format(
        "[scene]\ngeometry = \"periodic\"\nparticles = 64\narea_fraction = 0.2\nlength_over_width = 1\n"
        "normal_restitution = {}\n[run]\ncollisions_per_particle = {}\n",
        restitution, collisions);
  };
  check_refused(gas(0.8, 3000), "8:1", {"in a gas that cools", "give a duration"});
  BOOST_TEST(parsed(gas(0.8, 200)).run.collisions_per_particle == 200);
  BOOST_TEST(parsed(gas(1, 1e6)).run.collisions_per_particle == 1e6);
}

BOOST_AUTO_TEST_CASE(unknown_words_are_told_the_nearest) {
  check_refused(with(channel_text, R"("channel")", R"("chanel")"), "2:12",
                {"geometry = 'chanel' is unknown", R"("channel" | "periodic")", "did you mean \"channel\"?"});
  check_refused(with(channel_text, "[run]", "lattice = \"hexagonal\"\n[run]"), "8:11",
                {"lattice = 'hexagonal' is unknown", R"("auto" | "square" | "triangular")"});
}

BOOST_AUTO_TEST_CASE(walls_come_in_pairs) {
  check_refused(with(channel_text, "= 0.5", "= [0.5]"), "7:31", {"has 1 values", "two walls", "[lower, upper]"});
  check_refused(with(channel_text, "= 0.5", "= [0.5, 0.5, 0.5]"), "7:31", {"has 3 values"});
  check_refused(with(channel_text, "= 0.5", "= [0.5, 1.5]"), "7:37",
                {"wall_tangential_restitution = 1.5 is out of range", "[-1, 1]"});
  check_refused(with(channel_text, "= 0.5", "= [\"a\", 0]"), "7:32", {"wall_tangential_restitution is a string"});
  check_refused(with(channel_text, "= 0.5", "= [nan, 0]"), "7:32", {"not a finite number"});
}

BOOST_AUTO_TEST_CASE(snapshots_are_taken_in_order_and_within_the_run) {
  const auto run = [](const std::string& snapshots) {
    return with(channel_text, "duration = 10", "start_up = 5\nduration = 10\nsnapshots = " + snapshots);
  };
  BOOST_TEST(parsed(run("[]")).run.snapshots.empty());
  BOOST_TEST(parsed(run("[2, 15]")).run.snapshots.back() == 15);
  BOOST_TEST(parsed(run("4")).run.snapshots == std::vector<double>{4}, boost::test_tools::per_element());
  check_refused(run("[4, 2]"), "11:17", {"snapshots has 2 after 4", "put them in order"});
  check_refused(run("[4, 4]"), "11:17", {"snapshots has 4 after 4"});
  check_refused(run("[0]"), "11:14", {"snapshots = 0 is out of range"});
  check_refused(run("[\"a\"]"), "11:14", {"snapshots is a string"});
  check_refused(run("[2, 2.001]"), "11:1", {"snapshots has 2 and 2.001", "apart", "leave one out"});
  std::string many = "[1";
  for (int k = 1; k <= 100; ++k) many += fmt::format(", {}", 1 + 0.1 * k);
  check_refused(run(many + "]"), "11:1", {"snapshots has 101 times", "at most 100"});
  check_refused(run("[2, 15.5]"), "11:1", {"snapshots has 15.5, beyond start_up + duration = 15", "lengthen duration"});
}

BOOST_AUTO_TEST_CASE(a_periodic_scene_has_neither_walls_nor_gravity) {
  check_refused(with(periodic_text, "[run]", "wall_normal_restitution = 1\n[run]"), "7:1",
                {"wall_normal_restitution is given in a periodic scene", "no walls", "remove the key"});
  check_refused(with(periodic_text, "[run]", "wall_tangential_restitution = 1\n[run]"), "7:1",
                {"wall_tangential_restitution is given in a periodic scene"});
  check_refused(with(periodic_text, "[run]", "gravity = 1\n[run]"), "7:1",
                {"gravity = 1 in a periodic scene", "accelerate for ever", "remove gravity"});
  check_refused(with(periodic_text, "[run]", "[run]\ndensity_modes = 2"), "8:1",
                {"density_modes = 2 in a periodic scene", "across a channel", "remove density_modes"});
  BOOST_TEST(parsed(with(periodic_text, "[run]", "gravity = 0\n[run]")).scene.gravity == 0);
}

BOOST_AUTO_TEST_CASE(a_contact_time_beyond_the_mean_free_time_is_refused) {
  check_refused(with(channel_text, "[run]", "tc_time = 1\n[run]"), "8:1",
                {"tc_time = 1 exceeds the mean free time", "elastic", "choose"});
  BOOST_TEST(parsed(with(channel_text, "[run]", "tc_time = 0\n[run]")).scene.tc_time == 0);
}

BOOST_AUTO_TEST_CASE(an_area_fraction_beyond_the_lattice_is_refused_with_the_most_that_fits) {
  check_refused(with(channel_text, "= 0.3", "= 0.89"), "4:1",
                {"no lattice holds 900 disks at area fraction 0.89", "W/d = 31", "the most that fits is 0.8853",
                 "lower area_fraction"});
  const std::string square = with(channel_text, "[run]", "lattice = \"square\"\n[run]");
  // 30 rows of 30 in W = 31 d: pi 900/(4 31 30) = 0.7601, less the gaps.
  check_refused(with(square, "= 0.3", "= 0.77"), "4:1",
                {"no square lattice holds 900 disks", "the most that fits is 0.7600", "set lattice = \"auto\""});
  check_refused(with(square, "= 0.3", "= 0.89"), "4:1", {"no square lattice", "lower area_fraction"});
}

BOOST_AUTO_TEST_CASE(samples_must_fit_into_the_duration) {
  check_refused(channel_text + "sample_interval = 11\n", "10:1",
                {"sample_interval = 11 exceeds duration = 10", "no sample", "lower sample_interval"});
}

BOOST_AUTO_TEST_CASE(minus_zero_is_zero) {
  const Scene scene = parsed(with(channel_text, "= 0.5", "= -0.0")).scene;
  BOOST_TEST(!std::signbit(scene.wall_tangential_restitution[Wall::lower]));
}

BOOST_AUTO_TEST_CASE(files_are_read_and_unreadable_ones_are_storage_errors) {
  const auto folder = std::filesystem::temp_directory_path() / "gpf_scene_file_test";
  std::filesystem::create_directories(folder);
  const auto path = folder / "scene.toml";
  std::ofstream(path) << channel_text;
  const SceneFile file = load_scene(path);
  BOOST_TEST(file.name == path.string());
  BOOST_TEST(file.text == channel_text);
  BOOST_TEST(file.scene.particles == 900);
  std::ofstream(path) << "[scene]\nx = 1\n";
  BOOST_CHECK_EXCEPTION(static_cast<void>(load_scene(path)), InputError,
                        [&](const InputError& error) { return error.problem().find(path.string() + ":2:1: ") == 0; });
  std::filesystem::remove(path);
  BOOST_CHECK_EXCEPTION(static_cast<void>(load_scene(path)), StorageError, [&](const StorageError& error) {
    return error.problem().find(path.string()) != std::string::npos && !error.why().empty() && !error.remedy().empty();
  });
  BOOST_CHECK_THROW(static_cast<void>(load_scene(folder)), StorageError);
  std::filesystem::remove(folder);
}

BOOST_AUTO_TEST_SUITE_END()
