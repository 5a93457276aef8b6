#include "verify/explain.hpp"

#include <boost/test/unit_test.hpp>

#include "unit/verify/claim_text.hpp"
#include "verify/command_text.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(explain_a_claim)

BOOST_AUTO_TEST_CASE(everything_that_a_reviewer_asks_for_is_there) {
  const std::string text = explain(parse_claim(test::claim_text, "eos.example.toml"));
  for (const std::string expected :
       {"eos.example - Pressure\n", "chapter 2, fig. 2.8", "Z is Luding's",
        "Z from the virial, corrected to infinite N.", "zero-crossing", "refuted: the equation is 2 % off there",
        "table 1", "measured with 4 N", "highest_area_fraction = 0.4",
        "periodic-nu10, periodic-nu30; looks at 4 replica(s)", "looks at 4, 8, 16 replica(s)",
        "restitution applied twice", "g off by 2 %", "gpf validate eos.example"})
    BOOST_TEST(text.find(expected) != std::string::npos, "missing: " << expected);
  // The budget adds up where a reader sees it.
  BOOST_TEST(text.find("  reference       0.002  table 1\n"
                       "  finite N        0.001  measured with 4 N\n"
                       "  total           0.003\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(long_texts_are_broken_at_spaces_and_nothing_is_lost) {
  Claim claim = parse_claim(test::claim_text, "eos.example.toml");
  claim.method.clear();
  for (int k = 0; k < 60; ++k) claim.method += (k > 0 ? " word" : "word") + std::to_string(k);
  const std::string text = explain(claim);
  for (int k = 0; k < 60; ++k) BOOST_TEST(text.find("word" + std::to_string(k)) != std::string::npos);
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    BOOST_TEST(end - begin <= 100U);
}

BOOST_AUTO_TEST_CASE(it_is_reproduced_where_it_lies) {
  const Claim claim = parse_claim(test::claim_text, "eos.example.toml");
  for (const char* suite : {"reference", "/usr/share/gpf/reference", "here/reference/"})
    BOOST_TEST(explain(claim, suite).ends_with("reproduce     gpf validate eos.example\n"), suite);
  BOOST_TEST(explain(claim, "mine").ends_with("gpf validate --reference mine eos.example\n"));
  BOOST_TEST(
      explain(claim, "it's mine; rm x").ends_with("gpf validate --reference 'it'\\''s mine; rm x' eos.example\n"));
  BOOST_TEST(folder_options("mine", "a/records") == " --reference mine");
  BOOST_TEST(folder_options("reference", "there") == " --store there");
}

BOOST_AUTO_TEST_CASE(it_is_reproduced_in_the_first_tier_that_judges_it) {
  Claim claim = parse_claim(test::claim_text, "eos.example.toml");
  claim.scenes = {{Tier::standard, {"periodic-nu10"}}};
  BOOST_TEST(explain(claim).ends_with("gpf validate --tier standard eos.example\n"));
}

BOOST_AUTO_TEST_CASE(a_claim_without_runs_and_tolerance_says_so) {
  Claim claim = parse_claim(test::claim_text, "eos.example.toml");
  claim.scenes.clear();
  claim.tolerance.clear();
  const std::string text = explain(claim);
  BOOST_TEST(text.find("runs          none") != std::string::npos);
  BOOST_TEST(text.find("tolerance     none") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
