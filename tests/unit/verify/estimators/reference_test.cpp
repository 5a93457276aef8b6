// The claim files of the project: each can be judged.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <set>

#include "gpf/base/error.hpp"
#include "verify/claim.hpp"
#include "verify/evidence.hpp"
#include "verify/planner.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(reference)

const std::filesystem::path folder = GPF_REFERENCE;

BOOST_AUTO_TEST_CASE(each_claim_names_an_estimator_and_scenes_that_exist) {
  std::set<std::string> used;
  for (const Claim& claim : load_claims(folder / "claims")) {
    BOOST_TEST(estimator_named(claim.estimator) != nullptr);
    for (const Tier tier : {Tier::quick, Tier::standard, Tier::full})
      for (const std::string& scene : claim.scenes_in(tier)) used.insert(scene);
  }
  SceneLibrary scenes(folder);
  for (const std::string& scene : used) BOOST_CHECK_NO_THROW(scenes.of(scene));
  for (const auto& entry : std::filesystem::directory_iterator(folder / "scenes"))
    BOOST_TEST(used.contains(entry.path().stem().string()), entry.path().filename() << " is read by no claim");
}

BOOST_AUTO_TEST_CASE(each_required_claim_has_its_file) {
  std::set<std::string> ids;
  for (const Claim& claim : load_claims(folder / "claims")) ids.insert(claim.id);
  std::ifstream required(folder / "claims" / "required.txt");
  BOOST_TEST_REQUIRE(required.good());
  for (std::string id; std::getline(required, id);) BOOST_TEST(ids.contains(id), id);
}

BOOST_AUTO_TEST_CASE(an_unknown_estimator_is_refused_with_the_known_ones) {
  try {
    (void)estimator_named("eos_globl");
    BOOST_FAIL("no error");
  } catch (const InputError& error) {
    BOOST_TEST(std::string(error.what()).find("eos_global") != std::string::npos);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
