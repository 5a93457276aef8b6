// Another program run to its end, without a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gpf {

struct ProcessResult {
  int exit_status;             ///< as main returned it; 128 + n when signal n ended the program
  std::string output, errors;  ///< standard output and standard error
};

/// Runs arguments[0], looked up on the PATH, with `input` as its standard input, and waits for it.
/// @throws StorageError when it cannot be started.
ProcessResult run_program(const std::vector<std::string>& arguments, std::string_view input);

}  // namespace gpf
