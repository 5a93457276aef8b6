// Whether results can be written, asked before the work that makes them.
#pragma once

#include <filesystem>

namespace gpf {

/// Creates the folder and tries it. Throws StorageError with the system's reason.
void require_writable_folder(const std::filesystem::path& folder);

/// Tries the folder of a file that need not be there yet. Throws StorageError, also when `file` is there and is no
/// regular file: it would be replaced.
void require_writable_file(const std::filesystem::path& file);

}  // namespace gpf
