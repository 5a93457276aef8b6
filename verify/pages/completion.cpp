#include "verify/pages/completion.hpp"

#include <fmt/format.h>

#include "verify/command_text.hpp"

namespace gpf {
namespace {

/// Calls f for the command and all below it.
template <typename Function>
void visit(const CommandFacts& command, const Function& f) {
  f(command);
  for (const CommandFacts& sub : command.commands) visit(sub, f);
}

/// What may stand after a command: its options, and its commands or the choices of its arguments.
std::pair<std::string, std::string> words_after(const CommandFacts& command) {
  std::string options, words;
  for (const CommandFacts& sub : command.commands) words += sub.name() + " ";
  for (const OptionFacts& option : command.options) {
    if (option.positional)
      words += fmt::format("{} ", fmt::join(option.choices, " "));
    else
      options += fmt::format("{} ", fmt::join(option.names, " "));
  }
  return {options, words};
}

std::string replaced(std::string text, char what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) text.replace(at, 1, by);
  return text;
}

std::string fish_quoted(const std::string& text) {
  return "'" + replaced(replaced(text, '\\', "\\\\"), '\'', "\\'") + "'";
}

/// A word of a command line, with a space before it.
std::string zsh_quoted(const std::string& text) { return " " + shell_word(text); }

/// For within a specification of _arguments.
std::string zsh_escaped(std::string text) {
  for (const char special : {'\\', ':', '[', ']'}) text = replaced(text, special, std::string{'\\', special});
  return text;
}

}  // namespace

std::string bash_completion(const CommandFacts& program) {
  std::string paths, values, words;
  visit(program, [&](const CommandFacts& command) {
    if (&command != &program) paths += (paths.empty() ? "" : " | ") + ('"' + command.path + '"');
    for (const OptionFacts& option : command.options) {
      if (option.positional || option.value.empty()) continue;
      std::string names;
      for (const std::string& name : option.names)
        names += (names.empty() ? "" : " | ") + fmt::format("\"{} {}\"", command.path, name);
      values += fmt::format("    {}) words=\"{}\" ;;\n", names, fmt::join(option.choices, " "));
    }
    const auto [options, others] = words_after(command);
    words += fmt::format("        \"{}\") options=\"{}\" words=\"{}\" ;;\n", command.path, options, others);
  });
  return fmt::format(R"(# Completion of gpf for bash; written by gpf itself.
_gpf() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command=gpf options="" words="" word
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$command $word" in
    {}) command="$command $word" ;;
    esac
  done
  # --option=value comes as three words.
  if [ "$current" = "=" ]; then
    current=""
  elif [ "$before" = "=" ]; then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  case "$command $before" in
{}    *)
      case "$command" in
{}      esac
      case "$current" in
      -*) words=$options ;;
      esac
      ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _gpf gpf
)",
                     paths, values, words);
}

std::string fish_completion(const CommandFacts& program) {
  std::string paths, rules;
  visit(program, [&](const CommandFacts& command) {
    if (&command != &program) paths += " " + fish_quoted(command.path);
    const std::string here = fmt::format("complete -c gpf -n 'test (__gpf_command) = \"{}\"'", command.path);
    for (const CommandFacts& sub : command.commands)
      rules += fmt::format("{} -f -a {} -d {}\n", here, sub.name(), fish_quoted(sub.description));
    for (const OptionFacts& option : command.options) {
      const std::string choices = fmt::format("{}", fmt::join(option.choices, " "));
      std::string rule = here;
      if (!option.positional)
        for (const std::string& name : option.names)
          rule += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      else if (choices.empty())
        continue;  // files, which fish offers anyway
      if (!option.positional && !option.value.empty()) rule += choices.empty() ? " -r" : " -x";
      if (!choices.empty()) rule += (option.positional ? " -f -a " : " -a ") + fish_quoted(choices);
      rules += fmt::format("{} -d {}\n", rule, fish_quoted(option.description));
    }
  });
  return fmt::format(R"(# Completion of gpf for fish; written by gpf itself.
function __gpf_command
    set -l command gpf
    for word in (commandline -opc)[2..]
        contains -- "$command $word"{}; and set command "$command $word"
    end
    echo $command
end
{})",
                     paths, rules);
}

std::string zsh_completion(const CommandFacts& program) {
  std::string paths, cases;
  visit(program, [&](const CommandFacts& command) {
    if (&command != &program) paths += (paths.empty() ? "" : "|") + ('"' + command.path + '"');
    std::string specs, last = " '*:file:_files'";
    for (const OptionFacts& option : command.options) {
      const std::string choices =
          option.choices.empty() ? "_files" : fmt::format("({})", fmt::join(option.choices, " "));
      if (option.positional) {
        if (!option.choices.empty()) last = zsh_quoted("*:" + zsh_escaped(option.names.front()) + ":" + choices);
        continue;
      }
      const std::string value = option.value.empty() ? "" : fmt::format(":{}:{}", zsh_escaped(option.value), choices);
      for (const std::string& name : option.names)
        specs += zsh_quoted(fmt::format(
            "{}{}{}[{}]{}", option.several ? "*" : fmt::format("({})", fmt::join(option.names, " ")), name,
            !option.value.empty() && name.starts_with("--") ? "=" : "", zsh_escaped(option.description), value));
    }
    if (!command.commands.empty()) {
      std::string names;
      for (const CommandFacts& sub : command.commands)
        names += zsh_quoted(zsh_escaped(sub.name()) + ":" + sub.description);
      cases += fmt::format(
          "  (\"{}\")\n    local -a names=({})\n    _arguments -S :{} '1:command:{{_describe command "
          "names}}' ;;\n",
          command.path, names, specs);
      return;
    }
    cases += fmt::format("  (\"{}\") _arguments -S :{}{} ;;\n", command.path, specs, last);
  });
  return fmt::format(R"(#compdef gpf
# Completion of gpf for zsh; written by gpf itself.
local command=gpf word
integer deep=1 place
for ((place = 2; place < CURRENT; ++place)); do
  case "$command $words[place]" in
  ({}) command="$command $words[place]" deep=place ;;
  esac
done
words=("${{(@)words[deep,-1]}}")
((CURRENT -= deep - 1))
case $command in
{}esac
)",
                     paths, cases);
}

}  // namespace gpf
