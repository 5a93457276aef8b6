#include "verify/reference_option.hpp"

#include <CLI/CLI.hpp>
#include <system_error>

namespace gpf {

std::filesystem::path default_reference() {
  std::filesystem::path here = "reference";
  std::error_code ignored;
  if (std::filesystem::exists(here / "claims", ignored)) return here;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const auto installed = (program.parent_path() / GPF_REFERENCE_FROM_PROGRAM).lexically_normal();
  return std::filesystem::exists(installed / "claims", ignored) ? installed : here;
}

void add_reference_option(CLI::App& command, std::filesystem::path& reference) {
  reference = default_reference();
  command.add_option(
      "--reference", reference,
      "Folder that holds claims/, scenes/ and campaigns/ (default: reference, or else the installed one)");
}

}  // namespace gpf
