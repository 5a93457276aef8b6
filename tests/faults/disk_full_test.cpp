// Writers on a full disk and beyond a file size limit: a StorageError, the old file untouched, no .part left behind.
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "faults/child_process.hpp"
#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/hdf5.hpp"
#include "gpf/io/plot.hpp"
#include "unit/io/temporary_folder.hpp"

namespace {

using gpf::test::ChildProcess;
using gpf::test::TemporaryFolder;
namespace fs = std::filesystem;

constexpr std::size_t small = 1 << 10, room = 256 << 10, large = 1 << 20;  // bytes; small < room < large

void write_hdf5(const fs::path& path, std::size_t bytes) {
  gpf::Hdf5Writer writer(path);
  for (int i = 0; i < 4; ++i) {  // several groups, so that metadata and data are spread over the file
    writer.write("/group" + std::to_string(i) + "/data", std::vector<double>(bytes / 4 / sizeof(double), 1.5));
  }
  writer.commit();
}

void write_text(const fs::path& path, std::size_t bytes) { gpf::write_text_atomically(path, std::string(bytes, 'x')); }

/// Empty when a write that does not fit fails as it must: with `reason`, the old file and nothing else left.
std::string check_failure(void (*write)(const fs::path&, std::size_t), const TemporaryFolder& folder,
                          std::string_view reason) {
  const fs::path path = folder / "file";
  write(path, small);
  const std::string before = gpf::read_text(path);
  try {
    write(path, large);
    return "the write that does not fit succeeded";
  } catch (const gpf::StorageError& error) {
    if (error.why().find(reason) == std::string::npos || error.remedy().empty()) return error.what();
  }
  if (gpf::read_text(path) != before) return "the old file has changed";
  if (folder.names() != std::vector<std::string>{"file"}) return "something is left behind";
  write(path, small);  // and the writer is not impaired
  return "";
}

/// Makes this process root of a user namespace of its own, which may mount where a plain user may not.
bool become_own_root() {
  const std::string user = std::to_string(::geteuid()), group = std::to_string(::getegid());
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  std::ofstream("/proc/self/setgroups") << "deny";
  return bool(std::ofstream("/proc/self/uid_map") << "0 " + user + " 1" << std::flush) &&
         bool(std::ofstream("/proc/self/gid_map") << "0 " + group + " 1" << std::flush);
}

/// Lets this process see a file system with little room in place of the folder. False where the system forbids it.
bool mount_small_disk(const fs::path& folder) {
  if (::unshare(CLONE_NEWNS) != 0 && !become_own_root()) return false;
  if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  return ::mount("none", folder.c_str(), "tmpfs", 0, ("size=" + std::to_string(room)).c_str()) == 0;
}

boost::test_tools::assertion_result can_mount(boost::unit_test::test_unit_id) {
  const TemporaryFolder folder;
  return ChildProcess([&] { return mount_small_disk(folder.path()) ? "" : "no private mounts here"; }).wait() == 0;
}

void limit_file_size() {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{room, room};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

BOOST_AUTO_TEST_SUITE(disk_full)

BOOST_AUTO_TEST_CASE(no_space_left, *boost::unit_test::precondition(can_mount)) {
  for (const auto write : {write_text, write_hdf5}) {
    const TemporaryFolder folder;
    ChildProcess child([&]() -> std::string {
      if (!mount_small_disk(folder.path())) return "cannot mount";
      return check_failure(write, folder, "No space left");
    });
    BOOST_TEST(child.wait() == 0);
  }
}

BOOST_AUTO_TEST_CASE(file_size_limit) {
  for (const auto write : {write_text, write_hdf5}) {
    const TemporaryFolder folder;
    ChildProcess child([&] {
      limit_file_size();
      return check_failure(write, folder, "File too large");
    });
    BOOST_TEST(child.wait() == 0);
  }
}

BOOST_AUTO_TEST_CASE(plot_beyond_the_file_size_limit) {
  const TemporaryFolder folder;
  gpf::Plot plot;
  plot.series.push_back({.x = std::vector<double>(10000, 1.0), .y = std::vector<double>(10000, 2.0)});
  gpf::write_text_atomically(folder / "a.svg", "old");
  ChildProcess child([&]() -> std::string {
    limit_file_size();
    try {
      gpf::write_svg(plot, folder / "a.svg");
      return "a picture beyond the limit was written";
    } catch (const gpf::StorageError&) {
      return "";
    }
  });
  BOOST_TEST(child.wait() == 0);
  BOOST_TEST(gpf::read_text(folder / "a.svg") == "old");
  BOOST_TEST(folder.names() == std::vector<std::string>{"a.svg"});
}

BOOST_AUTO_TEST_CASE(device_that_is_always_full) {
  const TemporaryFolder folder;
  gpf::write_text_atomically(folder / "file", "old");
  fs::create_symlink("/dev/full", folder / "file.part");  // a .part that is there already is written through
  BOOST_CHECK_THROW(gpf::write_text_atomically(folder / "file", "new"), gpf::StorageError);
  BOOST_TEST(gpf::read_text(folder / "file") == "old");
  BOOST_TEST(folder.names() == std::vector<std::string>{"file"});
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
