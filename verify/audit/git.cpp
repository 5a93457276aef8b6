#include "verify/audit/git.hpp"

#include <fmt/format.h>

#include "gpf/base/error.hpp"
#include "gpf/io/subprocess.hpp"

namespace gpf {
namespace {

/// All that decides about records and verdicts, wherever in the repository one is. The baseline is made of them.
const std::vector<std::string> paths{":(top)lib",
                                     ":(top)verify",
                                     ":(top)CMakeLists.txt",
                                     ":(top)CMakePresets.json",
                                     ":(top)reference",
                                     ":(top,exclude)reference/baseline.csv"};

std::vector<std::string> with_paths(std::vector<std::string> arguments) {
  arguments.emplace_back("--");
  arguments.insert(arguments.end(), paths.begin(), paths.end());
  return arguments;
}

}  // namespace

std::optional<std::string> git(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"git"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  try {
    ProcessResult result = run_program(command, "");
    if (result.exit_status != 0) return std::nullopt;
    while (result.output.ends_with('\n')) result.output.pop_back();
    return std::move(result.output);
  } catch (const StorageError&) {
    return std::nullopt;
  }
}

std::string commit_of(const std::string& revision) {
  const auto commit = git({"rev-parse", "--verify", "--quiet", fmt::format("{}^{{commit}}", revision)});
  const auto is_name = [](const std::string& text) {
    return text.size() == 40 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
  };
  if (!commit || !is_name(*commit))  // "^A" is accepted by git, and names no commit
    throw InputError(fmt::format("'{}' cannot be audited", revision),
                     "it is neither a folder with verdicts/quick/ nor a revision of a git repository here",
                     "give a store that gpf validate filled, a commit, or . for the working tree");
  return *commit;
}

bool same_sources(const std::string& before, const std::string& after) {
  std::vector<std::string> diff{"diff", "--quiet"};
  for (const std::string& revision : {before, after})
    if (revision != working_tree) diff.push_back(revision);
  if (diff.size() == 2) return true;
  if (!git(with_paths(diff))) return false;
  if (before != working_tree && after != working_tree) return true;
  const auto unknown = git(with_paths({"ls-files", "--others", "--exclude-standard"}));
  return unknown && unknown->empty();
}

}  // namespace gpf
