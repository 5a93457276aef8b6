// Where claims, scenes and reference data are.
#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace gpf {

/// The folder reference/ of a clone, when gpf runs in one; else what was installed with the program, if anything was.
std::filesystem::path default_reference();

/// Adds --reference with that default.
void add_reference_option(CLI::App& command, std::filesystem::path& reference);

}  // namespace gpf
