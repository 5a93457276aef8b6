#include "verify/validate.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "unit/verify/suite_fixture.hpp"

using namespace gpf;

namespace {

/// What `action` prints on standard output.
template <class Action>
std::string printed(const std::filesystem::path& scratch, Action action) {
  std::fflush(stdout);
  const int saved = ::dup(STDOUT_FILENO), file = ::open(scratch.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ::dup2(file, STDOUT_FILENO);
  action();
  std::fflush(stdout);
  ::dup2(saved, STDOUT_FILENO);
  ::close(saved);
  ::close(file);
  return read_text(scratch);
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(validation, test::Suite)

BOOST_AUTO_TEST_CASE(the_status_follows_from_outcome_and_expectation) {
  claim("inside", 9, 11);
  claim("outside.refuted", 0, 1, 4, "refuted");
  claim("open.unresolved", 9.999, 10.001, 4, "unresolved");
  BOOST_TEST(validate(options) == 0);
  BOOST_CHECK(verdict("inside").outcome == Outcome::pass);
  BOOST_CHECK(verdict("outside.refuted").outcome == Outcome::fail);
  BOOST_CHECK(verdict("open.unresolved").outcome == Outcome::inconclusive);
  for (const std::string id : {"inside", "outside.refuted", "open.unresolved"}) BOOST_TEST(verdict(id).green);

  claim("open", 9.999, 10.001);
  BOOST_TEST(validate(options) == 77);
  claim("refuted.but.passes", 9, 11, 4, "refuted");
  BOOST_TEST(validate(options) == 1);
  options.claims = {"open"};
  BOOST_TEST(validate(options) == 77);
  options.claims = {"inside"};
  BOOST_TEST(validate(options) == 0);
}

BOOST_AUTO_TEST_CASE(runs_are_shared_and_never_repeated) {
  claim("one", 9, 11);
  claim("two", 8, 12);
  claim("three", 9, 11, 4, "reproduced", "beta");
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(runs() == 8U);  // two scenes, four replicas
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(runs() == 8U);
  BOOST_TEST(verdict("one").records == verdict("two").records, boost::test_tools::per_element());
  BOOST_TEST(verdict("one").cpu_seconds == 4 * 0.25);
}

// Half widths with alpha/4 and a deviation of 1/8: 0.47, 0.18, 0.10, 0.07 at R = 4, 8, 16, 32. A band of +-0.15 takes
// 16 or 32 replicas, one of +-1 the first four.
BOOST_AUTO_TEST_CASE(only_what_is_undecided_is_looked_at_again) {
  claim("easy", 9, 11, 32, "reproduced", "beta");
  claim("hard", 9.85, 10.15, 32);
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(verdict("easy").replicas == 4);
  const int replicas = verdict("hard").replicas;
  BOOST_TEST(replicas >= 16);
  BOOST_TEST(runs() == static_cast<std::size_t>(4 + replicas));
  BOOST_TEST(verdict("hard").records.size() == static_cast<std::size_t>(replicas));
  BOOST_TEST(verdict("hard").alpha == 0.0025);
}

BOOST_AUTO_TEST_CASE(the_cap_ends_the_looks) {
  claim("open", 9.999, 10.001, 8);
  BOOST_TEST(validate(options) == 77);
  BOOST_TEST(verdict("open").replicas == 8);
  BOOST_TEST(verdict("open").look == 2);
  BOOST_TEST(runs() == 8U);
}

BOOST_AUTO_TEST_CASE(runs_alone_are_those_of_the_first_look) {
  claim("one", 9, 11, 32);
  claim("two", 9, 11, 4, "reproduced", "beta");
  options.only_runs = {"beta"};
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(runs() == 4U);
  BOOST_TEST(!has_verdict("two"));
  options.only_runs = {"alpha", "beta"};
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(runs() == 8U);
  options.only_runs = {"gamma"};
  BOOST_CHECK_THROW(validate(options), InputError);
}

BOOST_AUTO_TEST_CASE(an_unhealthy_claim_is_inconclusive) {
  claim("inside", 9, 11);
  options.run = [](const SceneFile& file, const SimulationOptions&) {
    Record record = test::fake_record(file);
    record.deepest_overlap = 1e-3;
    return record;
  };
  BOOST_TEST(validate(options) == 77);
  BOOST_TEST(verdict("inside").summary.find("overlap") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_failed_run_is_no_verdict_and_its_status_is_passed_on) {
  claim("lost", 9, 11);
  claim("kept", 9, 11, 4, "reproduced", "beta");
  const double spoiled = parse_scene(test::periodic_scene, "alpha").scene.area_fraction();
  options.run = [spoiled](const SceneFile& file, const SimulationOptions&) {
    if (file.scene.area_fraction() == spoiled) throw PhysicsError("disks overlap", "by 0.1 d", "report it");
    return test::fake_record(file);
  };
  BOOST_TEST(validate(options) == 3);
  BOOST_TEST(!has_verdict("lost"));
  BOOST_TEST(has_verdict("kept"));
}

BOOST_AUTO_TEST_CASE(an_estimator_that_gives_up_leaves_no_old_verdict_behind) {
  claim("inside", 9, 11);
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(has_verdict("inside"));
  options.estimators = [](std::string_view) -> Estimator {
    return [](const Claim&, Tier, const SceneRecords&) -> Evidence {
      throw InputError("it found nothing to check", "the records are of another kind", "correct it");
    };
  };
  BOOST_TEST(validate(options) == 2);
  BOOST_TEST(!has_verdict("inside"));
}

BOOST_AUTO_TEST_CASE(an_unknown_estimator_is_refused_before_anything_runs) {
  claim("inside", 9, 11);
  options.estimators = [](std::string_view name) -> Estimator {
    throw InputError("unknown estimator '" + std::string(name) + "'", "there is none", "correct it");
  };
  options.run = [](const SceneFile&, const SimulationOptions&) -> std::optional<Record> {
    throw std::logic_error("it ran");
  };
  BOOST_CHECK_THROW(validate(options), InputError);
  BOOST_TEST(!std::filesystem::exists(options.store / "verdicts"));
}

BOOST_AUTO_TEST_CASE(a_stop_ends_with_its_own_status) {
  claim("inside", 9, 11);
  volatile std::sig_atomic_t stop = 1;
  options.stop = &stop;
  BOOST_TEST(validate(options) == 75);
  BOOST_TEST(!has_verdict("inside"));
}

BOOST_AUTO_TEST_CASE(unknown_claims_are_named_with_the_nearest_known_one) {
  claim("inside", 9, 11);
  options.claims = {"insider"};
  BOOST_CHECK_EXCEPTION(validate(options), InputError,
                        [](const InputError& error) { return error.remedy() == "did you mean 'inside'?"; });
}

BOOST_AUTO_TEST_CASE(a_claim_of_a_higher_tier_is_left_out_and_refused_by_name) {
  claim("inside", 9, 11);
  claim("later", 0, 1, 4, "reproduced", "alpha", "standard");
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(!has_verdict("later"));
  options.claims = {"later"};
  BOOST_CHECK_THROW(validate(options), InputError);
}

BOOST_AUTO_TEST_CASE(quick_has_fixed_seeds_and_standard_fresh_ones_for_each_release) {
  claim("inside", 9, 11);
  BOOST_TEST(validate(options) == 0);
  const auto fixed = verdict("inside").records;
  options.release_seed = 5;
  BOOST_CHECK_THROW(validate(options), InputError);
  options.tier = Tier::standard;
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(verdict("inside").release_seed == 5U);
  BOOST_TEST(verdict("inside").records != fixed);
  options.release_seed = 0;
  BOOST_TEST(validate(options) == 0);
  BOOST_TEST(verdict("inside").release_seed == default_release_seed());
  BOOST_TEST(runs() == 12U);
}

BOOST_AUTO_TEST_CASE(a_fail_with_fresh_seeds_gets_one_confirmation_run) {
  claim("outside", 0, 1);
  claim("outside.refuted", 0, 1, 4, "refuted", "beta");
  options.tier = Tier::standard;
  options.release_seed = 5;
  BOOST_TEST(validate(options) == 1);
  BOOST_TEST(runs() == 12U);  // the expected fail is not repeated
  const Verdict v = verdict("outside");
  BOOST_TEST(v.release_seed == mix(5));
  BOOST_REQUIRE(!v.notes.empty());
  BOOST_TEST(
      v.notes.back().starts_with("Confirmation run with new seeds; with release seed 5 it failed: virial of alpha"));
  BOOST_TEST(verdict("outside.refuted").release_seed == 5U);
}

// The first replicas are off, the confirmation's are not: bad luck is forgiven once.
BOOST_AUTO_TEST_CASE(a_fail_that_is_not_confirmed_is_a_pass) {
  claim("inside", 9, 11);
  options.tier = Tier::standard;
  options.release_seed = 5;
  std::vector<std::uint64_t> unlucky;
  for (int r = 0; r < 4; ++r)
    unlucky.push_back(replica_of(parse_scene(test::periodic_scene, "alpha"), r, 5).scene.seed);
  options.run = [unlucky](const SceneFile& file, const SimulationOptions&) {
    const bool off = std::count(unlucky.begin(), unlucky.end(), file.scene.seed) > 0;
    return test::fake_record(file, 64,
                             [off](std::size_t, std::size_t, double noise) { return (off ? 20 : 10) + noise; });
  };
  BOOST_TEST(validate(options) == 0);
  BOOST_CHECK(verdict("inside").outcome == Outcome::pass);
}

BOOST_AUTO_TEST_CASE(the_table_shows_trouble_first) {
  claim("a.inside", 9, 11);
  claim("b.open", 9.999, 10.001);
  claim("c.outside", 0, 1);
  const std::string table = printed(folder / "out", [&] { validate(options); });
  const auto red = table.find("c.outside"), open = table.find("b.open"), green = table.find("a.inside");
  BOOST_TEST(red != std::string::npos);
  BOOST_TEST(red < open);
  BOOST_TEST(open < green);
  BOOST_TEST(table.find("3 claim(s), 1 green, 1 red, 1 open") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(json_is_one_object_on_standard_output) {
  claim("inside", 9, 11);
  options.json = true;
  const std::string text = printed(folder / "out", [&] { BOOST_TEST(validate(options) == 0); });
  const auto json = nlohmann::json::parse(text);
  BOOST_TEST(json.at("tier") == "quick");
  BOOST_TEST(json.at("problems").empty());
  const auto& claim_json = json.at("claims").at(0);
  BOOST_TEST(claim_json.at("id") == "inside");
  BOOST_TEST(claim_json.at("outcome") == "pass");
  BOOST_TEST(claim_json.at("green") == true);
  BOOST_TEST(claim_json.at("replicas") == 4);
}

BOOST_AUTO_TEST_SUITE_END()
