// gpf faults: which claims catch which faults.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>
#include <thread>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/commands.hpp"
#include "verify/faults/fault_page.hpp"
#include "verify/faults/fault_trial.hpp"
#include "verify/reference_option.hpp"
#include "verify/stop_signals.hpp"
#include "verify/toml_fields.hpp"
#include "verify/validate.hpp"
#include "verify/writable.hpp"

namespace gpf {
namespace {

struct Options {
  std::vector<std::string> faults, claims;
  std::string tier = "quick";
  std::optional<double> dose;
  bool smallest = false;
  std::filesystem::path output = "reports";
  FaultOptions trial;
};

Claim claim_named(const std::vector<Claim>& claims, const std::string& id) {
  for (const Claim& claim : claims)
    if (claim.id == id) return claim;
  throw InputError(fmt::format("unknown claim '{}', or one that reads no records", id),
                   "faults are put into the runs that a claim reads", "see gpf explain, and reference/claims/");
}

std::vector<Claim> chosen_claims(const Options& options) {
  std::vector<Claim> claims = claims_with_records(options.trial.reference, options.trial.tier);
  if (options.claims.empty()) return claims;
  std::vector<Claim> chosen;
  for (const std::string& id : options.claims) chosen.push_back(claim_named(claims, id));
  return chosen;
}

/// Prints what the faults that were asked for do.
int print_answers(const Options& options) {
  for (const std::string& name : options.faults) {
    const Fault& fault = fault_named(name);
    const std::vector<Claim> claims = chosen_claims(options);
    if (options.smallest) {
      const auto at_all = try_fault(fault, fault.dose, claims, options.trial);
      if (!at_all) return static_cast<int>(ExitStatus::interrupted);
      for (const Claim& claim : claims) {
        if (!is_caught(at_all->claims.at(claim.id).caught)) {
          fmt::print("{}: {} does not catch it at {:.3g} ({})\n", fault.name, claim.id, fault.dose, fault.dose_means);
          continue;
        }
        const auto found = smallest_dose(fault, claim, options.trial);
        if (!found) return static_cast<int>(ExitStatus::interrupted);
        fmt::print("{}: {} catches it from {:.3g} on ({}), not at {:.3g}\n", fault.name, claim.id, found->caught,
                   fault.dose_means, found->missed);
      }
      continue;
    }
    const auto trial = try_fault(fault, options.dose.value_or(fault.dose), claims, options.trial);
    if (!trial) return static_cast<int>(ExitStatus::interrupted);
    fmt::print("{} at {:.3g} ({})\n", fault.name, trial->dose, fault.dose_means);
    for (const Claim& claim : claims) {
      const FaultTrial::Answer& answer = trial->claims.at(claim.id);
      fmt::print("  {:<20} {:<13} {}\n", claim.id, name_of(answer.caught), answer.words);
    }
  }
  return static_cast<int>(ExitStatus::success);
}

/// Whose smallest doses reference/faults.toml asks for.
std::vector<std::pair<const Fault*, Claim>> read_wanted(const FaultOptions& options, const std::vector<Claim>& claims) {
  constexpr std::array<std::string_view, 1> file_keys{"smallest"};
  constexpr std::array<std::string_view, 2> keys{"fault", "claim"};
  const std::string path = (options.reference / "faults.toml").string();
  const TomlTable tree = read_toml(read_text(path), path);
  const TomlFields file(tree, {}, "", path, file_keys);
  std::vector<std::pair<const Fault*, Claim>> wanted;
  for (const TomlFields& table : file.tables("smallest", "[[smallest]]", keys))
    wanted.emplace_back(&fault_named(table.text("fault")), claim_named(claims, table.text("claim")));
  return wanted;
}

/// The matrix, what else reference/faults.toml asks for, and the page.
int make_matrix(const Options& options) {
  const auto stopped = static_cast<int>(ExitStatus::interrupted);
  FaultMatrix matrix;
  matrix.claims = claims_with_records(options.trial.reference, Tier::quick);
  const auto wanted = read_wanted(options.trial, matrix.claims);
  require_writable_folder(options.output);
  for (const Claim& claim : load_claims(options.trial.reference / "claims"))
    if (claim.judged_in(Tier::quick) && claim.scenes_in(Tier::quick).empty()) matrix.others.push_back(claim.id);
  fmt::print(stderr, "no fault\n");
  if (!all_green_without_fault(matrix.claims, options.trial)) return stopped;
  for (const Fault& fault : faults()) {
    fmt::print(stderr, "fault {} of {}: {}\n", matrix.trials.size() + 1, faults().size(), fault.name);
    const auto trial = try_fault(fault, fault.dose, matrix.claims, options.trial);
    if (!trial) return stopped;
    matrix.trials.push_back(*trial);
  }
  for (const auto& [fault, claim] : wanted) {
    fmt::print(stderr, "smallest dose: {}\n", fault->name);
    const auto found = smallest_dose(*fault, claim, options.trial);
    if (!found) return stopped;
    matrix.smallest.push_back(*found);
  }
  write_fault_page(matrix, options.output);
  fmt::print("{}\n", (options.output / "faults.md").string());
  const std::vector<std::string> missed = matrix.missed();
  for (const std::string& name : missed) fmt::print(stderr, "gpf: no claim that was tried catches '{}'\n", name);
  return static_cast<int>(missed.empty() ? ExitStatus::success : ExitStatus::red);
}

}  // namespace

void add_faults_command(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  options->trial.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("faults", "Put faults into the physics: which claims catch them?");
  command->add_option("fault", options->faults, "Faults to try; none: all, and write the page");
  command->add_option("--claim", options->claims, "Claims to judge (default: all of the tier that read records)")
      ->type_name("CLAIM");
  command->add_option("--tier", options->tier, "quick, standard or full")
      ->check(CLI::IsMember({"quick", "standard", "full"}))
      ->capture_default_str();
  CLI::Option* dose = command->add_option("--dose", options->dose, "How badly (default: the fault's own)");
  command->add_flag("--smallest", options->smallest, "Look for the smallest dose that each claim catches")
      ->excludes(dose);
  command->add_option("-j,--jobs", options->trial.jobs, "Runs at a time (default: one for each processor)")
      ->check(CLI::PositiveNumber);
  command->add_option("--store", options->trial.store, "Folder of records; answers are kept in its folder faults")
      ->capture_default_str();
  add_reference_option(*command, options->trial.reference);
  command->add_option("-o,--output", options->output, "Folder for the page")->capture_default_str();
  std::string list;
  for (const Fault& fault : faults())
    list += fmt::format("  {:<46} {}; dose {:.3g} ({})\n", fault.name, fault.what, fault.dose, fault.dose_means);
  command->footer(
      fmt::format("Faults:\n{}\nExit status: 1 when a fault of the page is caught by no claim; 75 stopped, the same "
                  "command goes on.\n"
                  "Examples:\n"
                  "  gpf faults\n"
                  "  gpf faults \"g off by 2 %\" --claim balance.momentum --dose 0.001\n"
                  "  gpf faults \"wall rule off by 0.5 %\" --claim slip.restitution --smallest\n",
                  list));
  command->callback([options, &status] {
    options->trial.tier = tier_named(options->tier);
    options->trial.stop = stop_on_signals();
    if (options->faults.empty() &&
        (options->smallest || options->dose || !options->claims.empty() || options->tier != "quick"))
      throw InputError("no fault is named", "these options are for single faults; the page is made with none of them",
                       "name one: gpf faults --help lists them");
    require_writable_folder(options->trial.store);  // now, rather than after the first runs
    status = options->faults.empty() ? make_matrix(*options) : print_answers(*options);
  });
}

}  // namespace gpf
