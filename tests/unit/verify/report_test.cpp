#include "verify/report.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/synthetic_claim.hpp"

using gpf::Check;
using gpf::JudgedClaim;
using gpf::ReportData;
using gpf::test::check;
using gpf::test::infinity;

namespace {

namespace fs = std::filesystem;

ReportData data_of(std::vector<JudgedClaim> claims) {
  ReportData data;
  data.claims = std::move(claims);
  data.runs = 12;
  data.collisions = 3000000;
  data.cpu_seconds = 75;
  data.dates = {"2024-05-06", "2024-05-07"};
  data.provenance = {{"version", {"0.1.0"}}, {"commit", {"abc", "def with local changes"}}};
  data.scenes["gas"] = {{"0123"}, 3000000, 75, {data.claims.front().claim.id}};
  return data;
}

/// All files below a folder with their content.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = gpf::read_text(entry.path());
  return files;
}

/// The files of a report on these claims.
std::map<std::string, std::string> report_on(std::vector<JudgedClaim> claims) {
  const gpf::test::TemporaryFolder folder;
  gpf::write_report(data_of(std::move(claims)), folder / "reports");
  return files_in(folder / "reports");
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The text between the heading and the next one.
std::string section(const std::string& page, const std::string& heading) {
  const std::size_t start = page.find("## " + heading + "\n");
  if (start == std::string::npos) return {};
  return page.substr(start, page.find("\n## ", start + 1) - start);
}

gpf::Plot line() {
  gpf::Plot plot{"measured", "x", "y"};
  plot.series = {{"a", gpf::SeriesStyle::line, {0, 1}, {0, 1}}};
  return plot;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(report)

BOOST_AUTO_TEST_CASE(equal_verdicts_give_equal_bytes) {
  const auto claims = [] {
    JudgedClaim with_plot = gpf::test::passing("a.one");
    with_plot.verdict.plot = line();
    return std::vector{with_plot, gpf::test::failing("b.two"), gpf::test::undecided("c.three")};
  };
  const auto first = report_on(claims()), second = report_on(claims());
  std::vector<std::string> names;
  for (const auto& [name, text] : first) names.push_back(name);
  BOOST_TEST(
      names == std::vector<std::string>(
                   {"README.md", "bias-and-scatter.csv", "bias-and-scatter.svg", "checks/a.one.csv", "checks/a.one.svg",
                    "checks/b.two.csv", "checks/b.two.svg", "checks/c.three.csv", "checks/c.three.svg",
                    "claims/a.one.csv", "claims/a.one.md", "claims/a.one.svg", "claims/b.two.md", "claims/c.three.md"}),
      boost::test_tools::per_element());
  BOOST_TEST((first == second));
}

BOOST_AUTO_TEST_CASE(every_plot_has_its_numbers_beside_it) {
  JudgedClaim claim = gpf::test::passing("a.one");
  claim.verdict.plot = line();
  const auto files = report_on({claim});
  BOOST_TEST(files.at("claims/a.one.csv") == "series,style,x,y,error,lower,upper\na,line,0,0,,,\na,line,1,1,,,\n");
  BOOST_TEST(contains(files.at("claims/a.one.md"), "![a.one](a.one.svg)\n\n[Data of this plot](a.one.csv)\n"));
  BOOST_TEST(contains(files.at("claims/a.one.md"), "[Data of this plot](../checks/a.one.csv)\n"));
  BOOST_TEST(contains(files.at("README.md"), "[Data of this plot](bias-and-scatter.csv)\n"));
}

BOOST_AUTO_TEST_CASE(what_is_red_stands_first_then_what_is_open) {
  const auto files = report_on({gpf::test::undecided("a.open"), gpf::test::passing("b.green"),
                                gpf::test::failing("c.red"), gpf::test::failing("d.refuted", "refuted")});
  const std::string& page = files.at("README.md");
  BOOST_TEST(contains(page, "**4 claim(s): 2 as expected, 1 red, 1 inconclusive.**"));
  BOOST_TEST(contains(page, "run on 2024-05-06 to 2024-05-07"));
  const std::string troubles = section(page, "Red or inconclusive");
  BOOST_TEST(contains(troubles, "[c.red](claims/c.red.md): **fail, expected reproduced**"));
  BOOST_TEST(troubles.find("c.red") < troubles.find("a.open"));
  BOOST_TEST(!contains(troubles, "b.green"));
  BOOST_TEST(!contains(troubles, "d.refuted"));
  BOOST_TEST(page.find("## Red or inconclusive") < page.find("## Claims"));
  BOOST_TEST(contains(section(page, "Claims"), "| 4   | [d.refuted](claims/d.refuted.md) "));
  BOOST_TEST(contains(page, "abc; def with local changes"));
  BOOST_TEST(contains(section(page, "Runs, and the claims that they serve"), "[a.open](claims/a.open.md)"));
}

BOOST_AUTO_TEST_CASE(a_report_on_chosen_claims_says_so_and_how_to_repeat_it) {
  gpf::ReportData data = data_of({gpf::test::passing("a.one"), gpf::test::passing("b.two")});
  const gpf::test::TemporaryFolder folder;
  const auto page = [&](std::size_t of_claims) {
    data.of_claims = of_claims;
    gpf::write_report(data, folder.path());
    return files_in(folder.path()).at("README.md");
  };
  BOOST_TEST(contains(page(5), ", 2 of its 5 claims\n"));
  BOOST_TEST(contains(page(5), " a.one b.two\n    gpf report --tier "));
  BOOST_TEST(contains(page(5), " --output FOLDER a.one b.two\n"));
  BOOST_TEST(!contains(page(2), ", 2 of its 2"));
  BOOST_TEST(!contains(page(2), " a.one b.two"));
}

BOOST_AUTO_TEST_CASE(a_report_on_chosen_claims_lists_the_pages_that_earlier_ones_have_left) {
  const JudgedClaim one = gpf::test::passing("a.one"), two = gpf::test::passing("b.two"),
                    three = gpf::test::passing("c.three");
  const gpf::test::TemporaryFolder folder;
  const auto front = [&](const JudgedClaim& chosen, std::vector<gpf::Claim> others) {
    ReportData data = data_of({chosen});
    data.of_claims = 3;
    data.others = std::move(others);
    gpf::write_report(data, folder.path());
    return files_in(folder.path()).at("README.md");
  };
  BOOST_TEST(!contains(front(one, {two.claim, three.claim}), "earlier reports"));
  const std::string earlier = section(front(two, {one.claim, three.claim}), "Pages of earlier reports");
  BOOST_TEST(contains(earlier, "[a.one](claims/a.one.md)"));
  BOOST_TEST(contains(earlier, "pass, as expected (reproduced)"));
  BOOST_TEST(!contains(earlier, "b.two"));    // this report's own
  BOOST_TEST(!contains(earlier, "c.three"));  // has no page
  BOOST_TEST(contains(files_in(folder.path()).at("claims/a.one.md"), "**Verdict: "));

  gpf::write_text_atomically(folder / "claims/c.three.md", "a page of someone else\n**Verdict: pass.**\n");
  BOOST_TEST(!contains(front(two, {one.claim, three.claim}), "c.three"));
}

BOOST_AUTO_TEST_CASE(a_share_has_its_own_level) {
  JudgedClaim mixed = gpf::test::judged("a.mixed", {check("slope", 0.4, 0.01, {0, infinity})});
  mixed.verdict.alpha = 0.005;
  const auto page = [&] { return report_on({mixed}).at("claims/a.mixed.md"); };
  BOOST_TEST(contains(page(), "each end of an interval errs with probability 0.005"));
  BOOST_TEST(!contains(page(), "of a share"));
  mixed.verdict.checks[0].check.share = true;
  BOOST_TEST(contains(page(), "each end of the interval of a share errs with probability 0.025"));
  BOOST_TEST(!contains(page(), "of an interval errs"));
}

BOOST_AUTO_TEST_CASE(drawings_are_shown_below_the_plot_and_go_with_their_claim) {
  JudgedClaim drawn = gpf::test::passing("a.one");
  drawn.verdict.drawings = {{"t = 4", "<svg>4</svg>"}, {"t = 50", "<svg>50</svg>"}};
  const gpf::test::TemporaryFolder folder;
  gpf::write_report(data_of({drawn}), folder.path());
  auto files = files_in(folder.path());
  BOOST_TEST(files.at("claims/a.one+2.svg") == "<svg>50</svg>");
  BOOST_TEST(contains(files.at("claims/a.one.md"), "## Snapshots\n\nt = 4:\n\n![t = 4](a.one+1.svg)\n"));
  drawn.verdict.drawings.pop_back();
  gpf::write_report(data_of({drawn}), folder.path());
  files = files_in(folder.path());
  BOOST_TEST(files.contains("claims/a.one+1.svg"));
  BOOST_TEST(!files.contains("claims/a.one+2.svg"));
}

BOOST_AUTO_TEST_CASE(limits_stand_together_by_method) {
  JudgedClaim hydro = gpf::test::passing("limits.hydrodynamics.knudsen");
  hydro.verdict.plot = line();
  const auto files = report_on({gpf::test::passing("a.one"), hydro, gpf::test::failing("limits.tc")});
  BOOST_TEST(contains(section(files.at("README.md"), "Where methods fail"), "[2 claim(s)](limits.md)"));
  const std::string& page = files.at("limits.md");
  BOOST_TEST(contains(section(page, "Channel hydrodynamics"), "(claims/limits.hydrodynamics.knudsen.svg)"));
  BOOST_TEST(contains(section(page, "The engine, its models, and the advice"), "[limits.tc](claims/limits.tc.md)"));
  BOOST_TEST(!contains(page, "limits.tc.svg"));
  BOOST_TEST(!contains(page, "stress.jr.limit"));
  BOOST_TEST(!report_on({gpf::test::passing("a.one")}).contains("limits.md"));
}

BOOST_AUTO_TEST_CASE(nothing_red_is_said_so) {
  const auto files = report_on({gpf::test::passing("a.one")});
  BOOST_TEST(section(files.at("README.md"), "Red or inconclusive") == "## Red or inconclusive\n\nNone.\n");
}

BOOST_AUTO_TEST_CASE(a_refuted_claim_shows_its_evidence) {
  const auto files = report_on({gpf::test::failing("a.refuted", "refuted"), gpf::test::failing("b.red")});
  const std::string& page = files.at("claims/a.refuted.md");
  BOOST_TEST(contains(page, "**Verdict: fail, as expected (refuted).**"));
  BOOST_TEST(contains(page, "**Why refuted:** theory of first order, ref. 12\n"));
  BOOST_TEST(contains(section(files.at("README.md"), "Expected to be refuted or unresolved"), "a.refuted"));
  BOOST_TEST(contains(files.at("claims/b.red.md"), "**Verdict: fail, expected reproduced.**"));
  BOOST_TEST(!contains(files.at("claims/b.red.md"), "**Why"));
}

BOOST_AUTO_TEST_CASE(texts_cannot_act) {
  JudgedClaim hostile = gpf::test::judged("a.one", {check("a|b <b>*c*</b>", 0.2, 0.1, {-1, 1})});
  hostile.claim.title = "<img src=x> `t`\n# heading";
  hostile.claim.statement = "x | y [link](http://e) | z";
  hostile.verdict.notes = {"- item\n\n## A section", "<details>"};
  hostile.verdict.health = {{"<i>kind", false, "| cell"}};
  const auto files = report_on({hostile});
  for (const char* name : {"README.md", "claims/a.one.md"}) {
    const std::string& page = files.at(name);
    BOOST_TEST_CONTEXT(name)
    for (const char* acting : {"<img", "<b>", "*c*", "\n# heading", "[link](", "\n## A section", "<details>", "<i>"})
      BOOST_TEST(!contains(page, acting), acting << " acts");
  }
  BOOST_TEST(contains(files.at("README.md"), "| x \\| y [link\\](http://e) \\| z |"));
  BOOST_TEST(contains(files.at("claims/a.one.md"), "| a\\|b &lt;b>\\*c\\*&lt;/b> |"));
  BOOST_TEST(contains(files.at("claims/a.one.md"), "- \\- item  ## A section\n"));
}

BOOST_AUTO_TEST_CASE(the_budget_adds_up_and_a_wide_band_is_noted_once) {
  // 0.001 +- 0.0045 (4.54 standard errors) of a band of half width 1: 0.6 % used.
  const auto files =
      report_on({gpf::test::judged("a.wide", {check("value", 0.001, 0.001, {-1, 1})}), gpf::test::passing("b.fair")});
  const std::string& wide = files.at("claims/a.wide.md");
  const std::string budget = section(wide, "Tolerance budget");
  BOOST_TEST(contains(budget, "| **total** | 0.03 "));
  BOOST_TEST(contains(budget, "**Ratchet:** Tolerance too wide"));
  BOOST_TEST(wide.find("Tolerance too wide") == wide.rfind("Tolerance too wide"));
  BOOST_TEST(!contains(files.at("claims/b.fair.md"), "Ratchet"));
}

BOOST_AUTO_TEST_CASE(failed_health_checks_come_first_and_passed_ones_by_kind) {
  JudgedClaim claim = gpf::test::passing("a.one");
  claim.verdict.health = {{"steady: scene a", true, "z 1"},
                          {"overlap", true, "1e-15 d"},
                          {"steady: scene b", true, "z 2"},
                          {"energy", false, "imbalance 0.1"}};
  const std::string page = report_on({claim}).at("claims/a.one.md");
  BOOST_TEST(section(page, "Health checks") ==
             "## Health checks\n\n- **failed:** energy: imbalance 0.1\n- passed: steady, 2 times\n"
             "- passed: overlap: 1e-15 d\n");
}

BOOST_AUTO_TEST_CASE(the_command_repeats_tier_and_seed) {
  JudgedClaim claim = gpf::test::passing("a.one");
  BOOST_TEST(contains(report_on({claim}).at("claims/a.one.md"), "\n    gpf validate --tier quick a.one\n"));
  claim.verdict.tier = gpf::Tier::standard;
  claim.verdict.release_seed = 7;
  BOOST_TEST(contains(report_on({claim}).at("claims/a.one.md"),
                      "\n    gpf validate --tier standard --release-seed 7 a.one\n"));
}

BOOST_AUTO_TEST_CASE(long_tables_are_folded_below_the_tightest_rows) {
  std::vector<Check> checks;
  for (int k = 0; k < 30; ++k) checks.push_back(check("bin " + std::to_string(k), 0.02 * k, 0.01, {-1, 1}));
  const std::string page = report_on({gpf::test::judged("a.one", checks)}).at("claims/a.one.md");
  const std::size_t fold = page.find("<details>\n<summary>All 30 checks</summary>");
  BOOST_REQUIRE(fold != std::string::npos);
  BOOST_TEST(page.substr(0, fold).find("bin 29 ") != std::string::npos);  // the tightest
  BOOST_TEST(page.substr(0, fold).find("| bin 3 ") == std::string::npos);
  BOOST_TEST(page.substr(fold).find("| bin 3 ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(claims_without_two_edges_or_plot_have_pages_all_the_same) {
  JudgedClaim one_sided = gpf::test::judged("a.sign", {check("slope", 0.4, 0.01, {0, infinity})});
  JudgedClaim nothing = gpf::test::judged("b.nothing", {});
  nothing.verdict.plot = line();
  nothing.verdict.plot.series.front().y = {std::nan(""), std::nan("")};
  const auto files = report_on({one_sided, nothing});
  BOOST_TEST(contains(files.at("checks/a.sign.svg"), "</svg>"));
  BOOST_TEST(!files.contains("checks/b.nothing.svg"));
  BOOST_TEST(!files.contains("claims/b.nothing.svg"));
  BOOST_TEST(!contains(files.at("claims/b.nothing.md"), "!["));
  BOOST_TEST(!files.contains("bias-and-scatter.svg"));
  BOOST_TEST(!contains(files.at("README.md"), "bias-and-scatter"));
}

BOOST_AUTO_TEST_CASE(pages_of_claims_that_are_gone_are_removed_and_nothing_else) {
  const gpf::test::TemporaryFolder folder;
  gpf::write_report(data_of({gpf::test::passing("a.one"), gpf::test::passing("b.gone")}), folder.path());
  gpf::write_text_atomically(folder / "claims/README.md", "not ours\n");
  gpf::write_report(data_of({gpf::test::passing("a.one")}), folder.path());
  const auto files = files_in(folder.path());
  BOOST_TEST(files.contains("claims/a.one.md"));
  BOOST_TEST(files.contains("claims/README.md"));
  for (const auto& [name, text] : files) BOOST_TEST(!contains(name, "b.gone"));
}

BOOST_AUTO_TEST_CASE(without_verdicts_nothing_is_written) {
  const gpf::test::TemporaryFolder folder;
  fs::create_directories(folder / "reference/claims");
  gpf::write_text_atomically(folder / "reference/claims/a.one.toml", gpf::test::synthetic_claim_text("a.one"));
  const gpf::ReportOptions options{gpf::Tier::quick, folder / "records", folder / "reference", folder / "reports"};
  BOOST_CHECK_THROW(gpf::write_report(options), gpf::InputError);
  BOOST_TEST(!fs::exists(folder / "reports"));
}

BOOST_AUTO_TEST_SUITE_END()
