#include "verify/health.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "unit/verify/fake_run.hpp"
#include "verify/store.hpp"

using namespace gpf;

namespace {

SceneRecords records_of(const std::string& scene, int replicas, std::size_t blocks = 64,
                        const test::Course& course = test::steady, std::uint64_t release = 0) {
  SceneRecords records;
  const SceneFile file = parse_scene(scene, "scene.toml");
  for (int r = 0; r < replicas; ++r)
    records["scene"].push_back(test::fake_record(replica_of(file, r, release), blocks, course));
  return records;
}

const HealthCheck& named(const std::vector<HealthCheck>& checks, const std::string& beginning) {
  const auto found =
      std::find_if(checks.begin(), checks.end(), [&](const HealthCheck& h) { return h.name.starts_with(beginning); });
  BOOST_REQUIRE_MESSAGE(found != checks.end(), "no health check named " + beginning);
  return *found;
}

bool passes(const SceneRecords& records, const std::string& beginning, const Claim& claim = {}) {
  return named(check_records(claim, records, true), beginning).passed;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(health)

BOOST_AUTO_TEST_CASE(steady_replicas_are_healthy) {
  for (const std::string& scene : {test::channel_scene, test::periodic_scene}) {
    const auto checks = check_records({}, records_of(scene, 8), true);
    BOOST_TEST(checks.size() == 5U);
    for (const HealthCheck& h : checks) BOOST_TEST(h.passed, h.name << ": " << h.detail);
  }
}

BOOST_AUTO_TEST_CASE(a_drift_is_found_and_a_claim_about_the_transient_may_drift) {
  const auto transient = [](std::size_t block, std::size_t, double noise) {
    return 10 + noise + 20 * std::exp(-static_cast<double>(block) / 8);
  };
  const SceneRecords records = records_of(test::channel_scene, 4, 64, transient);
  BOOST_TEST(!passes(records, "steady"));
  BOOST_TEST(named(check_records({}, records, true), "steady").detail.find("first quarter against the rest") !=
             std::string::npos);
  Claim claim;
  claim.transient = true;
  BOOST_TEST(check_records(claim, records, true).size() == 3U);
  BOOST_TEST(check_records({}, records, false).size() == 3U);  // exact checks need no steady state
}

BOOST_AUTO_TEST_CASE(few_blocks_or_one_replica_cannot_show_a_steady_state) {
  BOOST_TEST(!passes(records_of(test::channel_scene, 4, 31), "steady"));
  BOOST_TEST(passes(records_of(test::channel_scene, 4, 32), "steady"));
  BOOST_TEST(!passes(records_of(test::channel_scene, 1), "steady"));
}

BOOST_AUTO_TEST_CASE(a_scene_without_steady_state_is_not_asked_for_one) {
  SceneRecords records = records_of(test::periodic_scene, 4, 8);
  for (Record& record : records["scene"]) record.scene.normal_restitution = 0.5;
  BOOST_TEST(passes(records, "steady"));
}

// 0.27 % for the claim, however many scenes and fields it reads: here 4 scenes x 3 fields x 2 contrasts. The fields of
// a fake record share no noise. 1000 claims: 2.7 false alarms expected; more than 11 have a probability below 1e-4.
BOOST_AUTO_TEST_CASE(many_scenes_raise_no_more_false_alarms_than_one) {
  int alarms = 0;
  for (std::uint64_t claim = 1; claim <= 1000; ++claim) {
    SceneRecords records;
    for (int scene = 0; scene < 4; ++scene)
      records["scene " + std::to_string(scene)] =
          records_of(test::channel_scene, 4, 32, test::steady, 10 * claim + static_cast<std::uint64_t>(scene))
              .at("scene");
    alarms += !passes(records, "steady");
  }
  BOOST_TEST(alarms <= 11);
}

BOOST_AUTO_TEST_CASE(replicas_that_scatter_more_than_their_block_errors_are_told) {
  // Each replica has a level of its own: its blocks do not know. Deviation of the levels 3, block error 1/8.
  SceneRecords records;
  const SceneFile file = parse_scene(test::channel_scene, "scene.toml");
  for (int r = 0; r < 8; ++r) {
    const double level = 10 + 3 * (r % 2 == 0 ? 1 : -1);
    const auto course = [level](std::size_t, std::size_t, double noise) { return level + noise; };
    records["scene"].push_back(test::fake_record(replica_of(file, r, 0), 64, course));
  }
  const auto told = [&] {
    const auto checks = check_records({}, records, true);
    BOOST_TEST(named(checks, "replicas scatter").passed);  // verdicts rest on the scatter alone
    return named(checks, "replicas scatter").detail.find("states of their own") != std::string::npos;
  };
  BOOST_TEST(told());
  records["scene"].resize(7);
  BOOST_TEST(!told());  // not judged with fewer than eight
}

// Replicas that share their noise but for a twentieth: 16 runs that are hardly more than one.
BOOST_AUTO_TEST_CASE(replicas_that_agree_better_than_their_block_errors_are_found) {
  const auto shared = [](std::size_t block, std::size_t field, double noise) {
    return 10 + std::sin(static_cast<double>((block + 1) * (block + 1) * (field + 2))) + 0.05 * noise;
  };
  BOOST_TEST(!passes(records_of(test::channel_scene, 16, 64, shared), "replicas scatter"));
}

// Blocks are changes of a bounded quantity: block errors are many times the scatter, and too large.
BOOST_AUTO_TEST_CASE(block_errors_are_not_believed_where_neighbouring_blocks_undo_each_other) {
  const auto position = [](std::size_t k) { return std::sin(static_cast<double>(k * k)); };
  const auto changes = [&](std::size_t block, std::size_t field, double noise) {
    return 10 + position(block + field + 1) - position(block + field) + 0.05 * noise;
  };
  const auto checks = check_records({}, records_of(test::channel_scene, 16, 64, changes), true);
  BOOST_TEST(named(checks, "replicas scatter").passed);
  BOOST_TEST(named(checks, "replicas scatter").detail.find("undo each other") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(equal_replicas_are_found) {
  SceneRecords records = records_of(test::channel_scene, 4);
  BOOST_TEST(passes(records, "replicas differ"));
  records["scene"][3].trace_hash = records["scene"][1].trace_hash;
  BOOST_TEST(!passes(records, "replicas differ"));
}

BOOST_AUTO_TEST_CASE(overlaps_and_lost_energy_are_found) {
  SceneRecords records = records_of(test::channel_scene, 4);
  records["scene"][2].deepest_overlap = 0.9e-12 * records["scene"][2].scene.diameter();
  BOOST_TEST(passes(records, "disks"));
  records["scene"][2].deepest_overlap = 1.1e-12 * records["scene"][2].scene.diameter();
  BOOST_TEST(!passes(records, "disks"));
  records["scene"][2].deepest_overlap = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(!passes(records, "disks"));
  // In a channel 294 W long positions are known to 2^-43 W only.
  records = records_of(test::channel_scene, 4);
  Scene& scene = records["scene"][2].scene;
  scene.width_over_diameter = 31, scene.length_over_width = 294, scene.particles = 900;
  BOOST_TEST(healthy_overlap(scene) == 2 * 0x1p-43 * 31);
  records["scene"][2].deepest_overlap = 1.9 * 0x1p-43;
  BOOST_TEST(passes(records, "disks"));
  records["scene"][2].deepest_overlap = 2.1 * 0x1p-43;
  BOOST_TEST(!passes(records, "disks"));

  const TallyLayout layout(records["scene"][0].run);
  BOOST_TEST(passes(records, "energy"));
  double& loss = records["scene"][0].sums[layout.at(Tally::pair_loss)];
  loss = 1e-12;  // against a kinetic energy of 10
  BOOST_TEST(passes(records, "energy"));
  loss = 1e-7;
  BOOST_TEST(!passes(records, "energy"));
}

BOOST_AUTO_TEST_CASE(a_claim_without_runs_has_nothing_to_check) { BOOST_TEST(check_records({}, {}, true).empty()); }

BOOST_AUTO_TEST_SUITE_END()
