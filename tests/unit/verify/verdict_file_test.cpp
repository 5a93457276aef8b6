#include "verify/verdict_file.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"

using namespace gpf;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

/// A verdict that uses every member and every kind of number.
Verdict full_verdict() {
  Claim claim;
  claim.id = "eos.example";
  claim.expected = Expectation::refuted;
  claim.text_hash = 0xfedcba9876543210U;
  Evidence evidence;
  evidence.checks = {{"Z at nu 0.30", {1.0 / 3, 0.1, 2, 5e-324}, {-infinity, 1}, false, 0.3, nan_value},
                     {"energy \"drift\"", {1e-15}, {-1, 1}, true, 0, 0},
                     {"not measured", {nan_value, 1, 2, 3}, {0, infinity}, false, 0, 1},
                     {"is a plug", {1, 1, 0, 1}, majority, false, 0, nan_value, true}};
  evidence.health = {{"steady", true, "z = 1"}, {"replicas differ", false, "two alike", 0.0027}};
  evidence.plot = {"Z(nu)", "nu", "Z", false, true, std::pair{0.0, 1.0}, std::nullopt, {}};
  evidence.plot.series.push_back({"measured", SeriesStyle::points, {1, 2}, {3, nan_value}, {0.1, 0.2}, {}, {}});
  evidence.plot.series.push_back({"band", SeriesStyle::band, {1, 2}, {}, {}, {1, 2}, {3, 4}});
  evidence.drawings = {{"t = 4", "<svg title=\"\"/>"}};
  evidence.notes = {"first", "second, with \xc3\xa9"};
  Verdict v = judge(claim, Tier::standard, evidence, 4, 2, 3);
  v.cpu_seconds = 12.5;
  v.records = {"0123456789abcdef"};
  v.program_hash = 17;
  v.release_seed = 0xffffffffffffffffU;
  return v;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(verdict_file)

BOOST_AUTO_TEST_CASE(what_is_written_is_read_back) {
  const Verdict v = full_verdict(), r = parse_verdict(verdict_text(v), "text");
  BOOST_TEST(verdict_text(r) == verdict_text(v));
  BOOST_TEST(r.claim_id == v.claim_id);
  BOOST_CHECK(r.tier == Tier::standard);
  BOOST_CHECK(r.outcome == v.outcome);
  BOOST_CHECK(r.expected == Expectation::refuted);
  BOOST_TEST(r.look == 2);
  BOOST_TEST(r.alpha == v.alpha);
  BOOST_TEST(r.claim_hash == v.claim_hash);
  BOOST_TEST(r.release_seed == v.release_seed);
  BOOST_TEST(r.physics_version == physics_version);
  BOOST_REQUIRE(r.checks.size() == 4U);
  BOOST_TEST(r.checks[0].check.values == v.checks[0].check.values, boost::test_tools::per_element());
  BOOST_TEST(r.checks[0].check.band.lo == -infinity);
  BOOST_TEST(std::isnan(r.checks[0].check.reference));
  BOOST_TEST(r.checks[0].summary.count == 4U);
  BOOST_TEST(r.checks[0].summary.deviation == v.checks[0].summary.deviation);
  BOOST_TEST(r.checks[1].check.exact);
  BOOST_TEST(std::isnan(r.checks[2].check.values[0]));
  BOOST_TEST(!r.checks[2].check.share);
  BOOST_TEST(r.checks[3].check.share);
  BOOST_TEST(r.checks[3].interval.hi == v.checks[3].interval.hi);
  BOOST_TEST(r.health.size() == 2U);
  BOOST_TEST(!r.health[1].passed);
  BOOST_TEST(r.notes == v.notes, boost::test_tools::per_element());
  BOOST_REQUIRE(r.drawings.size() == 1U);
  BOOST_TEST(r.drawings[0].title == "t = 4");
  BOOST_TEST(r.drawings[0].svg == "<svg title=\"\"/>");
  BOOST_TEST(r.plot.logy);
  BOOST_TEST((r.plot.xrange == std::pair{0.0, 1.0}));
  BOOST_TEST(!r.plot.yrange.has_value());
  BOOST_REQUIRE(r.plot.series.size() == 2U);
  BOOST_CHECK(r.plot.series[1].style == SeriesStyle::band);
  BOOST_TEST(r.plot.series[0].yerr == v.plot.series[0].yerr, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(verdicts_have_their_place_in_the_store) {
  const test::TemporaryFolder folder;
  const Verdict v = full_verdict();
  BOOST_CHECK_THROW(read_verdict(folder.path(), Tier::standard, "eos.example"), StorageError);
  write_verdict(v, folder.path());
  BOOST_TEST(std::filesystem::exists(folder / "verdicts/standard/eos.example.json"));
  BOOST_TEST(read_verdict(folder.path(), Tier::standard, "eos.example").summary == v.summary);
}

BOOST_AUTO_TEST_CASE(a_damaged_verdict_is_an_error_that_names_it) {
  const std::string text = verdict_text(full_verdict());
  const auto spoiled = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    return other.replace(other.find(from), from.size(), to);
  };
  for (const std::string& bad :
       {text.substr(0, text.size() / 2), std::string(), std::string("[]"), spoiled("gpf verdict 1", "gpf verdict 2"),
        spoiled("\"outcome\"", "\"result\""), spoiled("\"refuted\"", "\"rejected\""), spoiled("\"-inf\"", "\"minus\""),
        spoiled("\"points\"", "\"dots\""), spoiled("\"replicas\": 4", "\"replicas\": \"4\"")})
    BOOST_CHECK_EXCEPTION(parse_verdict(bad, "some.json"), InputError, [](const InputError& error) {
      return std::string(error.what()).find("some.json") != std::string::npos;
    });
}

BOOST_AUTO_TEST_SUITE_END()
