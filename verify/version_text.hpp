// What `gpf --version` prints.
#pragma once

#include <string>

namespace gpf {

/// How this program was built, one fact a line: version, commit, physics version, compiler, flags, libraries. The first
/// line is "gpf" and the version.
std::string version_text();

/// The same as a JSON object, keys as in a record's provenance.
std::string version_json();

}  // namespace gpf
