#include "verify/report_pictures.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "unit/verify/synthetic_claim.hpp"

using gpf::Check;
using gpf::Series;
using gpf::test::check;
using gpf::test::infinity;

namespace {

const Series& series(const gpf::Picture& picture, const std::string& label) {
  const auto& all = picture.plot.series;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Series& s) { return s.label == label; });
  BOOST_REQUIRE(found != all.end());
  return *found;
}

gpf::Picture picture_of(std::vector<Check> checks) {
  const auto picture = gpf::checks_picture(gpf::test::judged("a", std::move(checks)).verdict);
  BOOST_REQUIRE(picture.has_value());
  return *picture;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(report_pictures)

BOOST_AUTO_TEST_CASE(checks_keep_their_number_and_are_told_apart_by_outcome) {
  const gpf::Picture picture = picture_of({check("in", 10.5, 0.01, {9, 11}), check("one-sided", 1, 0.01, {0, infinity}),
                                           check("far out", 20, 0.01, {9, 11}), check("in", 9.5, 0.01, {9, 11})});
  const Series &pass = series(picture, "pass"), &fail = series(picture, "fail");
  BOOST_TEST(pass.x == std::vector<double>({1, 4}), boost::test_tools::per_element());
  BOOST_TEST(pass.y[0] == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(pass.y[1] == -0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(fail.x == std::vector<double>({3}), boost::test_tools::per_element());
  BOOST_TEST(fail.y[0] == 3);  // 10 half widths from the centre, drawn at the edge
  BOOST_TEST(contains(picture.caption, "1 value(s) beyond +-3 are drawn at that edge."));
  BOOST_TEST(contains(picture.caption, "1 check(s) without two edges are not shown."));
}

BOOST_AUTO_TEST_CASE(an_unbounded_interval_ends_at_the_edge) {
  gpf::JudgedClaim one = gpf::test::judged("a", {Check{"a", {0.5}, {-1, 1}, false, 0, 0}});  // one replica: no error
  const auto picture = gpf::checks_picture(one.verdict);
  BOOST_REQUIRE(picture.has_value());
  const Series& intervals = series(*picture, "confidence interval");
  BOOST_TEST(intervals.y[0] == -3);
  BOOST_TEST(intervals.y[1] == 3);
  BOOST_TEST(series(*picture, "inconclusive").y[0] == 0.5);
}

BOOST_AUTO_TEST_CASE(bounds_are_drawn_where_no_check_has_two_edges) {
  const gpf::Picture picture =
      picture_of({check("a", 0.4, 0.1, {-infinity, 1}), Check{"identity", {1}, {0, infinity}, true, 0, 0}});
  const Series& open = series(picture, "pass");
  BOOST_TEST(open.x == std::vector<double>({1}), boost::test_tools::per_element());
  BOOST_TEST(open.y[0] == 6, boost::test_tools::tolerance(1e-12));  // 0.6 below the bound at a standard error of 0.1
  BOOST_TEST(contains(picture.plot.ylabel, "standard error"));
  BOOST_TEST(contains(picture.caption, "1 check(s) without a bound or an error are not shown."));
}

BOOST_AUTO_TEST_CASE(of_many_checks_the_tightest_are_drawn) {
  std::vector<Check> checks;
  for (int k = 0; k < 60; ++k) checks.push_back(check("bin", 0.01 * k, 0.01, {-1, 1}));  // ever nearer to the edge
  const gpf::Picture picture = picture_of(checks);
  const Series& pass = series(picture, "pass");
  BOOST_REQUIRE(pass.x.size() == 40u);
  BOOST_TEST(pass.x.front() == 21);
  BOOST_TEST(pass.x.back() == 60);
  BOOST_TEST(contains(picture.caption, "20 check(s) with more room are not shown."));
}

BOOST_AUTO_TEST_CASE(all_claims_stand_in_their_columns) {
  const auto picture = gpf::bias_and_scatter(
      {gpf::test::passing("a.one"), gpf::test::judged("b.sign", {check("slope", 1, 0.1, {0, infinity})}),
       gpf::test::judged("c.two", {check("low", -0.5, 0.01, {-1, 1}), check("high", 0.5, 0.01, {-1, 1})})});
  BOOST_REQUIRE(picture.has_value());
  BOOST_TEST(series(*picture, "1 a.one").x == std::vector<double>({1}), boost::test_tools::per_element());
  const Series& two = series(*picture, "3 c.two");
  BOOST_REQUIRE(two.x.size() == 2u);
  BOOST_TEST(two.x[0] > 2.5);
  BOOST_TEST(two.x[0] < two.x[1]);
  BOOST_TEST(two.x[1] < 3.5);
  BOOST_TEST(two.y[0] == -0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(contains(picture->caption, "are left out: 2 b.sign."));
}

BOOST_AUTO_TEST_SUITE_END()
