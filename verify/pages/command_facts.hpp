// What the program's help knows of a command, as values: for manual pages and completions.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gpf {

struct OptionFacts {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional argument its one name
  std::string value;               ///< kind of its value, for example TEXT; empty: a flag
  std::string range;  ///< what a value must be, for example "positive", "2 - 32"; empty: anything of its kind
  std::vector<std::string> choices;  ///< empty: not from a list
  std::string description, default_value;
  bool positional = false, required = false, several = false;
};

struct CommandFacts {
  std::string path;  ///< for example "gpf campaign plan"
  std::string description, footer;
  std::vector<OptionFacts> options;
  std::vector<CommandFacts> commands;

  [[nodiscard]] std::string name() const { return path.substr(path.rfind(' ') + 1); }
};

/// The facts of an app and of all its sub-commands but hidden ones. Choices of values of the kind CLAIM are `claims`.
CommandFacts command_facts(const CLI::App& app, const std::string& path, const std::vector<std::string>& claims);

}  // namespace gpf
