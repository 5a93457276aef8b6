#include "verify/claim.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <string>

#include "gpf/base/error.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/claim_text.hpp"

using namespace gpf;
using gpf::test::claim_text;
using gpf::test::replaced;

BOOST_AUTO_TEST_SUITE(claim)

BOOST_AUTO_TEST_CASE(a_complete_file_is_read) {
  const Claim c = parse_claim(claim_text, "claims/eos.example.toml");
  BOOST_TEST(c.id == "eos.example");
  BOOST_TEST(c.chapter == 2);
  BOOST_TEST(c.method == "Z from the virial, corrected to infinite N.");  // one line
  BOOST_CHECK(c.kind == Kind::zero_crossing);
  BOOST_CHECK(c.expected == Expectation::refuted);
  BOOST_TEST(c.expected_because == "the equation is 2 % off there");
  BOOST_TEST(c.estimator == "eos_example");
  BOOST_TEST(c.catches == (std::vector<std::string>{"restitution applied twice", "g off by 2 %"}),
             boost::test_tools::per_element());
  BOOST_TEST(c.transient);
  BOOST_TEST(c.tolerance.size() == 2U);
  BOOST_TEST(c.tolerance_total() == 0.003);
  BOOST_TEST(c.tolerance[1].evidence == "measured with 4 N");
  BOOST_TEST(c.tolerance_unit == "relative");
  BOOST_TEST(c.parameter("highest_area_fraction") == 0.4);
  BOOST_TEST(c.parameter("whole") == 3);
  BOOST_CHECK_THROW(static_cast<void>(c.parameter("other")), InputError);
}

BOOST_AUTO_TEST_CASE(checks_belong_to_one_estimator_and_say_what_is_wanted) {
  const std::string spelled = replaced(claim_text, "estimator = \"eos_example\"", "estimator = \"quantities\"");
  const auto with = [&](const std::string& check) {
    return parse_claim(spelled + "\n[[check]]\n" + check, "eos.example.toml").checks.at(0);
  };
  BOOST_TEST(with("value = \"mean_flow\"\nreference = 2").reference.value() == 2);
  BOOST_TEST(with("value = \"mean_flow\"\nreference = 2").label == "mean_flow");
  const ClaimCheck bounds = with("label = \"flow\"\nvalue = \"mean_flow / centre_velocity\"\nleast = -1\nmost = 3.5");
  BOOST_TEST(bounds.label == "flow");
  BOOST_TEST(bounds.least.value() == -1);
  BOOST_TEST(bounds.most.value() == 3.5);
  for (const char* wrong :
       {"value = \"mean_flow\"", "value = \"mean_flow\"\nreference = 2\nleast = 1", "value = \"mean flow\"\nleast = 1",
        "value = \"mean_flow\"\nleast = 2\nmost = 1", "least = 1", "value = \"mean_flow\"\nleast = 1\nextra = 1"})
    BOOST_CHECK_THROW(with(wrong), InputError);
  BOOST_CHECK_THROW(parse_claim(spelled, "eos.example.toml"), InputError);
  BOOST_CHECK_THROW(parse_claim(claim_text + "\n[[check]]\nvalue = \"mean_flow\"\nleast = 1", "eos.example.toml"),
                    InputError);
}

BOOST_AUTO_TEST_CASE(any_change_of_the_text_changes_its_hash) {
  const std::string other = replaced(claim_text, "measured with 4 N", "measured with 8 N");
  BOOST_TEST(parse_claim(claim_text, "eos.example.toml").text_hash ==
             parse_claim(claim_text, "eos.example.toml").text_hash);
  BOOST_TEST(parse_claim(claim_text, "eos.example.toml").text_hash != parse_claim(other, "eos.example.toml").text_hash);
}

BOOST_AUTO_TEST_CASE(a_tier_falls_back_on_the_one_below) {
  const std::vector<std::string> two{"periodic-nu10", "periodic-nu30"}, one{"channel"};
  Claim c = parse_claim(claim_text, "eos.example.toml");  // quick: two scenes, full: one; replicas quick 4, standard 16
  BOOST_TEST(c.scenes_in(Tier::quick) == two, boost::test_tools::per_element());
  BOOST_TEST(c.scenes_in(Tier::standard) == two, boost::test_tools::per_element());
  BOOST_TEST(c.scenes_in(Tier::full) == one, boost::test_tools::per_element());
  BOOST_TEST(c.replicas_in(Tier::quick) == 4);
  BOOST_TEST(c.replicas_in(Tier::standard) == 16);
  BOOST_TEST(c.replicas_in(Tier::full) == 16);
  c.scenes.erase(Tier::quick);
  BOOST_TEST(!c.judged_in(Tier::quick));
  BOOST_TEST(!c.judged_in(Tier::standard));
  BOOST_TEST(c.judged_in(Tier::full));
}

