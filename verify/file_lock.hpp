// One process at a time: an advisory lock on a file that exists only while somebody holds or waits for it.
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>

namespace gpf {

/// Held until destroyed; a process that dies releases it. Moves, does not copy.
class FileLock {
 public:
  /// Waits until the lock is free, looking about 20 times a second. Nothing when *stop becomes set before that.
  /// Throws StorageError when the file cannot be created or locked.
  static std::optional<FileLock> wait(const std::filesystem::path& path,
                                      const volatile std::sig_atomic_t* stop = nullptr);

  /// Nothing when another holds it. Throws as wait() does.
  static std::optional<FileLock> attempt(const std::filesystem::path& path);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  FileLock(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace gpf
