#include "gpf/io/subprocess.hpp"

#include <boost/test/unit_test.hpp>
#include <csignal>

#include "gpf/base/error.hpp"
#include "unit/io/environment.hpp"

namespace {

using gpf::run_program;

BOOST_AUTO_TEST_SUITE(subprocess)

BOOST_AUTO_TEST_CASE(streams_and_status) {
  const auto result = run_program({"sh", "-c", "cat; echo trouble >&2; exit 3"}, "in\0put");
  BOOST_TEST(result.exit_status == 3);
  BOOST_TEST(result.output == "in");  // the literal ends at its NUL
  BOOST_TEST(result.errors == "trouble\n");
}

BOOST_AUTO_TEST_CASE(more_than_a_pipe_holds) {
  const std::string megabyte(1 << 20, 'x');
  BOOST_TEST((run_program({"cat"}, megabyte).output == megabyte));
}

BOOST_AUTO_TEST_CASE(input_that_nobody_reads) { BOOST_TEST(run_program({"true"}, "unread").exit_status == 0); }

BOOST_AUTO_TEST_CASE(arguments_meet_no_shell) {
  BOOST_TEST(run_program({"printf", "%s", "$HOME `id` ; 'x'"}, "").output == "$HOME `id` ; 'x'");
}

BOOST_AUTO_TEST_CASE(death_by_signal) {
  BOOST_TEST(run_program({"sh", "-c", "kill -KILL $$"}, "").exit_status == 128 + SIGKILL);
}

BOOST_AUTO_TEST_CASE(missing_program_is_a_storage_error) {
  const gpf::test::ScopedVariable nowhere("PATH", "/nonexistent");
  BOOST_CHECK_EXCEPTION(run_program({"cat"}, ""), gpf::StorageError, [](const gpf::StorageError& error) {
    return error.problem() == "cannot start cat" && error.why().find("No such file") != std::string::npos &&
           !error.remedy().empty();
  });
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
