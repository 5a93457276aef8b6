#include "verify/pages/completion.hpp"

#include <fmt/format.h>

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

}  // namespace gpf