BOOST_AUTO_TEST_CASE(a_claim_without_runs_is_judged_in_every_tier_with_one_replica) {
  std::string text = replaced(claim_text, test::scenes_and_replicas, "");
  text = replaced(text, test::tolerances, "");
  const Claim c = parse_claim(replaced(text, "tolerance_unit = \"relative\"\n", ""), "eos.example.toml");
  BOOST_TEST(c.judged_in(Tier::quick));
  BOOST_TEST(c.scenes_in(Tier::full).empty());
  BOOST_TEST(c.replicas_in(Tier::standard) == 1);
  BOOST_TEST(c.tolerance_total() == 0.0);
}

struct Mistake {
  std::string from, to;  // in claim_text
  std::string message;   // part of what()
};

const std::vector<Mistake> mistakes{
    {"id = \"eos.example\"\n", "", "claims/eos.example.toml:1:1: id is missing"},
    {"id = \"eos.example\"", "id = \"eos.other\"", ":1:1: id 'eos.other' is not the name of the file"},
    {"id = \"eos.example\"", "id = \"../eos\"", ":1:1: id '../eos' cannot be used"},
    {"id = \"eos.example\"", "id = \"eos..example\"", "cannot be used"},
    {"id = \"eos.example\"", "id = \"eos.\"", "cannot be used"},
    {"id = \"eos.example\"", "id = 3", "id is an integer (it must be a string)"},
    {"title = ", "tilte = ", ":2:1: unknown key 'tilte'"},
    {"title = ", "tilte = ", "did you mean 'title'?"},
    {"title = \"Pressure\"", "title = \" \"", "title is empty"},
    {"chapter = 2", "chapter = \"2\"", "chapter is a string (it must be an integer)"},
    {"chapter = 2", "chapter = 0", "chapter = 0"},
    {"source = \"fig. 2.8\"\n", "", "source is missing"},
    {"statement = \"Z is Luding's\"\n", "", "statement is missing"},
    {"kind = \"zero-crossing\"", "kind = \"zero crossing\"", ":9:1: unknown kind 'zero crossing'"},
    {"expected = \"refuted\"", "expected = \"rejected\"", "unknown expectation 'rejected'"},
    {"expected = \"refuted\"", "expected = \"reproduced\"", "expected_because is given"},
    {"expected_because = \"the equation is 2 % off there\"\n", "", "expected = \"refuted\" without expected_because"},
    {"estimator = \"eos_example\"\n", "", "estimator is missing"},
    {"transient = true", "transient = 1", "transient is an integer (it must be true or false)"},
    {"tolerance_unit = \"relative\"\n", "", "[[tolerance]] without tolerance_unit"},
    {"catches = [\"restitution applied twice\", \"g off by 2 %\"]\n", "", "catches is missing"},
    {"catches = [\"restitution applied twice\", \"g off by 2 %\"]", "catches = []", "catches is empty"},
    {"catches = [\"restitution applied twice\", \"g off by 2 %\"]", "catches = \"all\"",
     "catches is a string (it must be an array of strings)"},
    {"\"g off by 2 %\"", "2", "catches holds an integer"},
    {"\"g off by 2 %\"", "\"\"", "catches holds an empty string"},
    {"\"g off by 2 %\"", "\"restitution applied twice\"", "catches holds 'restitution applied twice' twice"},
    {"[scenes]\n", "[scene]\n", "did you mean 'scenes'?"},
    {"quick = [\"periodic-nu10\", \"periodic-nu30\"]", "fast = [\"periodic-nu10\"]", "unknown key 'fast' in [scenes]"},
    {"quick = [\"periodic-nu10\", \"periodic-nu30\"]", "quick = [\"a/b\"]", "scene 'a/b' cannot be used"},
    {"quick = [\"periodic-nu10\", \"periodic-nu30\"]\nfull = [\"channel\"]\n", "", "[scenes] is empty"},
    {"quick = 4\n", "quick = 5\n", "quick = 5 replicas (the judge looks at 1, 4, 8, 16, 32)"},
    {"quick = 4\n", "quick = \"many\"\n", "quick is a string (it must be an integer)"},
    {"quick = 4\n", "", "[replicas] has no entry for quick or below"},
    {"[replicas]\nquick = 4\nstandard = 16\n", "", "replicas is missing"},
    {"[scenes]\nquick = [\"periodic-nu10\", \"periodic-nu30\"]\nfull = [\"channel\"]\n", "",
     "[replicas] without [scenes]"},
    {"value = 0.001", "value = -0.001", "tolerance 'finite N' = -0.001 is negative"},
    {"value = 0.001", "value = inf", "value = inf is not a finite number"},
    {"value = 0.001", "value = \"small\"", "value is a string (it must be a number)"},
    {"evidence = \"measured with 4 N\"\n", "", "evidence is missing in [[tolerance]]"},
    {"evidence = \"measured with 4 N\"", "evidence = \"\"", "evidence is empty"},
    {"name = \"finite N\"", "name = \"reference\"", "tolerance 'reference' is given twice"},
    {"name = \"finite N\"", "label = \"finite N\"", "unknown key 'label' in [[tolerance]]"},
    {test::tolerances, "", "tolerance_unit without [[tolerance]]"},
    {"whole = 3", "whole = true", "whole is true or false (it must be a number)"},
    {"whole = 3", "whole = nan", "whole = nan is not a finite number"},
    {"chapter = 2", "chapter = [(", "this is not TOML"},
};

