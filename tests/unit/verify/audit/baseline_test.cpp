#include "verify/audit/baseline.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "unit/verify/audit/made_up_evidence.hpp"
#include "unit/verify/suite_fixture.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(baselines)

BOOST_AUTO_TEST_CASE(a_text_reads_back) {
  EvidenceSet set = test::made_up_evidence();
  set.numbers[0].label = "Z, \"virial\" at nu 0.3";
  set.numbers[0].band.hi = INFINITY;
  set.numbers[0].values[3] = NAN;
  const EvidenceSet read = parse_baseline(baseline_text(set), "baseline.csv");
  BOOST_TEST(baseline_differences(read, set).empty());
  BOOST_TEST(baseline_text(read) == baseline_text(set));
}

BOOST_AUTO_TEST_CASE(damaged_lines_are_refused_with_their_number) {
  for (const char* text : {"run,alpha\n", "run,alpha,12\n", "run,alpha,000000000000000g\n", "check,c,l,mean,0,1\n",
                           "check,c,l,median,0,1,1 2\n", "check,c,l,mean,0,one,1 2\n", "check,c,l,mean,0,1,1 x\n"})
    BOOST_CHECK_EXCEPTION(parse_baseline(text, "baseline.csv"), InputError,
                          [](const InputError& e) { return e.problem().find("line 1") != std::string::npos; });
}

BOOST_AUTO_TEST_CASE(what_differs_is_said_line_by_line) {
  const EvidenceSet set = test::made_up_evidence();
  EvidenceSet other = set;
  other.runs["alpha #1"].trace_hash = 99;
  other.runs.erase("beta #1");
  other.numbers[0].values[0] *= 1 + 1e-10;  // beyond the digits of the file
  other.numbers[1].values[0] = 1e-13;
  BOOST_TEST(baseline_differences(set, other).size() == 3U);
  other = set;
  other.numbers[0].values[0] *= 1 + 1e-6;
  BOOST_TEST(baseline_differences(set, other).size() == 1U);
  other.numbers.pop_back();
  BOOST_TEST(baseline_differences(set, other).size() == 2U);
  BOOST_TEST(baseline_differences(other, set).size() == 2U);
  other = set;
  other.numbers[0].band.hi = 30;
  BOOST_TEST(baseline_differences(set, other).size() == 1U);
  other.numbers[1].exact = false;
  BOOST_TEST(baseline_differences(set, other).size() == 2U);
}

BOOST_AUTO_TEST_CASE(what_is_gone_or_has_a_wider_band_must_be_declared) {
  EvidenceSet set = test::made_up_evidence();
  set.claims.clear();  // a baseline has none
  const auto shown = [&](auto&& change) {
    EvidenceSet other = set;
    change(other);
    return least_class(set, other);
  };
  BOOST_CHECK(shown([](EvidenceSet& e) { e.numbers.pop_back(); }) == PhysicsChange::same_physics);
  BOOST_CHECK(shown([](EvidenceSet& e) { e.runs.erase("beta #1"); }) == PhysicsChange::same_physics);
  BOOST_CHECK(shown([](EvidenceSet& e) { e.numbers[0].band = {-70, 90}; }) == PhysicsChange::same_physics);
  BOOST_CHECK(shown([](EvidenceSet& e) { e.numbers.push_back(e.numbers[0]); }) == PhysicsChange::bitwise);
}

BOOST_AUTO_TEST_CASE(a_baseline_shows_the_mildest_class_that_a_change_may_have) {
  const EvidenceSet set = test::made_up_evidence();
  BOOST_CHECK(least_class(set, set) == PhysicsChange::bitwise);
  EvidenceSet other = test::with_other_trajectories(set);
  BOOST_CHECK(least_class(set, other) == PhysicsChange::roundoff);
  for (double& x : other.numbers[0].values) x += 2.5;
  BOOST_CHECK(least_class(set, other) == PhysicsChange::new_physics);
  other = set;
  for (double& x : other.numbers[0].values) x *= 1 + 5e-9;  // a ninth digit
  BOOST_CHECK(least_class(set, other) == PhysicsChange::roundoff);
  other.numbers[0].values[0] += 3.5;
  BOOST_CHECK(least_class(set, other) == PhysicsChange::same_physics);
}

BOOST_FIXTURE_TEST_CASE(it_is_made_of_a_store_with_all_claims, test::Suite) {
  claim("one", 9, 11);
  claim("two", 9, 11, 4, "reproduced", "beta");
  options.claims = {"one"};
  BOOST_REQUIRE(validate(options) == 0);
  BOOST_CHECK_THROW(baseline_evidence(options.store, options.reference), InputError);
  options.claims.clear();
  BOOST_REQUIRE(validate(options) == 0);
  const EvidenceSet set = baseline_evidence(options.store, options.reference);
  BOOST_TEST(set.runs.size() == 8U);
  BOOST_TEST(set.runs.contains("alpha #4"));
  BOOST_TEST(set.numbers.size() == 2U);
  std::ofstream(options.reference / "claims/algo.two.toml", std::ios::app) << "# edited\n";
  BOOST_CHECK_THROW(baseline_evidence(options.store, options.reference), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
