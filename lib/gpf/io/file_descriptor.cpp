#include "gpf/io/file_descriptor.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

std::string remedy_for(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "free some space there or choose a folder on another disk";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f) or write less";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a place where you have the right to do this, or change its permissions";
    case ENOENT:
    case ENOTDIR:
      return "check the path, and create the folder if it is missing";
    case EISDIR:
      return "name a file, not a folder";
    case EMFILE:
    case ENFILE:
      return "close other files or raise the limit on open files (ulimit -n)";
    default:
      return "check the disk and its file system, then try again";
  }
}

/// Calls a system function until a signal no longer interrupts it.
template <typename Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

}  // namespace

void throw_system_error(const std::string& problem, int error_number) {
  throw StorageError(problem, std::generic_category().message(error_number), remedy_for(error_number));
}

FileDescriptor::FileDescriptor(const std::filesystem::path& path, int flags)
    : path_(path), descriptor_(uninterrupted([&] { return ::open(path.c_str(), flags | O_CLOEXEC, 0666); })) {
  if (descriptor_ < 0) throw_system_error("cannot open " + path_.string(), errno);
}

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FileDescriptor::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = uninterrupted([&] { return ::write(descriptor_, bytes.data(), bytes.size()); });
    if (written < 0) throw_system_error("cannot write " + path_.string(), errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string FileDescriptor::read_all() {
  struct stat status {};
  std::string bytes;
  if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) {
    bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);  // only a hint: the file may be growing
  }
  std::array<char, 1 << 16> chunk{};
  for (;;) {
    const auto got = uninterrupted([&] { return ::read(descriptor_, chunk.data(), chunk.size()); });
    if (got < 0) throw_system_error("cannot read " + path_.string(), errno);
    if (got == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
  }
}

void FileDescriptor::sync() {
  if (uninterrupted([&] { return ::fsync(descriptor_); }) == 0) return;
  // Some file systems cannot sync what they hold (folders of network mounts); that is not a failed write.
  if (errno != EINVAL && errno != ENOTSUP) throw_system_error("cannot flush " + path_.string() + " to the disk", errno);
}

void FileDescriptor::close() {
  // Not repeated on EINTR: the descriptor is gone in any case.
  if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) {
    throw_system_error("cannot close " + path_.string(), errno);
  }
}

}  // namespace gpf
