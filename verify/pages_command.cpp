// gpf pages: manual pages and completion for shells, for those who build packages; not listed in the help.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/provenance.hpp"
#include "verify/claim.hpp"
#include "verify/commands.hpp"
#include "verify/pages/completion.hpp"
#include "verify/pages/manual.hpp"
#include "verify/reference_option.hpp"
#include "verify/writable.hpp"

namespace gpf {

void add_pages_command(CLI::App& app, int& status) {
  struct Options {
    std::filesystem::path folder, reference;
    std::string date;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("pages", "Write the manual pages and the completions for shells into a folder");
  command->group("");
  command->add_option("folder", options->folder, "Folder to write man/, bash/, fish/ and zsh/ into")->required();
  command->add_option("--date", options->date, "Of the manual pages, for example 2024-05-06")->required();
  add_reference_option(*command, options->reference);
  command->callback([options, &app, &status] {
    std::vector<std::string> claims;
    for (const Claim& claim : load_claims(options->reference / "claims")) claims.push_back(claim.id);
    const CommandFacts program = command_facts(app, "gpf", claims);
    for (const char* folder : {"man", "bash", "fish", "zsh"}) require_writable_folder(options->folder / folder);
    for (const auto& [name, text] : manual_pages(program, "gpf " + build_provenance().version, options->date))
      write_text_atomically(options->folder / "man" / name, text);
    write_text_atomically(options->folder / "bash" / "gpf", bash_completion(program));
    write_text_atomically(options->folder / "fish" / "gpf.fish", fish_completion(program));
    write_text_atomically(options->folder / "zsh" / "_gpf", zsh_completion(program));
    status = static_cast<int>(ExitStatus::success);
  });
}

}  // namespace gpf
