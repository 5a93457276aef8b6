// Another program run to its end with its output in a file, and what it cost.
#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace gpf {

struct ChildResult {
  int exit_status = 0;     ///< as main returned it; 128 + n when signal n ended it
  double cpu_seconds = 0;  ///< of it and its children
  double peak_memory = 0;  ///< bytes: the largest resident set of it or one of its children
};

/// Runs arguments[0], looked up on the PATH, and waits for it; standard output and errors go to the end of `log`,
/// standard output instead to `output` where that is given. When *stop becomes set the child is asked to end (SIGTERM),
/// and waited for. Throws StorageError when the log cannot be opened or the program cannot be started.
ChildResult run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log,
                      const volatile std::sig_atomic_t* stop = nullptr, const std::filesystem::path& output = {});

}  // namespace gpf
