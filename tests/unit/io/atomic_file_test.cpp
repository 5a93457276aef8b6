#include "gpf/io/atomic_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <stdexcept>

#include "gpf/base/error.hpp"
#include "unit/io/temporary_folder.hpp"

namespace {

using gpf::StorageError;
using gpf::test::TemporaryFolder;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(atomic_file)

BOOST_AUTO_TEST_CASE(text_comes_back_byte_for_byte) {
  const TemporaryFolder folder;
  std::string text(300000, 'x');  // more than one chunk of the reader
  text[7] = '\0';
  text[299999] = '\xff';
  gpf::write_text_atomically(folder / "a", text);
  BOOST_TEST((gpf::read_text(folder / "a") == text));
  gpf::write_text_atomically(folder / "a", "");
  BOOST_TEST(gpf::read_text(folder / "a").empty());
  BOOST_TEST(folder.names() == std::vector<std::string>{"a"});
}

BOOST_AUTO_TEST_CASE(writer_sees_the_old_file_until_it_returns) {
  const TemporaryFolder folder;
  gpf::write_text_atomically(folder / "a", "old");
  gpf::write_atomically(folder / "a", [&](const fs::path& part) {
    BOOST_TEST(part == folder / "a.part");
    std::ofstream(part) << "new";
    BOOST_TEST(gpf::read_text(folder / "a") == "old");
  });
  BOOST_TEST(gpf::read_text(folder / "a") == "new");
}

BOOST_AUTO_TEST_CASE(stale_part_is_replaced) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.part") << "left behind by a killed process, and longer than the new text";
  gpf::write_text_atomically(folder / "a", "new");
  BOOST_TEST(gpf::read_text(folder / "a") == "new");
  BOOST_TEST(folder.names() == std::vector<std::string>{"a"});
}

BOOST_AUTO_TEST_CASE(a_pipe_or_a_device_is_not_replaced) {
  const TemporaryFolder folder;
  BOOST_TEST_REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  BOOST_CHECK_THROW(gpf::write_text_atomically(folder / "pipe", "text"), StorageError);
  BOOST_TEST(fs::is_fifo(folder / "pipe"));
  BOOST_CHECK_THROW(gpf::write_text_atomically("/dev/null", "text"), StorageError);
  BOOST_TEST(folder.names() == std::vector<std::string>{"pipe"});
}

BOOST_AUTO_TEST_CASE(relative_path_without_folder) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  gpf::write_text_atomically("here", "text");
  fs::current_path(before);
  BOOST_TEST(gpf::read_text(folder / "here") == "text");
}

BOOST_AUTO_TEST_CASE(exception_of_the_writer_passes_and_leaves_nothing) {
  const TemporaryFolder folder;
  gpf::write_text_atomically(folder / "a", "old");
  const auto fail = [](const fs::path& part) {
    std::ofstream(part) << "half";
    throw std::domain_error("mine");
  };
  BOOST_CHECK_EXCEPTION(gpf::write_atomically(folder / "a", fail), std::domain_error,
                        [](const auto& error) { return error.what() == std::string("mine"); });
  BOOST_TEST(gpf::read_text(folder / "a") == "old");
  BOOST_TEST(folder.names() == std::vector<std::string>{"a"});
}

BOOST_AUTO_TEST_CASE(writer_that_writes_nothing_is_a_storage_error) {
  const TemporaryFolder folder;
  BOOST_CHECK_THROW(gpf::write_atomically(folder / "a", [](const fs::path&) {}), StorageError);
  BOOST_TEST(folder.names().empty());
}

/// Whether the error names the file, gives the system's reason and a remedy.
auto says(const std::string& name, const std::string& why) {
  return [=](const StorageError& error) {
    return error.problem().find(name) != std::string::npos && error.why().find(why) != std::string::npos &&
           !error.remedy().empty() && error.status() == gpf::ExitStatus::storage;
  };
}

BOOST_AUTO_TEST_CASE(failures_of_the_system_are_storage_errors) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "taken");
  std::ofstream(folder / "file") << "text";
  BOOST_CHECK_EXCEPTION(gpf::write_text_atomically(folder / "no/a", "x"), StorageError, says("no/a", "does not exist"));
  BOOST_CHECK_EXCEPTION(gpf::write_text_atomically(folder / "taken", "x"), StorageError, says("taken", "directory"));
  BOOST_CHECK_EXCEPTION(gpf::write_text_atomically(folder / "file/a", "x"), StorageError, says("file/a", "Not a dir"));
  BOOST_CHECK_EXCEPTION(gpf::write_text_atomically(folder.path() / "", "x"), StorageError, says("", "no file name"));
  BOOST_CHECK_EXCEPTION(gpf::read_text(folder / "absent"), StorageError, says("absent", "No such file"));
  BOOST_CHECK_EXCEPTION(gpf::read_text(folder / "taken"), StorageError, says("taken", "directory"));
  BOOST_TEST(folder.names() == (std::vector<std::string>{"file", "taken"}));
}

BOOST_AUTO_TEST_CASE(forbidden_folder, *boost::unit_test::precondition([](auto) { return ::geteuid() != 0; })) {
  const TemporaryFolder folder;  // root may write anywhere, hence the precondition
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  BOOST_CHECK_EXCEPTION(gpf::write_text_atomically(folder / "a", "x"), StorageError, says("a.part", "Permission"));
  fs::permissions(folder.path(), fs::perms::owner_all);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
