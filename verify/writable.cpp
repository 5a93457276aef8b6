#include "verify/writable.hpp"

#include <fmt/format.h>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"

namespace gpf {

void require_writable_folder(const std::filesystem::path& folder) {
  std::error_code ignored;  // the write says what is wrong
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path probe = folder / ".gpf-probe";
  write_text_atomically(probe, "");
  std::filesystem::remove(probe, ignored);
}

void require_writable_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
    throw StorageError(fmt::format("'{}' is no regular file", file.string()), "it would be replaced",
                       "name a file, or leave the option out for standard output");
  require_writable_folder(file.has_parent_path() ? file.parent_path() : ".");
}

}  // namespace gpf
