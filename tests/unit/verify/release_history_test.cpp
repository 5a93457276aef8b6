// What each release found, kept as text.
#include "verify/release_history.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"

using namespace gpf;

namespace {

JudgedCheck judged(const std::string& label, std::vector<double> values, Interval band, Interval interval) {
  JudgedCheck c;
  c.check.label = label;
  c.check.values = std::move(values);
  c.check.band = band;
  c.summary = summarise(c.check.values);
  c.interval = interval;
  c.outcome = Outcome::pass;
  return c;
}

/// Two checks, of which the second is the tighter one, or the first.
Verdict verdict(double first, bool second_decides = true) {
  Verdict v;
  v.claim_id = "eos.virial";
  v.outcome = Outcome::pass;
  v.green = true;
  v.replicas = 2;
  v.physics_version = 7;
  v.checks.push_back(judged("Z, at nu 0.20", {first, first + 0.2}, {0, second_decides ? 10.0 : first + 0.3},
                            {first - 0.1, first + 0.3}));
  v.checks.push_back(judged("Z at nu 0.30", {5, 5.5}, {4, second_decides ? 6.0 : 60.0}, {4.5, 5.9}));
  return v;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(release_history)

BOOST_AUTO_TEST_CASE(releases_follow_the_check_that_was_kept_first) {
  const test::TemporaryFolder folder;
  const Verdict old = verdict(2), now = verdict(3, false);
  write_release({&old}, "0.9.0", folder.path());
  write_release({&now}, "0.10.0", folder.path());
  const auto entries = load_release_history(folder.path()).at("eos.virial");
  BOOST_REQUIRE(entries.size() == 2U);
  BOOST_TEST(entries[0].release == "0.9.0");  // by number, not by letter
  BOOST_TEST(entries[1].release == "0.10.0");
  BOOST_TEST(entries[0].check == "Z at nu 0.30");
  BOOST_TEST(entries[1].check == "Z at nu 0.30");
  BOOST_TEST(entries[1].value == 5.25);
  BOOST_TEST(entries[1].error == 0.25);
  BOOST_TEST(entries[1].physics_version == 7);
  BOOST_TEST(history_table(entries).find("5.25 ± 0.25") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_release_that_is_written_again_takes_the_place_of_the_old_one) {
  const test::TemporaryFolder folder;
  const Verdict old = verdict(2), now = verdict(3, false);
  write_release({&old}, "0.9.0", folder.path());
  write_release({&now}, "0.9.0", folder.path());
  const auto entries = load_release_history(folder.path()).at("eos.virial");
  BOOST_REQUIRE(entries.size() == 1U);
  BOOST_TEST(entries[0].check == "Z, at nu 0.20");  // a comma in the label is part of it
  BOOST_TEST(entries[0].value == 3.1);
}

BOOST_AUTO_TEST_CASE(without_releases_there_is_nothing) {
  const test::TemporaryFolder folder;
  BOOST_TEST(load_release_history(folder / "none").empty());
  BOOST_TEST(history_table({}).empty());
}

BOOST_AUTO_TEST_CASE(a_damaged_line_is_refused) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "0.1.0.csv") << "claim,...\neos.virial,pass,yes,four\n";
  BOOST_CHECK_EXCEPTION(load_release_history(folder.path()), InputError, [](const InputError& error) {
    return std::string(error.what()).find("eos.virial,pass,yes,four") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
