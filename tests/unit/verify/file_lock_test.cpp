#include "verify/file_lock.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <fstream>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"

using gpf::FileLock;

BOOST_AUTO_TEST_SUITE(file_lock)

BOOST_AUTO_TEST_CASE(the_file_is_gone_when_nobody_holds_it) {
  const gpf::test::TemporaryFolder folder;
  {
    const auto lock = FileLock::wait(folder / "a.lock");
    BOOST_TEST(lock.has_value());
    BOOST_TEST(folder.names().size() == 1U);
  }
  BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_CASE(a_lock_that_is_held_is_waited_for_until_told_to_stop) {
  const gpf::test::TemporaryFolder folder;
  const auto held = FileLock::wait(folder / "a.lock");
  static volatile std::sig_atomic_t stop = 0;
  std::signal(SIGALRM, [](int) { stop = 1; });
  ::alarm(1);
  BOOST_TEST(!FileLock::wait(folder / "a.lock", &stop).has_value());
  BOOST_TEST(stop == 1);
}

// Four processes add one to a number in a file 50 times each, reading and writing under the lock. Any two inside at a
// time would lose an addition.
BOOST_AUTO_TEST_CASE(one_process_at_a_time) {
  const gpf::test::TemporaryFolder folder;
  gpf::write_text_atomically(folder / "number", "0");
  for (int child = 0; child < 4; ++child) {
    if (::fork() != 0) continue;
    for (int k = 0; k < 50; ++k) {
      const auto lock = FileLock::wait(folder / "a.lock");
      const int number = std::stoi(gpf::read_text(folder / "number"));
      ::usleep(200);
      std::ofstream(folder / "number") << number + 1;
    }
    ::_exit(0);
  }
  for (int child = 0; child < 4; ++child) {
    int status = 0;
    ::wait(&status);
    BOOST_TEST(status == 0);
  }
  BOOST_TEST(gpf::read_text(folder / "number") == "200");
  BOOST_TEST(folder.names().size() == 1U);  // no lock is left
}

BOOST_AUTO_TEST_CASE(a_process_that_dies_lets_go) {
  const gpf::test::TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = FileLock::wait(folder / "a.lock");
    ::raise(SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  BOOST_TEST(FileLock::wait(folder / "a.lock").has_value());
}

BOOST_AUTO_TEST_CASE(a_lock_in_a_folder_that_does_not_exist_is_an_error) {
  const gpf::test::TemporaryFolder folder;
  BOOST_CHECK_THROW(FileLock::wait(folder / "none/a.lock"), gpf::StorageError);
}

BOOST_AUTO_TEST_SUITE_END()
