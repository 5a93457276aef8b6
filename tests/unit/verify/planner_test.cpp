#include "verify/planner.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "gpf/base/error.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/claim_text.hpp"
#include "unit/verify/fake_run.hpp"

using namespace gpf;

namespace {

/// A folder with the scenes "short", "long" (ten times as long) and "twin" (the same as "short"), and an empty store.
struct Fixture {
  test::TemporaryFolder folder;
  Fixture() {
    std::filesystem::create_directory(folder / "scenes");
    std::ofstream(folder / "scenes/short.toml") << test::periodic_scene;
    std::ofstream(folder / "scenes/twin.toml") << "# the same scene\n" + test::periodic_scene;
    std::ofstream(folder / "scenes/long.toml") << test::replaced(test::periodic_scene, "duration = 8", "duration = 80");
  }
  SceneLibrary scenes{folder.path()};
  RecordStore store{folder / "records", Trust::same_sources};

  std::vector<std::string> missing(const Demand& demand, std::uint64_t release = 0) {
    std::vector<std::string> labels;
    for (const RunJob& job : missing_runs(demand, scenes, store, release)) labels.push_back(job.label);
    return labels;
  }
};

}  // namespace

BOOST_FIXTURE_TEST_SUITE(planner, Fixture)

BOOST_AUTO_TEST_CASE(claims_share_runs_and_the_larger_number_counts) {
  const Claim claim = parse_claim(test::claim_text, "eos.example.toml");
  Demand demand;
  add_demand(demand, claim, Tier::quick, 4);
  add_demand(demand, claim, Tier::full, 8);
  add_demand(demand, claim, Tier::quick, 8);
  add_demand(demand, claim, Tier::quick, 4);
  BOOST_TEST((demand == Demand{{"channel", 8}, {"periodic-nu10", 8}, {"periodic-nu30", 8}}));
}

BOOST_AUTO_TEST_CASE(long_runs_come_first) {
  const std::vector<std::string> expected{"long #1", "long #2", "short #1", "short #2"};
  BOOST_TEST(missing({{"short", 2}, {"long", 2}}) == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_the_store_holds_is_not_run_again) {
  for (const int replica : {0, 2}) {
    const SceneFile file = replica_of(scenes.of("short").front().file, replica, 0);
    store.save(file, test::fake_record(file));
  }
  const std::vector<std::string> expected{"short #2", "short #4"};
  BOOST_TEST(missing({{"short", 4}}) == expected, boost::test_tools::per_element());
  BOOST_TEST(missing({{"short", 4}}, 17).size() == 4U);  // another release has its own runs
}

BOOST_AUTO_TEST_CASE(a_checkpoint_whose_record_is_there_is_removed) {
  // A worker may be killed after it has renamed its record into place.
  const SceneFile done = replica_of(scenes.of("short").front().file, 0, 0), open = replica_of(done, 1, 0);
  store.save(done, test::fake_record(done));
  const auto left = [&](const SceneFile& file, const char* end) { return store.path(file).string() + end; };
  for (const SceneFile& file : {done, open})
    for (const char* end : {".checkpoint", ".checkpoint.part"}) std::ofstream(left(file, end)) << "half way";
  BOOST_TEST(is_done(store, done));
  BOOST_TEST(!is_done(store, open));
  for (const char* end : {".checkpoint", ".checkpoint.part"}) {
    BOOST_TEST(!std::filesystem::exists(left(done, end)));
    BOOST_TEST(std::filesystem::exists(left(open, end)));
  }
}

BOOST_AUTO_TEST_CASE(a_damaged_record_is_run_again) {
  const SceneFile file = replica_of(scenes.of("short").front().file, 0, 0);
  store.save(file, test::fake_record(file));
  BOOST_TEST(missing({{"short", 1}}).empty());
  std::filesystem::resize_file(store.path(file), 1000);
  BOOST_TEST(missing({{"short", 1}}).size() == 1U);
}

BOOST_AUTO_TEST_CASE(equal_scenes_under_two_names_are_run_once) {
  BOOST_TEST(missing({{"short", 3}, {"twin", 4}}).size() == 4U);
}

// Twice the time, twice the work; a target of collisions counts by itself: 36 disks, 1000 each, two per collision.
BOOST_AUTO_TEST_CASE(the_expected_work_follows_from_time_or_collisions) {
  const SceneFile& short_run = scenes.of("short").front().file;
  BOOST_TEST(expected_collisions(scenes.of("long").front().file) == 10 * expected_collisions(short_run),
             boost::test_tools::tolerance(1e-12));
  SceneFile counted = short_run;
  counted.run.duration = 0;
  counted.run.collisions_per_particle = 1000;
  BOOST_TEST(expected_collisions(counted) == 18000, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_campaign_stands_for_its_points) {
  std::filesystem::create_directory(folder / "campaigns");
  std::ofstream(folder / "campaigns/map.toml")
      << "title = \"A map\"\nreplicas = 4\n[axes]\nlength_over_width = [1, 2]\n[scene]\ngeometry = \"channel\"\n"
         "area_fraction = 0.2\nwidth_over_diameter = 12\nnormal_restitution = 0.9\nwall_tangential_restitution = 0.5\n"
         "[run]\nstart_up = 0\nduration = 8\ndensity_modes = 2\n";
  const std::vector<std::string> expected{"map: length_over_width = 2 #1", "map: length_over_width = 2 #2",
                                          "map: length_over_width = 1 #1", "map: length_over_width = 1 #2"};
  BOOST_TEST(missing({{"map", 2}}) == expected, boost::test_tools::per_element());
  const SceneFile of_campaign = replica_of(scenes.of("map")[1].file, 0, 0);  // what gpf campaign makes
  store.save(of_campaign, test::fake_record(of_campaign));
  BOOST_TEST(missing({{"map", 1}}, 17).size() == 1U);  // serves every release
  BOOST_TEST(scenes.of("map")[1].file.scene.length_over_width == 2, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(a_scene_that_does_not_exist_is_an_error) { BOOST_CHECK_THROW(scenes.of("none"), StorageError); }

BOOST_AUTO_TEST_SUITE_END()
