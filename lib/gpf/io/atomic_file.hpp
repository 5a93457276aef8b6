// Files that appear under their final name complete or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace gpf {

/// Writes a file in one step as seen from outside: calls `write(part)` with part = path + ".part", then fsyncs the
/// part, renames it to `path` and fsyncs the folder. A process killed at any moment leaves under `path` what was
/// there before or the complete new file (and perhaps a .part, which the next write replaces). One writer per path at
/// a time: two would share the .part.
/// @throws StorageError with the system's reason when the part cannot be written, synced or renamed, or when `path` is
/// a device, a pipe or a socket. On this or on an exception from `write` (passed on unchanged) the .part is removed and `path` stays as it was.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

/// write_atomically with these bytes as the content.
/// @throws StorageError
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

/// The whole content of a file, byte for byte.
/// @throws StorageError when it cannot be opened or read.
std::string read_text(const std::filesystem::path& path);

}  // namespace gpf
