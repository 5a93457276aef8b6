// gpf validate: the claims of a tier, judged.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <thread>

#include "gpf/base/error.hpp"
#include "verify/commands.hpp"
#include "verify/gate.hpp"
#include "verify/reference_option.hpp"
#include "verify/stop_signals.hpp"
#include "verify/validate.hpp"

namespace gpf {
namespace {

int pass_gate(const ValidateOptions& options) {
  const auto findings = gate_findings({options.tier, options.store, options.reference, program_hash()});
  for (const std::string& finding : findings) fmt::print("{}\n", finding);
  if (findings.empty()) fmt::print("every required claim of tier {} is judged as expected\n", name_of(options.tier));
  return static_cast<int>(findings.empty() ? ExitStatus::success : ExitStatus::red);
}

}  // namespace

void add_validate_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ValidateOptions>();
  auto tier = std::make_shared<std::string>("quick");
  auto gate = std::make_shared<bool>(false);
  options->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("validate", "Run what the claims need and judge them");
  command->add_option("claim", options->claims, "Ids of claims; none: all of the tier")->type_name("CLAIM");
  command->add_option("--tier", *tier, "quick, standard or full")
      ->check(CLI::IsMember({"quick", "standard", "full"}))
      ->capture_default_str();
  command->add_option("-j,--jobs", options->jobs, "Runs at a time (default: one for each processor)")
      ->check(CLI::PositiveNumber);
  command->add_option("--store", options->store, "Folder of records and verdicts")->capture_default_str();
  add_reference_option(*command, options->reference);
  command->add_option("--release-seed", options->release_seed,
                      "standard and full: seed of this release's replicas (default: from the version)");
  command
      ->add_option("--replicas", options->replicas,
                   "quick: look once, with so many replicas, whatever the claims' caps (to compare two programs)")
      ->check(CLI::Range(2, 32));
  CLI::Option* only = command->add_option("--only-runs", options->only_runs,
                                          "Make the first look's records of these scenes and judge nothing");
  command->add_flag("--json", options->json, "Print one JSON object instead of the table");
  command
      ->add_flag("--gate", *gate, "Run and judge nothing: is every required claim judged by this program as expected?")
      ->excludes(only);
  command->add_option("--checkpoint-period", options->checkpoint_period, "Seconds between checkpoints of a run")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command->footer(
      "Exit status: 0 all green; 1 a claim is decided against its expectation; 77 a claim needs more data;\n"
      "75 stopped by a signal, the same command goes on.\n"
      "Examples:\n"
      "  gpf validate --tier quick\n"
      "  gpf validate eos.virial --jobs 2\n"
      "  gpf validate --replicas 8 --store build/eight\n");
  command->callback([options, tier, gate, &status] {
    options->tier = tier_named(*tier);
    options->stop = stop_on_signals();
    options->command = {"gpf", "validate", "--tier", *tier};
    status = *gate ? pass_gate(*options) : validate(*options);
  });
}

}  // namespace gpf
