// An open file of the operating system that closes itself, and failed system calls as StorageError.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace gpf {

/// The StorageError for a failed system call.
/// problem: what could not be done; error_number: errno as the call left it.
[[noreturn]] void throw_system_error(const std::string& problem, int error_number);

/// Owns a POSIX file descriptor. Interrupted calls (EINTR) are repeated.
class FileDescriptor {
 public:
  /// Opens `path` with open(2)'s flags; created files get mode 0666 less the umask.
  /// @throws StorageError "cannot open <path>"
  FileDescriptor(const std::filesystem::path& path, int flags);
  ~FileDescriptor();
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  [[nodiscard]] int get() const noexcept { return descriptor_; }

  /// Writes all bytes. @throws StorageError
  void write(std::string_view bytes);
  /// Reads up to the end of the file. @throws StorageError
  std::string read_all();
  /// Forces written data to the disk. @throws StorageError
  void sync();
  /// Closes now, so that errors which only close(2) reports are seen. @throws StorageError
  void close();

 private:
  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace gpf
