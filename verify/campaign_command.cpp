// gpf campaign: a scene varied along axes, run here or as a job array, and its phase diagram.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <thread>

#include "gpf/base/error.hpp"
#include "verify/campaign_run.hpp"
#include "verify/commands.hpp"
#include "verify/stop_signals.hpp"

namespace gpf {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  gpf campaign plan reference/campaigns/fig-5-8.toml -o fig-5-8\n"
    "  gpf campaign run fig-5-8 -j 2 --adaptive\n"
    "  gpf campaign missing fig-5-8\n"
    "  gpf campaign collect fig-5-8\n"
    "  sbatch --array=\"$(gpf campaign missing --array fig-5-8)\" fig-5-8/job.slurm\n";

std::filesystem::path this_program() {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path("gpf") : path;
}

/// The argument that names the folder.
void add_folder(CLI::App& command, std::filesystem::path& folder) {
  command.add_option("folder", folder, "Folder of the campaign, as planned")->required();
}

void add_plan(CLI::App& campaign, int& status) {
  struct Options {
    std::filesystem::path file;
    CampaignFolder output;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = campaign.add_subcommand(
      "plan", "Write the manifest of a campaign's runs; planned again after a change, it adds only what is new");
  command->add_option("campaign", options->file, "The campaign file")->required();
  command->add_option("-o,--output", options->output.folder, "Folder for manifest, records and results")->required();
  command->callback([options, &status] {
    plan_campaign(options->file, options->output, this_program());
    status = static_cast<int>(ExitStatus::success);
  });
}

void add_run(CLI::App& campaign, int& status) {
  struct Options : CampaignRunOptions {
    CampaignFolder place;
    std::size_t number = 0;
  };
  auto options = std::make_shared<Options>();
  options->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command = campaign.add_subcommand("run", "Do the runs that are missing; stopped, the same command goes on");
  add_folder(*command, options->place.folder);
  command->add_option("-j,--jobs", options->jobs, "Runs at a time (default: one for each processor)")
      ->check(CLI::PositiveNumber);
  CLI::Option* task = command->add_option("--task", options->number, "Only this entry of the manifest, from 0")
                          ->check(CLI::Range(0, 9999999));
  command->add_flag("--adaptive", options->adaptive, "Then add replicas where neighbouring points differ")
      ->excludes(task);
  command->add_option("--checkpoint-period", options->checkpoint_period, "Seconds between checkpoints of a run")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command->callback([options, task, &status] {
    if (task->count() > 0) options->task = options->number;
    options->stop = stop_on_signals();
    options->command = {"gpf", "campaign", "run"};
    status = run_campaign(options->place, *options);
  });
}

void add_missing(CLI::App& campaign, int& status) {
  struct Options {
    CampaignFolder place;
    bool array = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = campaign.add_subcommand(
      "missing", "Print the runs without a record: index, label, why; exit status 0 either way");
  add_folder(*command, options->place.folder);
  command->add_flag("--array", options->array, "Only the indices, as a batch system's --array wants them");
  command->callback([options, &status] {
    print_missing(options->place, options->array);
    status = static_cast<int>(ExitStatus::success);
  });
}

void add_collect(CLI::App& campaign, int& status) {
  auto place = std::make_shared<CampaignFolder>();
  CLI::App* command = campaign.add_subcommand(
      "collect", "Write the phase diagram of the runs that are done: phase.md, phase.csv, phase.svg, snapshots.md");
  add_folder(*command, place->folder);
  command->callback([place, &status] {
    fmt::print("{}\n", collect_campaign(*place).string());
    status = static_cast<int>(ExitStatus::success);
  });
}

}  // namespace

void add_campaign_command(CLI::App& app, int& status) {
  CLI::App* campaign = app.add_subcommand("campaign", "Vary a scene along axes and map the structures of the flow");
  campaign->require_subcommand(1);
  campaign->footer(examples);
  add_plan(*campaign, status);
  add_run(*campaign, status);
  add_missing(*campaign, status);
  add_collect(*campaign, status);
}

}  // namespace gpf
