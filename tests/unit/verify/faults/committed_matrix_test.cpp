// The committed matrix of the last release, reports/faults.csv: it holds every fault and claim, and says enough.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "verify/claim.hpp"
#include "verify/faults/fault.hpp"
#include "verify/faults/fault_trial.hpp"

using namespace gpf;

namespace {

/// fault -> claim -> how it answers.
using Answers = std::map<std::string, std::map<std::string, std::string>>;

Answers committed() {
  Answers answers;
  std::ifstream file(GPF_REPORTS "/faults.csv");
  std::string line;
  std::getline(file, line);
  BOOST_TEST_REQUIRE(line == "claim,fault,tier,dose,caught");
  const std::regex row("([^,]*),\"([^\"]*)\",quick,([^,]*),([a-z ]*)");
  for (std::smatch m; std::getline(file, line);) {
    BOOST_TEST_REQUIRE(std::regex_match(line, m, row), line);
    BOOST_TEST(std::abs(std::stod(m[3]) / fault_named(m[2].str()).dose - 1) < 1e-5, line);
    answers[m[2]][m[1]] = m[4];
  }
  return answers;
}

bool caught(const std::string& answer) { return answer == "caught" || answer == "health check"; }

}  // namespace

BOOST_AUTO_TEST_SUITE(committed_matrix)

BOOST_AUTO_TEST_CASE(every_fault_is_caught) {
  const Answers answers = committed();
  for (const Fault& fault : faults()) {
    const auto& row = answers.at(std::string(fault.name));
    BOOST_TEST(std::any_of(row.begin(), row.end(), [](const auto& a) { return caught(a.second); }), fault.name);
  }
}

BOOST_AUTO_TEST_CASE(every_claim_of_tier_quick_is_tried_and_catches_what_it_says) {
  const Answers answers = committed();
  for (const Claim& claim : claims_with_records(GPF_REFERENCE, Tier::quick)) {
    std::set<std::string> catches;
    for (const Fault& fault : faults()) {
      const auto& row = answers.at(std::string(fault.name));
      BOOST_TEST_REQUIRE(row.contains(claim.id), claim.id << ": not tried with '" << fault.name << "'");
      if (caught(row.at(claim.id))) catches.insert(std::string(fault.name));
    }
    BOOST_TEST(!catches.empty(), claim.id << " catches nothing");
    for (const std::string& stated : claim.catches)
      BOOST_TEST(catches.contains(stated), claim.id << " says that it catches '" << stated << "'");
  }
}

BOOST_AUTO_TEST_SUITE_END()
