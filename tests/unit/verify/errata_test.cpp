#include "verify/errata.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/claim_text.hpp"
#include "unit/verify/synthetic_claim.hpp"
#include "verify/report.hpp"
#include "verify/report_errata.hpp"

using namespace gpf;
using gpf::test::replaced;

namespace {

const std::string errata_text = R"([[erratum]]
id = "eq2.7"
place = "eq. 2.7"
printed = "nu = pi N/4 (L/W) (W/d)^2"
correct = "nu = pi N/[4 (L/W) (W/d)^2]"
evidence = """
area of N disks
over L W"""
claims = ["a.one"]

[[erratum]]
id = "fig5.3"
place = "caption"
printed = "slug"
correct = "plug"
evidence = "the text"
)";

/// What the reader says of a text: problem, reason and remedy.
std::string complaint(const std::string& text) {
  try {
    static_cast<void>(parse_errata(text, "errata.toml"));
  } catch (const InputError& error) {
    return error.problem() + "; " + error.why() + "; " + error.remedy();
  }
  return "none";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(errata)

BOOST_AUTO_TEST_CASE(a_complete_file_is_read_in_its_order) {
  const std::vector<Erratum> read = parse_errata(errata_text, "errata.toml");
  BOOST_REQUIRE(read.size() == 2u);
  BOOST_TEST(read[0].id == "eq2.7");
  BOOST_TEST(read[0].evidence == "area of N disks over L W");
  BOOST_TEST(read[0].claims == std::vector<std::string>{"a.one"}, boost::test_tools::per_element());
  BOOST_TEST(read[1].correct == "plug");
  BOOST_TEST(read[1].claims.empty());
}

BOOST_AUTO_TEST_CASE(whatever_is_wrong_is_said_with_its_line) {
  const auto after = [](const char* from, const char* to) { return complaint(replaced(errata_text, from, to)); };
  BOOST_TEST(complaint(errata_text) == "none");
  BOOST_TEST(contains(after("printed = \"slug\"", "print = \"slug\""), "errata.toml:14:1: unknown key 'print'"));
  BOOST_TEST(contains(after("printed = \"slug\"", "print = \"slug\""), "did you mean 'printed'"));
  BOOST_TEST(contains(after("printed = \"slug\"\n", ""), "printed is missing in [[erratum]]"));
  BOOST_TEST(contains(after("\"slug\"", "\" \""), "printed is empty"));
  BOOST_TEST(contains(after("\"slug\"", "7"), "printed is an integer"));
  BOOST_TEST(contains(after("\"slug\"", "\"plug\""), "correct is the same as printed"));
  BOOST_TEST(contains(after("\"fig5.3\"", "\"eq2.7\""), "errata.toml:12:1: erratum 'eq2.7' is given twice"));
  BOOST_TEST(contains(after("\"fig5.3\"", "\"fig 5.3\""), "id 'fig 5.3' cannot be used"));
  BOOST_TEST(contains(after("\"a.one\"", "\"../a\""), "claim '../a' cannot be used"));
  BOOST_TEST(contains(after("[\"a.one\"]", "[]"), "claims is empty"));
  BOOST_TEST(contains(after("[[erratum]]", "[[errata]]"), "unknown key 'errata'"));
  BOOST_TEST(contains(complaint(""), "no errata"));
  BOOST_TEST(contains(complaint("[[erratum]\n"), "errata.toml:1:"));
}

BOOST_AUTO_TEST_CASE(the_page_links_claims_that_have_one_and_shows_texts_as_they_are) {
  std::vector<Erratum> list = parse_errata(errata_text, "errata.toml");
  list[0].claims.emplace_back("b.two");
  list[1].printed = "<b>*slug*</b>";
  const std::string page = errata_page(list, {"a.one"});
  BOOST_TEST(contains(page, "2 place(s)"));
  BOOST_TEST(contains(page, "- tested by: [a.one](claims/a.one.md), b.two\n"));
  BOOST_TEST(page.find("## eq2.7") < page.find("## fig5.3"));
  BOOST_TEST(!contains(page, "<b>"));
  BOOST_TEST(!contains(page, "*slug*"));
}

BOOST_AUTO_TEST_CASE(the_front_page_links_the_errata_and_a_report_without_them_removes_the_page) {
  const gpf::test::TemporaryFolder folder;
  ReportData data;
  data.claims = {gpf::test::passing("a.one")};
  data.errata = parse_errata(errata_text, "errata.toml");
  write_report(data, folder.path());
  BOOST_TEST(contains(read_text(folder / "README.md"), "[2 place(s)](errata.md)"));
  BOOST_TEST(contains(read_text(folder / "errata.md"), "## fig5.3"));
  data.errata.clear();
  write_report(data, folder.path());
  BOOST_TEST(!contains(read_text(folder / "README.md"), "errata"));
  BOOST_TEST(!std::filesystem::exists(folder / "errata.md"));
}

BOOST_AUTO_TEST_CASE(the_list_of_this_suite_can_be_read_and_its_area_fractions_are_right) {
  std::map<std::string, Erratum> known;
  for (const Erratum& erratum : load_errata(std::filesystem::path(GPF_REFERENCE) / "errata.toml")) {
    for (const std::string& claim : erratum.claims)
      BOOST_TEST(std::filesystem::exists(std::filesystem::path(GPF_REFERENCE) / "claims" / (claim + ".toml")), claim);
    known.emplace(erratum.id, erratum);
  }
  BOOST_TEST(known.size() > 30u);
  struct Count {
    const char* id;
    double particles, width, length, area_fraction;  // as printed, W/d, L/W; nu that this makes
    const char *wanted, *made;                       // N for the printed nu, and nu, in the erratum
    double printed_area_fraction;
  };
  const Count counts[] = {{"fig5.1", 930, 31, 2, 0.380, "N = 759", "0.380", 0.31},
                          {"fig5.4", 3450, 31, 8, 0.352, "N = 3034", "0.352", 0.31},
                          {"fig5.7", 1620, 65, 1, 0.301, "N = 1668", "0.301", 0.31},
                          {"fig5.18", 11140, 70, 50, 0.036, "N = 15597", "0.036", 0.05}};
  for (const Count& c : counts) {
    const double disks_for_one = 4 * c.length * c.width * c.width / std::numbers::pi;
    BOOST_TEST(std::abs(c.particles / disks_for_one - c.area_fraction) < 0.0005, c.id);
    BOOST_TEST(contains(known.at(c.id).correct, c.wanted), c.id);
    BOOST_TEST(contains(known.at(c.id).correct, c.made), c.id);
    BOOST_TEST(std::string(c.wanted) == "N = " + std::to_string(std::lround(c.printed_area_fraction * disks_for_one)),
               c.id);
  }
}

BOOST_AUTO_TEST_SUITE_END()
