#include "verify/pages/command_facts.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

namespace gpf {
namespace {

/// CLI11 says kind and range in one text: "TEXT:{quick,standard}", "INT:POSITIVE", "INT:INT in [2 - 32]".
void read_type(const std::string& text, OptionFacts& facts) {
  const std::size_t brace = text.find('{'), colon = text.find(':');
  if (brace != std::string::npos) {
    facts.choices = CLI::detail::split(text.substr(brace + 1, text.find('}') - brace - 1), ',');
  } else if (colon != std::string::npos) {
    facts.range = text.substr(colon + 1);
    std::transform(facts.range.begin(), facts.range.end(), facts.range.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::size_t limits = facts.range.find('[');
    if (limits != std::string::npos) facts.range = facts.range.substr(limits + 1, facts.range.find(']') - limits - 1);
  }
  facts.value = brace == 0 ? "TEXT" : text.substr(0, colon);
}

OptionFacts option_facts(const CLI::Option& option, const std::vector<std::string>& claims) {
  OptionFacts facts;
  facts.positional = option.get_positional();
  if (facts.positional) facts.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) facts.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) facts.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) read_type(option.get_type_name(), facts);
  if (facts.value == "CLAIM") facts.choices = claims;
  facts.description = option.get_description();
  facts.default_value = option.get_default_str();
  facts.required = option.get_required();
  facts.several = option.get_items_expected_max() > 1;
  return facts;
}

}  // namespace

CommandFacts command_facts(const CLI::App& app, const std::string& path, const std::vector<std::string>& claims) {
  CommandFacts facts{path, app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) facts.options.push_back(option_facts(*option, claims));
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* a) { return !a->get_group().empty(); }))
    facts.commands.push_back(command_facts(*command, path + " " + command->get_name(), claims));
  return facts;
}

}  // namespace gpf
