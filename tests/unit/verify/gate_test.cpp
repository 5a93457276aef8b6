#include "verify/gate.hpp"

#include <boost/test/unit_test.hpp>

#include "unit/verify/suite_fixture.hpp"

using namespace gpf;

namespace {

/// Two green claims, judged and listed.
struct GreenSuite : test::Suite {
  GreenSuite() {
    claim("one", 9, 11);
    claim("two", 0, 1, 4, "refuted", "beta");
    list("one # the first\n\ntwo\n");
    BOOST_REQUIRE(validate(options) == 0);
  }

  void list(const std::string& ids) const { write_text_atomically(folder / "claims/required.txt", ids); }

  [[nodiscard]] std::vector<std::string> findings() const {
    return gate_findings({Tier::quick, options.store, options.reference, program_hash()});
  }

  /// The gate finds this, and nothing else.
  void finds_only(const std::string& part) const {
    const auto found = findings();
    BOOST_TEST(found.size() == 1U);
    for (const std::string& finding : found) BOOST_TEST(finding.find(part) != std::string::npos, finding);
  }

  void change(const std::string& id, const std::function<void(Verdict&)>& edit) const {
    Verdict v = verdict(id);
    edit(v);
    write_verdict(v, options.store);
  }
};

}  // namespace

BOOST_FIXTURE_TEST_SUITE(gate, GreenSuite)

BOOST_AUTO_TEST_CASE(a_green_suite_passes) {
  BOOST_TEST(findings().empty());
  BOOST_TEST(program_hash() != 0U);
}

BOOST_AUTO_TEST_CASE(a_claim_that_got_lost_is_found) {
  std::filesystem::remove(folder / "claims/two.toml");
  finds_only("claim two is required but has no file");
}

BOOST_AUTO_TEST_CASE(a_claim_that_is_not_listed_is_found) {
  list("two\n");
  finds_only("claim one is not listed");
}

BOOST_AUTO_TEST_CASE(a_claim_without_verdict_is_found) {
  std::filesystem::remove(verdict_path(options.store, Tier::quick, "one"));
  finds_only("claim one has no verdict");
}

BOOST_AUTO_TEST_CASE(a_claim_of_a_higher_tier_needs_no_verdict) {
  claim("later", 0, 1, 4, "reproduced", "alpha", "standard");
  list("one two later\n");
  BOOST_TEST(findings().empty());
}

BOOST_AUTO_TEST_CASE(what_is_not_green_is_found) {
  change("one", [](Verdict& v) { v.outcome = Outcome::inconclusive; });
  finds_only("claim one: inconclusive, expected reproduced");
  change("one", [](Verdict& v) { v.outcome = Outcome::fail; });
  finds_only("claim one: fail, expected reproduced");
}

BOOST_AUTO_TEST_CASE(an_inconclusive_claim_that_is_listed_as_unresolved_is_no_finding) {
  claim("one", 9.999, 10.001, 4, "unresolved");
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(findings().empty());
}

BOOST_AUTO_TEST_CASE(a_verdict_on_another_text_is_stale) {
  claim("one", 9, 11.5);
  finds_only("stale, the claim file has changed");
}

BOOST_AUTO_TEST_CASE(a_verdict_of_another_program_or_physics_is_stale) {
  change("one", [](Verdict& v) { v.program_hash ^= 1; });
  finds_only("another build");
  change("one", [](Verdict& v) { ++v.physics_version; });
  finds_only("another physics version");
}

BOOST_AUTO_TEST_CASE(a_verdict_on_other_runs_is_stale) {
  change("one", [](Verdict& v) { v.records.pop_back(); });
  finds_only("its scenes have changed");
}

BOOST_AUTO_TEST_CASE(a_changed_scene_makes_the_verdict_stale) {
  write_text_atomically(folder / "scenes/alpha.toml",
                        test::replaced(test::periodic_scene, "duration = 8", "duration = 9"));
  finds_only("claim one: its verdict is stale");
}

BOOST_AUTO_TEST_CASE(a_record_that_is_gone_or_damaged_is_found) {
  const auto record = options.store / (verdict("one").records[2] + ".h5");
  std::filesystem::resize_file(record, 700);
  const auto found = findings();  // the store says what is wrong with the file, the gate whose it is
  BOOST_TEST(found.size() == 2U);
  BOOST_TEST(found.back().find("the record of alpha #3 is gone or damaged") != std::string::npos);
  std::filesystem::remove(record);
  finds_only("the record of alpha #3 is gone or damaged");
}

BOOST_AUTO_TEST_CASE(a_damaged_verdict_is_found) {
  write_text_atomically(verdict_path(options.store, Tier::quick, "one"), "{");
  finds_only("claim one: ");
}

BOOST_AUTO_TEST_SUITE_END()
