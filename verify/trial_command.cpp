// gpf trial: do the judge, the audit and the seeds err as rarely as they say?
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/commands.hpp"
#include "verify/estimators/scene_values.hpp"
#include "verify/trial/seed_trial.hpp"
#include "verify/trial/trial_page.hpp"
#include "verify/writable.hpp"

namespace gpf {
namespace {

Trial run_trial(bool quick) {
  const double before = process_cpu_seconds();
  Trial trial{.judge = {}, .audit = {}, .seeds = {}, .cpu_seconds = 0, .quick = quick};
  fmt::print(stderr, "gpf: judging claims of known truth\n");
  trial.judge = try_judge(quick ? 2000 : 20000);
  const int audits = quick ? 60 : 600;
  fmt::print(stderr, "gpf: {} audits of unchanged physics\n", audits);
  const TrialRuns runs = run_trial_scenes(2 * replicas_a_side * audits);
  trial.audit = try_audits(runs);
  fmt::print(stderr, "gpf: correlating replicas\n");
  trial.seeds = try_seeds(runs, quick ? 100000 : 1000000, quick ? 500 : 5000);
  trial.cpu_seconds = process_cpu_seconds() - before;
  return trial;
}

}  // namespace

void add_trial_command(CLI::App& app, int& status) {
  struct Options {
    std::filesystem::path output = "reports";
    bool quick = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "trial", "Put the judge on trial: measured error rates of judge, audit and seeds against the stated ones");
  command->add_option("-o,--output", options->output, "Folder for the page")->capture_default_str();
  command->add_flag("--quick", options->quick, "A tenth of the claims, audits and seeds");
  command->footer(
      "Exit status 1 when a rate lies outside of what is stated by more than sampling error.\n\n"
      "Examples:\n  gpf trial\n  gpf trial --quick --output trial\n");
  command->callback([options, &status] {
    require_writable_folder(options->output);  // before minutes of work
    const Trial trial = run_trial(options->quick);
    write_trial_page(trial, options->output);
    for (const TrialResult& r : trial.outside())
      fmt::print(stderr, "gpf: outside of what is stated: {}: {}, stated {}\n", r.what, r.measured, r.stated);
    fmt::print("{}\n", (options->output / "trial.md").string());
    status = static_cast<int>(trial.outside().empty() ? ExitStatus::success : ExitStatus::red);
  });
}

}  // namespace gpf
