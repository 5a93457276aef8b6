#include "verify/store.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <set>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/fake_run.hpp"

using namespace gpf;

namespace {

SceneFile scene() { return parse_scene(test::periodic_scene, "periodic.toml"); }

/// A store in a folder of its own that keeps what it reports.
struct Fixture {
  test::TemporaryFolder folder;
  std::vector<std::string> reports;
  RecordStore store{folder / "records", Trust::same_sources,
                    [this](const std::string& line) { reports.push_back(line); }};
  SceneFile replica = replica_of(scene(), 0, 0);
};

}  // namespace

BOOST_AUTO_TEST_SUITE(replicas)

BOOST_AUTO_TEST_CASE(every_replica_scene_and_release_has_its_own_seed) {
  SceneFile denser = scene();
  denser.scene.particles += 1;
  std::set<std::uint64_t> seeds;
  for (const SceneFile& file : {scene(), denser})
    for (const std::uint64_t release : {0U, 1U, 2U})
      for (int replica = 0; replica < 32; ++replica) seeds.insert(replica_of(file, replica, release).scene.seed);
  BOOST_TEST(seeds.size() == 2U * 3U * 32U);
  for (const std::uint64_t seed : seeds) BOOST_TEST(seed < (std::uint64_t{1} << 63U));  // TOML's integers
}

