// gpf explain: what a claim says and how it is tested.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/scene/nearest_word.hpp"
#include "verify/commands.hpp"
#include "verify/explain.hpp"
#include "verify/reference_option.hpp"

namespace gpf {
namespace {

struct ExplainOptions {
  std::string claim;
  std::filesystem::path reference;
};

void print_explanation(const ExplainOptions& options) {
  const std::vector<Claim> claims = load_claims(options.reference / "claims");
  std::vector<std::string_view> ids;
  for (const Claim& claim : claims) {
    if (claim.id == options.claim) {
      fmt::print("{}", explain(claim, options.reference));
      return;
    }
    ids.push_back(claim.id);
  }
  throw InputError(fmt::format("unknown claim '{}'", options.claim), fmt::format("there are {}", fmt::join(ids, ", ")),
                   fmt::format("did you mean '{}'?", nearest_word(options.claim, ids)));
}

}  // namespace

void add_explain_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command =
      app.add_subcommand("explain", "Say what a claim states, how it is tested and how far off it may be");
  command->add_option("claim", options->claim, "Id of the claim")->required()->type_name("CLAIM");
  add_reference_option(*command, options->reference);
  command->footer("Example:\n  gpf explain eos.global\n");
  command->callback([options, &status] {
    print_explanation(*options);
    status = static_cast<int>(ExitStatus::success);
  });
}

}  // namespace gpf