void is_refused(const std::string& text, const std::string& message) {
  BOOST_CHECK_EXCEPTION(parse_claim(text, "claims/eos.example.toml"), InputError, [&](const InputError& error) {
    const std::string what = error.what();
    BOOST_TEST(what.starts_with("claims/eos.example.toml:"), what);
    BOOST_TEST(what.find(message) != std::string::npos, what << " does not say: " << message);
    return true;
  });
}

BOOST_AUTO_TEST_CASE(a_mistake_is_an_error_with_its_place) {
  for (const Mistake& mistake : mistakes) is_refused(replaced(claim_text, mistake.from, mistake.to), mistake.message);
}

BOOST_AUTO_TEST_CASE(tables_must_be_tables) {
  const std::string plain = replaced(replaced(claim_text, test::tolerances, ""), "tolerance_unit = \"relative\"\n", "");
  is_refused("tolerance = [1]\n" + plain, "tolerance holds an integer");
  is_refused("tolerance = 0.1\n" + plain, "tolerance is a real number (it must be an array of tables)");
  is_refused("parameters = 3\n" + plain.substr(0, plain.find("[parameters]")),
             "parameters is an integer (it must be a table)");
  is_refused("replicas = 4\n" + replaced(plain, test::scenes_and_replicas, ""), "[replicas] without [scenes]");
}

BOOST_AUTO_TEST_CASE(a_folder_of_claims_is_read_in_order_of_their_ids) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "eos.example.toml") << claim_text;
  std::ofstream(folder / "algo.first.toml") << replaced(claim_text, "eos.example", "algo.first");
  std::ofstream(folder / "README.md") << "not a claim";
  const std::vector<Claim> claims = load_claims(folder.path());
  BOOST_REQUIRE(claims.size() == 2U);
  BOOST_TEST(claims[0].id == "algo.first");
  BOOST_TEST(claims[1].id == "eos.example");
}

BOOST_AUTO_TEST_CASE(a_missing_or_empty_folder_is_an_error) {
  const test::TemporaryFolder folder;
  BOOST_CHECK_THROW(load_claims(folder.path()), InputError);
  BOOST_CHECK_THROW(load_claims(folder / "nowhere"), StorageError);
  BOOST_CHECK_THROW(load_claim(folder / "none.toml"), StorageError);
}

BOOST_AUTO_TEST_CASE(names_lead_back_to_their_values) {
  for (const Tier tier : {Tier::quick, Tier::standard, Tier::full}) BOOST_CHECK(tier_named(name_of(tier)) == tier);
  for (int k = 0; k <= static_cast<int>(Kind::shape); ++k)
    BOOST_CHECK(kind_named(name_of(static_cast<Kind>(k))) == static_cast<Kind>(k));
  for (const Expectation e : {Expectation::reproduced, Expectation::refuted, Expectation::unresolved})
    BOOST_CHECK(expectation_named(name_of(e)) == e);
  BOOST_CHECK_THROW(tier_named("fast"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
