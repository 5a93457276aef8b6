// Manual pages, man(7), from what the help says.
#pragma once

#include <map>
#include <string>

#include "verify/pages/command_facts.hpp"

namespace gpf {

/// File name -> text: gpf.1, and one page for each command of it, such as gpf-run.1.
/// version: of the program, for example "gpf 0.1.0". date: of the pages, such as 2024-05-06.
std::map<std::string, std::string> manual_pages(const CommandFacts& program, const std::string& version,
                                                const std::string& date);

}  // namespace gpf
