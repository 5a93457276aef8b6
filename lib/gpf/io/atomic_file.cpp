#include "gpf/io/atomic_file.hpp"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "gpf/base/error.hpp"
#include "gpf/io/file_descriptor.hpp"

namespace gpf {
namespace fs = std::filesystem;
namespace {

void sync_path(const fs::path& path) {
  FileDescriptor file(path, O_RDONLY);
  file.sync();
  file.close();
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  if (!path.has_filename()) throw StorageError("cannot write '" + path.string() + "'", "no file name", "name a file");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;  // what else may be wrong with the folder is reported by the write, with the system's reason
  if (fs::status(folder, ignored).type() == fs::file_type::not_found) {
    throw StorageError("cannot write " + path.string(), "the folder " + folder.string() + " does not exist",
                       "create it or choose another place");
  }
  const fs::file_status old = fs::symlink_status(path, ignored);
  if (fs::is_other(old)) {  // a device or a pipe, which the rename would replace
    throw StorageError("cannot write " + path.string(), "it is no file but a device, a pipe or a socket",
                       "name a file");
  }
  fs::path part = path;
  part += ".part";
  try {
    write(part);
    sync_path(part);
    if (std::rename(part.c_str(), path.c_str()) != 0) {
      throw_system_error("cannot rename " + part.string() + " to " + path.string(), errno);
    }
  } catch (...) {
    fs::remove(part, ignored);  // the first failure is the one to report
    throw;
  }
  sync_path(folder);
}

void write_text_atomically(const fs::path& path, std::string_view text) {
  write_atomically(path, [&](const fs::path& part) {
    FileDescriptor file(part, O_WRONLY | O_CREAT | O_TRUNC);
    file.write(text);
    file.close();
  });
}

std::string read_text(const fs::path& path) { return FileDescriptor(path, O_RDONLY).read_all(); }

}  // namespace gpf
