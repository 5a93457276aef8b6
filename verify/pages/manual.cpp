#include "verify/pages/manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace gpf {
namespace {

/// As it stands, in the language of man(7).
std::string literal(const std::string& text) {
  static const std::map<char, std::string> signs{{'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"}, {'`', "\\(ga"},
                                                 {'^', "\\(ha"}, {'~', "\\(ti"}, {'"', "\\(dq"}};
  std::string result;
  for (const char c : text) result += signs.contains(c) ? signs.at(c) : std::string(1, c);
  return result.starts_with('.') ? "\\&" + result : result;
}

std::string bold(const std::string& text) { return "\\fB" + literal(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + literal(text) + "\\fR"; }

/// Prose is filled, lines that begin with spaces stay as they are.
class Paragraphs {
 public:
  void add(const std::string& line) {
    const bool as_is = line.starts_with(' ');
    if (line.empty() || as_is != as_is_) end_paragraph();
    if (line.empty()) return;
    if (ended_ && !text_.empty()) text_ += ".PP\n";
    if (as_is && !as_is_) text_ += ".RS 2\n.EX\n";
    as_is_ = as_is;
    ended_ = false;
    text_ += literal(line.substr(std::min<std::size_t>(2, line.find_first_not_of(' ')))) + "\n";
    if (line.ends_with(':')) end_paragraph();
  }
  std::string text() {
    end_paragraph();
    return text_;
  }

 private:
  void end_paragraph() {
    if (as_is_) text_ += ".EE\n.RE\n";
    as_is_ = false;
    ended_ = true;
  }

  std::string text_;
  bool as_is_ = false, ended_ = true;
};

struct Footer {
  Paragraphs notes, exit_status, examples;
};

/// "Exit status" and "Example" begin parts of a footer; what stands before them are notes.
Footer parts_of(const std::string& footer) {
  Footer parts;
  Paragraphs* part = &parts.notes;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Exit status")) {
      part = &parts.exit_status;
      line = line.substr(line.find_first_not_of(": ", std::string_view("Exit status").size()));
    } else if (line.starts_with("Example")) {
      part = &parts.examples;
      continue;
    }
    part->add(line);
  }
  return parts;
}

std::string values_of(const OptionFacts& option) {
  if (option.choices.empty() || option.value == "CLAIM") return italic(option.value);
  std::string words;
  for (const std::string& choice : option.choices) words += (words.empty() ? "" : "|") + bold(choice);
  return words;
}

std::string synopsis(const CommandFacts& command) {
  std::string text = bold(command.path);
  for (const OptionFacts& option : command.options)
    if (!option.positional && option.required) text += " " + bold(option.names.front()) + " " + italic(option.value);
  text += " [" + italic("options") + "]";
  for (const OptionFacts& option : command.options) {
    if (!option.positional) continue;
    const std::string name = italic(option.names.front()) + (option.several ? "..." : "");
    text += " " + (option.required ? name : "[" + name + "]");
  }
  return text + (command.commands.empty() ? "" : " " + italic("command") + " ...") + "\n";
}

std::string described(const OptionFacts& option) {
  std::string text = ".TP\n";
  for (std::size_t i = 0; i < option.names.size(); ++i)
    text += (i > 0 ? ", " : "") + (option.positional ? italic(option.names[i]) : bold(option.names[i]));
  if (!option.positional && !option.value.empty()) text += " " + values_of(option);
  std::string remarks;
  if (!option.range.empty()) remarks += fmt::format(" ({})", option.range);
  if (!option.default_value.empty()) remarks += fmt::format(" [{}]", option.default_value);
  return text + "\n" + literal(option.description + remarks) + "\n";
}

std::string described_options(const CommandFacts& command) {
  std::string text;
  for (const bool positional : {true, false})
    for (const OptionFacts& option : command.options)
      if (option.positional == positional) text += described(option);
  return text;
}

std::string section(const std::string& title, const std::string& text) {
  return text.empty() ? "" : ".SH " + title + "\n" + text;
}

std::string page_name(const CommandFacts& command) {
  std::string name = command.path;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

/// "Simulate a scene" -> "simulate a scene", as the line NAME wants it.
std::string in_a_sentence(std::string text) {
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  return text;
}

std::string page(const CommandFacts& command, bool whole_program, const std::string& version, const std::string& date) {
  const std::string name = page_name(command);
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const std::string purpose = whole_program ? "granular Poiseuille flow, simulated event by event and judged"
                                            : in_a_sentence(command.description);
  Footer footer = parts_of(command.footer);
  std::string usage = whole_program || command.commands.empty() ? synopsis(command) : "";
  std::string commands;
  for (const CommandFacts& sub : command.commands) {
    if (whole_program) {
      commands += fmt::format(".TP\n.BR {} (1)\n{}\n", literal(page_name(sub)), literal(sub.description));
    } else {
      usage += (usage.empty() ? "" : ".br\n") + synopsis(sub);
      commands += fmt::format(".SS {}\n{}\n{}", literal(sub.name()), literal(sub.description), described_options(sub));
    }
  }
  Paragraphs prose;
  std::istringstream lines(command.description);
  for (std::string line; std::getline(lines, line);) prose.add(line);
  const std::string notes = footer.notes.text();
  return fmt::format(".TH {} 1 {} \"{}\" \"User Commands\"\n", literal(title), date, version) +
         section("NAME", literal(name) + " \\- " + literal(purpose) + "\n") + section("SYNOPSIS", usage) +
         section("DESCRIPTION", prose.text() + (notes.empty() ? "" : ".PP\n" + notes)) + section("COMMANDS", commands) +
         section("OPTIONS", described_options(command)) + section("EXIT STATUS", footer.exit_status.text()) +
         section("EXAMPLES", footer.examples.text()) + (whole_program ? "" : section("SEE ALSO", ".BR gpf (1)\n"));
}

}  // namespace

std::map<std::string, std::string> manual_pages(const CommandFacts& program, const std::string& version,
                                                const std::string& date) {
  std::map<std::string, std::string> pages{{page_name(program) + ".1", page(program, true, version, date)}};
  for (const CommandFacts& command : program.commands)
    pages[page_name(command) + ".1"] = page(command, false, version, date);
  return pages;
}

}  // namespace gpf
