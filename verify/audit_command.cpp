// gpf audit: two versions of the program compared, and the baseline of this one.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <thread>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/scene/nearest_word.hpp"
#include "verify/audit/audit.hpp"
#include "verify/audit/baseline.hpp"
#include "verify/audit/commit_check.hpp"
#include "verify/claim.hpp"
#include "verify/commands.hpp"
#include "verify/stop_signals.hpp"
#include "verify/writable.hpp"

namespace gpf {
namespace {

struct Options {
  AuditOptions audit;
  std::string declared, output;
  std::filesystem::path store = "records";
  bool write_baseline = false, check_baseline = false, check_commit = false;

  [[nodiscard]] std::filesystem::path baseline() const { return audit.reference / "baseline.csv"; }
};

constexpr int red = static_cast<int>(ExitStatus::red), success = static_cast<int>(ExitStatus::success);

/// Throws unless the claims asked for exist, as far as this program's own reference knows.
void require_known(const AuditOptions& options) {
  if (options.sides.claims.empty()) return;
  const std::vector<Claim> claims = load_claims(options.reference / "claims");
  std::vector<std::string_view> known;
  for (const Claim& claim : claims)
    if (claim.judged_in(Tier::quick)) known.push_back(claim.id);
  for (const std::string& id : options.sides.claims)
    if (known.empty() || std::find(known.begin(), known.end(), id) == known.end())
      throw InputError(fmt::format("unknown claim '{}', or one that tier quick does not judge", id),
                       known.empty() ? "there is no claim" : fmt::format("did you mean '{}'?", nearest_word(id, known)),
                       fmt::format("see {}", (options.reference / "claims").string()));
}

int compare_versions(Options options) {
  AuditOptions& audit_options = options.audit;
  if (audit_options.before.empty() || audit_options.after.empty())
    throw InputError("gpf audit needs two versions", "it compares A with B", "name two stores or revisions");
  if (!options.declared.empty()) audit_options.declared = physics_change_named(options.declared);
  if (!options.output.empty()) require_writable_file(options.output);  // now, rather than when the work is done
  require_known(audit_options);
  audit_options.sides.stop = stop_on_signals();
  const AuditReport report = audit(audit_options);
  if (options.output.empty())
    fmt::print("{}", audit_page(report));
  else
    write_text_atomically(options.output, audit_page(report));
  fmt::print(stderr, "gpf audit: {}{}\n", name_of(report.found),
             report.declared ? fmt::format(", declared {}: {}", name_of(*report.declared),
                                           report.rejected() ? "rejected" : "accepted")
                             : "");
  return report.rejected() ? red : success;
}

int check_baseline(const Options& options) {
  const EvidenceSet baseline = parse_baseline(read_text(options.baseline()), options.baseline().string());
  const auto differences = baseline_differences(baseline, baseline_evidence(options.store, options.audit.reference));
  for (const std::string& line : differences) fmt::print("{}\n", line);
  if (differences.empty()) {
    fmt::print("{} runs and {} checks are those of the baseline\n", baseline.runs.size(), baseline.numbers.size());
    return success;
  }
  fmt::print(
      "{} differences from {}: if they are meant, gpf audit --write-baseline --store {} and declare the change in "
      "the commit (Physics-Change: roundoff, same physics or new physics)\n",
      differences.size(), options.baseline().string(), options.store.string());
  return red;
}

int check_commit() {
  const CommitCheck check = check_last_commit();
  if (!check.skipped.empty()) {
    fmt::print("nothing to check: {}\n", check.skipped);
    return static_cast<int>(ExitStatus::inconclusive);
  }
  fmt::print("the last commit declares {}; its baseline shows at least {}\n", name_of(check.declared),
             name_of(check.shown));
  return check.rejected() ? red : success;
}

int run(const Options& options) {
  if (options.write_baseline) {
    write_text_atomically(options.baseline(), baseline_text(baseline_evidence(options.store, options.audit.reference)));
    fmt::print("{}\n", options.baseline().string());
    return success;
  }
  if (options.check_baseline) return check_baseline(options);
  return options.check_commit ? check_commit() : compare_versions(options);
}

}  // namespace

void add_audit_command(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  SideOptions& sides = options->audit.sides;
  sides.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command =
      app.add_subcommand("audit", "Say what moved between two versions, and of which class the change is");
  CLI::Option* before =
      command->add_option("before", options->audit.before, "A: a store, a git revision, or . for the working tree");
  CLI::Option* after = command->add_option("after", options->audit.after, "B: likewise");
  CLI::Option* declare =
      command->add_option("--declare", options->declared, "Exit with 1 if the change is more than that")
          ->type_name("{bitwise,roundoff,same-physics,new-physics}");
  command->add_option("--output", options->output, "File for the page (default: standard output)");
  command->add_option("-j,--jobs", sides.jobs, "Runs at a time (default: one for each processor)")
      ->check(CLI::PositiveNumber);
  command->add_option("--replicas", sides.replicas, "Of each scene, for revisions")
      ->check(CLI::Range(2, 32))
      ->capture_default_str();
  command->add_option("--claims", sides.claims, "Only these claims, separated by commas")
      ->delimiter(',')
      ->expected(1)
      ->type_name("CLAIM");
  command->add_option("--work", sides.work, "Folder for the trees, programs and stores of revisions")
      ->capture_default_str();
  command->add_flag("--rebuild", sides.rebuild, "Build, run and judge again, even where nothing differs");
  command->add_option("--reference", options->audit.reference, "Folder of scenes, claims and the baseline")
      ->capture_default_str();
  CLI::Option* write = command->add_flag("--write-baseline", options->write_baseline,
                                         "Instead: write reference/baseline.csv from a store of tier quick");
  CLI::Option* check = command->add_flag("--check-baseline", options->check_baseline,
                                         "Instead: is a store of tier quick that of the baseline?");
  CLI::Option* commit =
      command->add_flag("--check-commit", options->check_commit,
                        "Instead: does the last commit declare what its baseline shows? (77: cannot say)");
  write->excludes(check)->excludes(commit);
  check->excludes(commit);
  for (CLI::Option* instead : {write, check, commit}) instead->excludes(before)->excludes(after)->excludes(declare);
  command->add_option("--store", options->store, "The store of --write-baseline and --check-baseline")
      ->capture_default_str();
  command->footer(
      "A commit declares its class in a trailer 'Physics-Change: roundoff' (or same physics, new physics); without one "
      "it\n"
      "is bitwise.\n"
      "Examples:\n"
      "  gpf audit HEAD~1 . --declare roundoff             # what did I change?\n"
      "  gpf audit v1 v2 --replicas 16 --output audit.md   # 16 replicas see smaller shifts than 8\n"
      "  gpf audit records-gcc records-clang               # two folders that gpf validate filled\n"
      "  gpf audit --write-baseline --store records\n");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace gpf