BOOST_AUTO_TEST_CASE(the_seed_of_the_scene_file_does_not_matter_and_nothing_else_changes) {
  SceneFile other = scene();
  other.scene.seed = 99;
  const SceneFile a = replica_of(scene(), 3, 0), b = replica_of(other, 3, 0);
  BOOST_TEST(a.scene.seed == b.scene.seed);
  BOOST_TEST(canonical_text(a.scene, a.run) == canonical_text(b.scene, b.run));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(record_store, Fixture)

BOOST_AUTO_TEST_CASE(what_was_saved_is_found_by_what_was_run) {
  BOOST_TEST(!store.load(replica));
  const Record saved = test::fake_record(replica);
  store.save(replica, saved);
  const auto found = store.load(replica);
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(found->trace_hash == saved.trace_hash);
  BOOST_TEST(found->sums == saved.sums, boost::test_tools::per_element());
  BOOST_TEST(reports.empty());
  BOOST_TEST(!store.load(replica_of(scene(), 1, 0)));
  SceneFile longer = replica;
  longer.run.duration *= 2;
  BOOST_TEST(!store.load(longer));
}

BOOST_AUTO_TEST_CASE(density_modes_are_another_record_and_leave_the_others_alone) {
  const SceneFile plain = replica_of(
      parse_scene("[scene]\ngeometry = \"channel\"\nparticles = 40\narea_fraction = 0.2\nwidth_over_diameter = 10\n"
                  "normal_restitution = 0.9\nwall_tangential_restitution = 0.5\n[run]\nduration = 4\n",
                  "channel.toml"),
      0, 0);
  SceneFile waves = plain;
  waves.run.density_modes = 3;
  BOOST_TEST(canonical_text(plain.scene, plain.run).find("density_modes") == std::string::npos);
  BOOST_TEST(store.path(waves) != store.path(plain));
  store.save(plain, test::fake_record(plain));
  store.save(waves, test::fake_record(waves));
  const auto with = store.load(waves), without = store.load(plain);
  BOOST_REQUIRE(with.has_value());
  BOOST_REQUIRE(without.has_value());
  BOOST_TEST(with->run.density_modes == 3);
  BOOST_TEST(with->sums.size() == with->blocks * (TallyLayout(without->run).size() + 3 * 3 + 5));
}

BOOST_AUTO_TEST_CASE(snapshots_come_back) {
  SceneFile file = replica;
  const std::string without = canonical_text(file.scene, file.run);
  BOOST_TEST(without.find("snapshots") == std::string::npos);
  file.run.snapshots = {0.5, 3};
  Record record = test::fake_record(file);
  for (const double time : file.run.snapshots) record.snapshots.push_back({time, record.final_state});
  record.snapshots[1].state.position[5] = {0.25, 0.75};
  record.snapshots[1].state.velocity[5] = {-1, 2};
  store.save(file, record);
  BOOST_TEST(!std::filesystem::exists(store.path(replica)));  // a run without them is another one
  const auto found = store.load(file);
  BOOST_REQUIRE(found.has_value());
  BOOST_REQUIRE(found->snapshots.size() == 2U);
  BOOST_TEST(found->snapshots[0].time == 0.5);
  BOOST_TEST(found->snapshots[1].state.position[5].y == 0.75);
  BOOST_TEST(found->snapshots[1].state.velocity[5].x == -1);
  BOOST_TEST(found->snapshots[0].state.position[35].x == record.final_state.position[35].x);
  record.snapshots[1].time = 5;  // not what was asked for
  store.save(file, record);
  BOOST_TEST(!store.load(file));
  BOOST_REQUIRE(!reports.empty());
  BOOST_TEST(reports.back().find(store.path(file).string()) != std::string::npos);
  record.snapshots.pop_back();
  store.save(file, record);
  BOOST_TEST(!store.load(file));
}

BOOST_AUTO_TEST_CASE(a_truncated_record_is_reported_and_not_used) {
  store.save(replica, test::fake_record(replica));
  const auto size = std::filesystem::file_size(store.path(replica));
  std::filesystem::resize_file(store.path(replica), size / 2);
  BOOST_TEST(!store.load(replica));
  BOOST_REQUIRE(reports.size() == 1U);
  BOOST_TEST(reports[0].find(store.path(replica).string()) != std::string::npos);
  store.save(replica, test::fake_record(replica));  // run again, it is whole
  BOOST_TEST(store.load(replica).has_value());
}

BOOST_AUTO_TEST_CASE(one_changed_byte_is_found) {
  store.save(replica, test::fake_record(replica));
  std::string bytes = read_text(store.path(replica));
  bytes[bytes.size() * 2 / 3] ^= 1;
  write_text_atomically(store.path(replica), bytes);
  BOOST_TEST(!store.load(replica));
  BOOST_TEST(reports.size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_record_is_not_used) {
  for (const std::string& content : {std::string(), std::string("not a record"), std::string(4096, '\0')}) {
    write_text_atomically(store.path(replica), content);
    BOOST_TEST(!store.load(replica));
  }
  BOOST_TEST(reports.size() == 3U);
}

BOOST_AUTO_TEST_CASE(the_record_of_another_run_under_this_name_is_not_used) {
  const SceneFile other = replica_of(scene(), 1, 0);
  write_record(test::fake_record(other), store.path(replica));
  BOOST_TEST(!store.load(replica));
  BOOST_REQUIRE(reports.size() == 1U);
  BOOST_TEST(reports[0].find("another scene") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_record_of_another_physics_version_is_not_used) {
  Record old = test::fake_record(replica);
  old.physics_version = physics_version + 1;
  write_record(old, store.path(replica));
  BOOST_TEST(!store.load(replica));
  BOOST_REQUIRE(reports.size() == 1U);
  BOOST_TEST(reports[0].find("physics version") != std::string::npos);
}

// Only the quick tier is that strict: what takes days is kept as long as the physics version stands.
BOOST_AUTO_TEST_CASE(a_record_made_by_other_sources_is_used_only_where_the_physics_version_is_trusted) {
  for (const int r : {0, 1}) {
    const SceneFile file = replica_of(scene(), r, 0);
    write_record(test::fake_record(file), store.path(file));  // not save(): it does not say who made it
    BOOST_TEST(!store.load(file));
  }
  BOOST_TEST(reports.size() == 1U);  // there may be hundreds
  BOOST_TEST(RecordStore(folder / "records", Trust::same_version).load(replica).has_value());
  BOOST_CHECK(trust_in(Tier::quick) == Trust::same_sources);
  BOOST_CHECK(trust_in(Tier::standard) == Trust::same_version);
  BOOST_CHECK(trust_in(Tier::full) == Trust::same_version);
}

BOOST_AUTO_TEST_CASE(a_saved_record_keeps_its_session) {
  Record record = test::fake_record(replica);
  record.session = "{\"cpu\": \"some\"}";
  store.save(replica, record);
  BOOST_TEST(store.load(replica)->session.find("\"cpu\": \"some\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_made_is_an_error) {
  std::ofstream(folder / "file") << "in the way";
  BOOST_CHECK_THROW(RecordStore(folder / "file" / "records", Trust::same_sources), StorageError);
}

BOOST_AUTO_TEST_SUITE_END()
