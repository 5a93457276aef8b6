// Errors: the grammar "problem (why): remedy", and the exit status each kind carries.
#include "gpf/base/error.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

namespace {

using namespace gpf;

BOOST_AUTO_TEST_SUITE(error)

BOOST_AUTO_TEST_CASE(what_reads_problem_why_remedy) {
  const InputError e("area fraction 0.95", "denser than close packing", "choose at most 0.90");
  BOOST_TEST(std::string(e.what()) == "area fraction 0.95 (denser than close packing): choose at most 0.90");
  BOOST_TEST(e.problem() == "area fraction 0.95");
  BOOST_TEST(e.why() == "denser than close packing");
  BOOST_TEST(e.remedy() == "choose at most 0.90");
}

BOOST_AUTO_TEST_CASE(absent_parts_leave_no_punctuation) {
  BOOST_TEST(std::string(InputError("a", "", "").what()) == "a");
  BOOST_TEST(std::string(InputError("a", "b", "").what()) == "a (b)");
  BOOST_TEST(std::string(InputError("a", "", "c").what()) == "a: c");
}

BOOST_AUTO_TEST_CASE(each_kind_carries_its_exit_status) {
  const auto status = [](const Error& e) { return static_cast<int>(e.status()); };
  BOOST_TEST(status(InputError("p", "w", "r")) == 2);
  BOOST_TEST(status(PhysicsError("p", "w", "r")) == 3);
  BOOST_TEST(status(StorageError("p", "w", "r")) == 4);
}

BOOST_AUTO_TEST_CASE(all_are_errors_and_standard_exceptions) {
  BOOST_CHECK_THROW(throw InputError("p", "w", "r"), Error);
  BOOST_CHECK_THROW(throw PhysicsError("p", "w", "r"), Error);
  BOOST_CHECK_THROW(throw StorageError("p", "w", "r"), std::exception);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
