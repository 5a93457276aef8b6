#include "verify/audit/findings.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "unit/verify/audit/made_up_evidence.hpp"

using namespace gpf;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

PhysicsChange class_between(const EvidenceSet& before, const EvidenceSet& after) {
  return class_of(find_differences(before, after));
}

AuditFindings with_first_event(AuditFindings found, double ulps) {
  found.first = ReplayedDifference{"alpha #1", {}};
  found.first->event.largest_ulps = ulps;
  return found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(audit_findings)

const EvidenceSet before = test::made_up_evidence();

BOOST_AUTO_TEST_CASE(equal_evidence_is_bitwise) {
  const AuditFindings found = find_differences(before, before);
  BOOST_TEST(found.runs == 2U);
  BOOST_TEST(found.numbers == 2U);
  BOOST_TEST(found.equal_numbers == 2U);
  BOOST_CHECK(class_of(found) == PhysicsChange::bitwise);
}

BOOST_AUTO_TEST_CASE(runs_on_one_side_only_are_listed_and_no_error) {
  EvidenceSet after = before;
  after.runs["gamma #1"].name = "gamma #1";
  after.runs.erase("alpha #1");
  const AuditFindings found = find_differences(before, after);
  BOOST_TEST(found.runs_only_before == std::vector<std::string>{"alpha #1"}, boost::test_tools::per_element());
  BOOST_TEST(found.runs_only_after == std::vector<std::string>{"gamma #1"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_compared_is_neither_bitwise_nor_roundoff) {
  EvidenceSet after = before;
  after.runs.clear();
  BOOST_TEST(find_differences(before, after).not_compared.size() == 2U);
  BOOST_CHECK(class_between(before, after) == PhysicsChange::same_physics);
  after = before;
  after.missing_records = {"0123"};
  BOOST_CHECK(class_between(before, after) == PhysicsChange::same_physics);
  BOOST_CHECK(class_of(with_first_event(find_differences(before, after), 1)) == PhysicsChange::same_physics);
  for (double& x : after.numbers[0].values) x += 2.5;
  BOOST_CHECK(class_between(before, after) == PhysicsChange::new_physics);
  // A scene that is new, and fewer replicas of an old one, leave nothing uncompared.
  EvidenceSet more = before;
  more.runs["alpha #2"] = more.runs["alpha #1"];
  more.runs["alpha #2"].name = "alpha #2";
  BOOST_CHECK(class_between(more, before) == PhysicsChange::bitwise);
  more.runs["gamma #1"] = more.runs["alpha #1"];
  more.runs["gamma #1"].name = "gamma #1";
  BOOST_CHECK(class_between(before, more) == PhysicsChange::bitwise);
  BOOST_CHECK(class_between(more, before) == PhysicsChange::same_physics);
}

BOOST_AUTO_TEST_CASE(other_trajectories_of_equal_statistics_are_roundoff_or_same_physics_by_the_first_event) {
  const AuditFindings found = find_differences(before, test::with_other_trajectories(before));
  BOOST_TEST(found.other_trajectories.size() == 2U);
  BOOST_CHECK(class_of(found) == PhysicsChange::same_physics);  // not replayed
  BOOST_CHECK(class_of(with_first_event(found, 3)) == PhysicsChange::roundoff);
  BOOST_CHECK(class_of(with_first_event(found, 5000)) == PhysicsChange::same_physics);
  BOOST_CHECK(class_of(with_first_event(found, infinity)) == PhysicsChange::same_physics);
}

BOOST_AUTO_TEST_CASE(a_number_that_moves_is_new_physics_however_small_the_first_difference) {
  EvidenceSet after = test::with_other_trajectories(before);
  for (double& x : after.numbers[0].values) x += 2.5;
  const AuditFindings found = find_differences(before, after);
  BOOST_TEST(found.shifts.any_named());
  BOOST_CHECK(class_of(with_first_event(found, 1)) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(a_broken_identity_is_new_physics) {
  EvidenceSet after = test::with_other_trajectories(before);
  after.numbers[1].values = {1e-11};
  const AuditFindings found = find_differences(before, after);
  BOOST_TEST(found.broken_identities.size() == 1U);
  BOOST_CHECK(class_of(with_first_event(found, 1)) == PhysicsChange::new_physics);
  after.numbers[1].values = {9e-13};
  BOOST_CHECK(class_between(before, after) == PhysicsChange::same_physics);
}

BOOST_AUTO_TEST_CASE(a_verdict_that_turns_red_is_new_physics_and_one_that_needs_more_data_is_not) {
  EvidenceSet after = test::with_other_trajectories(before);
  after.claims["claim"].outcome = Outcome::fail;
  after.claims["claim"].green = false;
  BOOST_CHECK(class_between(before, after) == PhysicsChange::new_physics);
  after.claims["claim"].outcome = Outcome::inconclusive;
  BOOST_TEST(find_differences(before, after).flips.size() == 1U);
  BOOST_CHECK(class_between(before, after) == PhysicsChange::same_physics);
}

BOOST_AUTO_TEST_CASE(on_equal_trajectories_a_difference_is_exact) {
  EvidenceSet after = before;
  for (double& x : after.numbers[0].values) x *= 1 + 1e-12;
  BOOST_CHECK(class_between(before, after) == PhysicsChange::roundoff);
  for (double& x : after.numbers[0].values) x += 3.5;  // half of the tolerance is 4
  BOOST_CHECK(class_between(before, after) == PhysicsChange::same_physics);
  for (double& x : after.numbers[0].values) x += 1;
  BOOST_CHECK(class_between(before, after) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(sums_that_no_claim_reads_may_differ_by_round_off_only) {
  EvidenceSet after = before;
  RunDigest& run = after.runs["alpha #1"];
  run.measured = 2;
  run.sums[1] *= 1 + 1e-13;
  BOOST_CHECK(class_between(before, after) == PhysicsChange::roundoff);
  run.sums[1] *= 1.01;
  const AuditFindings found = find_differences(before, after);
  BOOST_TEST(found.largest_relative_sum > 0.009);
  BOOST_CHECK(class_of(found) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(measurements_that_cannot_be_sized_are_no_round_off) {
  const auto class_with = [](auto&& change) {
    EvidenceSet after = before;
    after.runs["alpha #1"].measured = 2;
    change(after.runs["alpha #1"]);
    return class_between(before, after);
  };
  BOOST_CHECK(class_with([](RunDigest&) {}) == PhysicsChange::new_physics);  // in nothing that is summed up
  BOOST_CHECK(class_with([](RunDigest& r) { r.sums.pop_back(); }) == PhysicsChange::new_physics);
  BOOST_CHECK(class_with([](RunDigest& r) { r.sums[0] = NAN; }) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(a_number_that_is_no_longer_measured_is_lost) {
  EvidenceSet after = test::with_other_trajectories(before);
  for (double& x : after.numbers[0].values) x = NAN;
  BOOST_TEST(find_differences(before, after).lost.size() == 1U);
  BOOST_CHECK(class_between(before, after) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(a_single_value_of_chance_is_no_identity) {
  EvidenceSet one = before, after = test::with_other_trajectories(before);
  one.numbers[1] = {"claim", "so many standard errors", {-1.57}, {-3, 3}, false, false};
  after.numbers[1] = one.numbers[1];
  after.numbers[1].values = {3.2};
  BOOST_TEST(find_differences(one, after).broken_identities.empty());
  BOOST_CHECK(class_between(one, after) == PhysicsChange::same_physics);
  after.numbers[1].values = {4.6};
  BOOST_CHECK(class_between(one, after) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(one_number_named_among_many_is_not_yet_new_physics) {
  AuditFindings found = find_differences(before, test::with_other_trajectories(before));
  found.shifts.global_p = found.shifts.all[0].p_adjusted = 0.03;
  BOOST_TEST(found.shifts.any_named());
  BOOST_CHECK(class_of(found) == PhysicsChange::same_physics);
  found.shifts.global_p = 0.01;
  BOOST_CHECK(class_of(found) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(what_is_gone_although_its_claim_is_the_same_is_new_physics) {
  EvidenceSet after = before;
  after.numbers.pop_back();
  BOOST_TEST(find_differences(before, after).lost.size() == 1U);
  BOOST_CHECK(class_between(before, after) == PhysicsChange::new_physics);
  after.claims["claim"].claim_hash = 8;  // the claim's file was edited
  BOOST_CHECK(class_between(before, after) == PhysicsChange::bitwise);
  after.claims.clear();
  BOOST_CHECK(class_between(before, after) == PhysicsChange::new_physics);
}

BOOST_AUTO_TEST_CASE(of_more_replicas_on_one_side_those_of_both_are_compared) {
  EvidenceSet after = before;
  after.numbers[0].values.push_back(11);
  const AuditFindings found = find_differences(before, after);
  BOOST_TEST(found.notes.size() == 1U);
  BOOST_CHECK(class_of(found) == PhysicsChange::bitwise);
}

BOOST_AUTO_TEST_CASE(numbers_of_equal_labels_are_paired_in_their_order) {
  EvidenceSet twice = before;
  twice.numbers.push_back(twice.numbers[1]);
  twice.numbers.back().values = {5e-13};
  BOOST_CHECK(class_between(twice, twice) == PhysicsChange::bitwise);
}

BOOST_AUTO_TEST_CASE(half_of_a_tolerance) {
  BOOST_TEST(half_tolerance({2, 6}, 3) == 1.0);
  BOOST_TEST(half_tolerance({2, infinity}, 3) == 0.5);
  BOOST_TEST(half_tolerance({-infinity, 4}, 3) == 0.5);
  BOOST_TEST(half_tolerance({2, 6}, 7) == 0.0);
  BOOST_TEST(half_tolerance({-infinity, infinity}, 3) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
