#include "verify/audit/page.hpp"

#include <boost/test/unit_test.hpp>

#include "gpf/base/error.hpp"
#include "unit/verify/audit/made_up_evidence.hpp"

using namespace gpf;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

AuditReport report_on(const EvidenceSet& before, const EvidenceSet& after) {
  AuditReport report;
  report.before = "v1";
  report.after = "v2";
  report.findings = find_differences(before, after);
  report.found = class_of(report.findings);
  report.environment = environment_of(before, after);
  report.cost = cost_of_records(before, after);
  return report;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(audit_pages)

const EvidenceSet before = test::made_up_evidence();

BOOST_AUTO_TEST_CASE(the_answer_comes_first) {
  AuditReport report = report_on(before, before);
  report.declared = PhysicsChange::roundoff;
  const std::string page = audit_page(report);
  BOOST_TEST(page.starts_with("# Audit of v2 against v1\n\n**bitwise**, declared roundoff: **accepted**. All 2 runs"),
             page);
  BOOST_TEST(contains(page, "The same commit, compiler"), page);
  BOOST_TEST(contains(page, "not interleaved"), page);
}

BOOST_AUTO_TEST_CASE(nothing_is_said_of_what_was_not_run) {
  AuditReport report;
  report.before = "v1";
  report.after = ".";
  report.same_sources = true;
  BOOST_TEST(contains(audit_page(report), "nothing was run"));
  BOOST_TEST(!contains(audit_page(report), "##"));
}

BOOST_AUTO_TEST_CASE(a_rejected_change_shows_what_moved_and_which_verdicts) {
  EvidenceSet after = test::with_other_trajectories(before);
  for (double& x : after.numbers[0].values) x += 2.5;
  after.numbers[1].values = {1e-11};
  after.claims["claim"] = {Outcome::fail, false, 7, "a number is out of its band"};
  AuditReport report = report_on(before, after);
  report.declared = PhysicsChange::same_physics;
  report.why_no_replay = "Stores without their programs cannot be replayed";
  const std::string page = audit_page(report);
  for (const char* part : {"**new physics**, declared same physics: **rejected**", "2 of 2 runs go other ways",
                           "| claim | a number ", "[2, 18]", "a number is out of its band",
                           "other trajectories (2): alpha (1); beta (1)", "cannot be replayed", "claim: an identity"})
    BOOST_TEST(contains(page, part), page);
}

BOOST_AUTO_TEST_CASE(the_first_event_that_differs_is_shown_with_its_numbers) {
  AuditReport report = report_on(before, test::with_other_trajectories(before));
  EventDifference event;
  event.epoch = 3;
  event.event = 17;
  event.before = event.after = {0.5, 4, -2, {}};
  event.numbers = {{"v_x of disk 4", 0.5, 0.75, 1e15, 0.5}};
  report.findings.first = ReplayedDifference{"alpha #1", event};
  const std::string page = audit_page(report);
  BOOST_TEST(contains(page, "epoch 3, event 17: disk 4 and the upper wall."), page);
  BOOST_TEST(contains(page, "v_x of disk 4"), page);
}

BOOST_AUTO_TEST_CASE(only_what_differs_in_the_environment_is_shown) {
  EvidenceSet after = before;
  for (auto& [key, run] : after.runs)
    run.build = R"({"compiler": "clang 14", "flags": "-O2", "libraries": {"HDF5": "1.10"}})";
  const std::string page = audit_page(report_on(before, after));
  BOOST_TEST(contains(page, "clang 14"), page);
  BOOST_TEST(!contains(page, "-O2"), page);
}

BOOST_AUTO_TEST_CASE(cost_is_a_ratio_of_medians_with_the_spread_of_the_rounds) {
  const CostComparison cost = cost_of_rounds({1, 2, 3}, {2, 2, 9});
  BOOST_TEST(cost.ratio == 1.0);
  BOOST_TEST(cost.least == 1.0);
  BOOST_TEST(cost.most == 3.0);
  BOOST_CHECK_THROW(cost_of_rounds({1, 2}, {1}), InputError);
  BOOST_CHECK_THROW(cost_of_rounds({}, {}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
