// What a shell offers when TAB is pressed, from what the help says.
#pragma once

#include <string>

#include "verify/pages/command_facts.hpp"

namespace gpf {

/// A script for each shell: commands, options, and values that come from a list. For all else the shell offers files.
std::string bash_completion(const CommandFacts& program);
std::string fish_completion(const CommandFacts& program);
std::string zsh_completion(const CommandFacts& program);

}  // namespace gpf
