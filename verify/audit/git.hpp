// What git says about the repository in the current folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gpf {

/// The working tree as it is, where a revision is asked for.
inline constexpr const char* working_tree = ".";

/// Standard output of git, without the line break at its end; nothing when it fails or there is no git.
std::optional<std::string> git(const std::vector<std::string>& arguments);

/// The commit of a revision, 40 digits. Throws InputError when there is none of that name here.
std::string commit_of(const std::string& revision);

/// Nothing that simulates, measures or judges, and nothing that is judged, differs between two revisions (each may be
/// working_tree; then files that git does not know yet count too).
bool same_sources(const std::string& before, const std::string& after);

}  // namespace gpf
