#include "verify/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

/// Whether the open file is still the one that the path names: its last holder may have removed it meanwhile.
bool is_current(int descriptor, const std::filesystem::path& path) {
  struct stat open {
  }, named{};
  return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

StorageError cannot_lock(const std::filesystem::path& path, int error_number) {
  return {fmt::format("cannot lock '{}'", path.string()), std::generic_category().message(error_number),
          "choose a folder on a local disk that can be written"};
}

}  // namespace

std::optional<FileLock> FileLock::attempt(const std::filesystem::path& path) {
  while (true) {
    const int descriptor = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor < 0) throw cannot_lock(path, errno);
    const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const int failure = locked ? 0 : errno;
    if (locked && is_current(descriptor, path)) return FileLock(path, descriptor);
    ::close(descriptor);
    if (locked) continue;  // its last holder is gone
    if (failure != EWOULDBLOCK && failure != EINTR) throw cannot_lock(path, failure);
    return std::nullopt;
  }
}

std::optional<FileLock> FileLock::wait(const std::filesystem::path& path, const volatile std::sig_atomic_t* stop) {
  while (stop == nullptr || *stop == 0) {
    if (auto lock = attempt(path)) return lock;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return std::nullopt;
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock::~FileLock() {
  if (descriptor_ < 0) return;
  ::unlink(path_.c_str());  // while it is still held, so that it is this lock that goes
  ::close(descriptor_);
}

}  // namespace gpf
