#include "verify/report_data.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "support/scenes.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/synthetic_claim.hpp"
#include "verify/simulate.hpp"
#include "verify/verdict_file.hpp"

using gpf::Tier;

namespace {

/// A folder with claims and a store, empty at first.
struct Suite {
  gpf::test::TemporaryFolder folder;
  std::filesystem::path store = folder / "records", reference = folder / "reference";

  Suite() {
    std::filesystem::create_directories(reference / "claims");
    std::filesystem::create_directories(store);
  }
  void add_claim(const std::string& id, const std::string& text) const {
    gpf::write_text_atomically(reference / "claims" / (id + ".toml"), text);
  }
  gpf::ReportData load() const { return gpf::load_report_data(Tier::quick, store, reference); }
};

/// The claim's verdict as if it had read these records.
void write_verdict(const Suite& suite, const std::string& id, const std::string& text, std::vector<std::string> records,
                   int replicas) {
  const gpf::Claim claim = gpf::parse_claim(text, id + ".toml");
  gpf::Evidence evidence;
  evidence.checks = {gpf::test::check("value", 0.2, 0.1, {-1, 1})};
  evidence.extra_cpu_seconds = 0.5;
  gpf::Verdict verdict = gpf::judge(claim, Tier::quick, evidence, replicas, 1, 1);
  for (const std::string& name : records)
    verdict.cpu_seconds += gpf::read_record(suite.store / (name + ".h5")).cpu_seconds;
  verdict.records = std::move(records);
  gpf::write_verdict(verdict, suite.store);
}

/// Simulates a small gas and stores the record; returns its name.
std::string make_record(const Suite& suite, std::uint64_t seed) {
  gpf::SceneFile file;
  file.scene = gpf::test::gas(16, 0.3, 1, seed);
  file.run = {1, 2, 0, 0.25, 2};
  const gpf::Record record = gpf::simulate(file).value();
  const std::string name = gpf::record_name(file.scene, file.run);
  gpf::write_record(record, suite.store / (name + ".h5"));
  return name;
}

const std::string reads_scenes = "[scenes]\nquick = [\"gas\"]\n[replicas]\nquick = 4\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(report_data)

BOOST_AUTO_TEST_CASE(missing_verdicts_name_the_claims_and_the_command) {
  const Suite suite;
  for (const std::string id : {"a.one", "b.two"}) suite.add_claim(id, gpf::test::synthetic_claim_text(id));
  write_verdict(suite, "a.one", gpf::test::synthetic_claim_text("a.one"), {}, 4);
  BOOST_CHECK_EXCEPTION(suite.load(), gpf::InputError, [](const gpf::InputError& error) {
    const std::string what = error.what();
    return what.find("b.two") != std::string::npos && what.find("a.one") == std::string::npos &&
           what.find("gpf validate --tier quick") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(chosen_claims_need_no_others) {
  const Suite suite;
  for (const std::string id : {"a.one", "b.two"}) suite.add_claim(id, gpf::test::synthetic_claim_text(id));
  write_verdict(suite, "a.one", gpf::test::synthetic_claim_text("a.one"), {}, 4);
  const gpf::ReportData data = gpf::load_report_data(Tier::quick, suite.store, suite.reference, {"a.one"});
  BOOST_REQUIRE(data.claims.size() == 1U);
  BOOST_TEST(data.claims[0].claim.id == "a.one");
  BOOST_TEST(data.of_claims == 2U);
  BOOST_CHECK_THROW(gpf::load_report_data(Tier::quick, suite.store, suite.reference, {"c.three"}), gpf::InputError);
}

BOOST_AUTO_TEST_CASE(a_verdict_on_another_text_is_refused) {
  const Suite suite;
  suite.add_claim("a.one", gpf::test::synthetic_claim_text("a.one"));
  write_verdict(suite, "a.one", gpf::test::synthetic_claim_text("a.one"), {}, 4);
  BOOST_TEST(suite.load().claims.size() == 1u);
  suite.add_claim("a.one", gpf::test::synthetic_claim_text("a.one") + "# changed\n");
  BOOST_CHECK_EXCEPTION(suite.load(), gpf::InputError, [](const gpf::InputError& error) {
    return std::string(error.what()).find("gpf validate --tier quick a.one") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(shared_runs_are_counted_once) {
  const Suite suite;
  const std::vector<std::string> names{make_record(suite, 1), make_record(suite, 2), make_record(suite, 3),
                                       make_record(suite, 4)};
  for (const std::string id : {"a.one", "b.two"}) {
    // The tables of a claim file follow its plain keys.
    const std::string text = gpf::test::synthetic_claim_text(id) + reads_scenes;
    suite.add_claim(id, text);
    write_verdict(suite, id, text, names, 4);
  }
  std::uint64_t collisions = 0;
  double cpu_seconds = 0;
  for (const std::string& name : names) {
    const gpf::Record record = gpf::read_record(suite.store / (name + ".h5"));
    collisions += record.counts.pair_contacts;
    cpu_seconds += record.cpu_seconds;
  }
  BOOST_REQUIRE(collisions > 0u);

  const gpf::ReportData data = suite.load();
  BOOST_TEST(data.runs == 4u);
  BOOST_TEST(data.collisions == collisions);
  BOOST_TEST(data.cpu_seconds == cpu_seconds + 2 * 0.5, boost::test_tools::tolerance(1e-9));  // and two estimators
  BOOST_REQUIRE(data.scenes.size() == 1u);
  const gpf::SceneCost& scene = data.scenes.at("gas");
  BOOST_TEST(scene.records.size() == 4u);
  BOOST_TEST(scene.collisions == collisions);
  BOOST_TEST(scene.claims == std::vector<std::string>({"a.one", "b.two"}));
  BOOST_TEST(data.provenance.at("version").size() == 1u);
  BOOST_TEST(data.provenance.contains("cpu"));
  BOOST_TEST(data.dates.begin()->size() == 10u);  // 2024-05-06

  std::filesystem::remove(suite.store / (names[2] + ".h5"));
  BOOST_CHECK_EXCEPTION(suite.load(), gpf::InputError, [&](const gpf::InputError& error) {
    return std::string(error.what()).find(names[2]) != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(a_verdict_on_other_runs_is_refused) {
  const Suite suite;
  const std::string name = make_record(suite, 1), text = gpf::test::synthetic_claim_text("a.one") + reads_scenes;
  suite.add_claim("a.one", text);
  write_verdict(suite, "a.one", text, {name}, 4);
  BOOST_CHECK_THROW(suite.load(), gpf::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
