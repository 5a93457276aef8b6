// gpf run: one scene to one record.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/flow/range.hpp"
#include "gpf/io/record.hpp"
#include "gpf/scene/scene_file.hpp"
#include "verify/commands.hpp"
#include "verify/duration_text.hpp"
#include "verify/file_lock.hpp"
#include "verify/run_json.hpp"
#include "verify/simulate.hpp"
#include "verify/stop_signals.hpp"

namespace gpf {

namespace {

/// One process per record: a lock beside it.
FileLock lock_of(const std::filesystem::path& output) {
  auto lock = FileLock::attempt(output.string() + ".lock");
  if (!lock)
    throw StorageError(fmt::format("another process is writing '{}'", output.string()), "its lock is held",
                       "wait for it, or choose another output");
  return std::move(*lock);
}

struct RunOptions {
  std::string scene, output;
  bool json = false, resume = false, force = false;
  double checkpoint_period = 60;
};

void show_progress(const Progress& p) {
  fmt::print(stderr, "\r\033[K{:5.1f} %  time {:.4g}  {:.3g} collisions, {:.3g}/s  {} left", 100 * p.fraction, p.time,
             static_cast<double>(p.collisions), std::max(0.0, p.collisions_per_second), duration_text(p.seconds_left));
  std::fflush(stderr);
}

void summarise(const Record& record, const std::string& output) {
  fmt::print("{}: {} collisions to time {:.6g} in {:.3g} s ({:.3g}/s), trace hash {}\n", output,
             record.counts.pair_contacts, record.time, record.wall_seconds,
             static_cast<double>(record.counts.pair_contacts) / record.wall_seconds, hexadecimal(record.trace_hash));
}

/// What a run that is done, or a process that was killed on its way, leaves beside the record.
void tidy(const std::filesystem::path& output, const std::filesystem::path& checkpoint) {
  for (const auto& file : {checkpoint.string(), checkpoint.string() + ".part", output.string() + ".part"})
    std::filesystem::remove(file);
}

int run(const RunOptions& options, std::vector<std::string> command) {
  const SceneFile file = load_scene(options.scene);
  const std::filesystem::path output = options.output, checkpoint = options.output + ".checkpoint";
  const FileLock lock = lock_of(output);
  const auto finish = [&](const Record& record) {
    if (options.json)
      fmt::print("{}\n", run_json(record));
    else
      summarise(record, options.output);
    return static_cast<int>(ExitStatus::success);
  };
  if (std::filesystem::exists(output) && !options.force) {
    if (!options.resume)
      throw InputError(fmt::format("'{}' exists", options.output), "a record is never overwritten unasked",
                       "choose another output, or --force to replace it");
    const Record record = read_record(output);
    if (canonical_text(record.scene, record.run) != canonical_text(file.scene, file.run))
      throw InputError(fmt::format("'{}' is the finished record of another scene", options.output),
                       "--resume goes on with the same scene, seed and run only", "choose another output");
    tidy(output, checkpoint);
    return finish(record);
  }
  if (std::filesystem::exists(checkpoint) && !options.resume && !options.force)
    throw InputError(fmt::format("'{}' exists", checkpoint.string()), "an earlier run was stopped on its way",
                     "--resume to go on with it, or --force to begin anew");

  for (const std::string& warning : range_warnings(file.scene, {})) fmt::print(stderr, "gpf: warning: {}\n", warning);
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  SimulationOptions simulation;
  simulation.checkpoint = checkpoint;
  simulation.checkpoint_period = options.checkpoint_period;
  simulation.resume = options.resume;
  simulation.stop = stop_on_signals();
  if (terminal) simulation.progress = show_progress;
  simulation.command = std::move(command);
  const std::optional<Record> record = simulate(file, simulation);
  if (terminal) fmt::print(stderr, "\r\033[K");
  if (!record) {
    fmt::print(stderr, "gpf: stopped by a signal; '{}' holds the run: the same command with --resume goes on\n",
               checkpoint.string());
    return static_cast<int>(ExitStatus::interrupted);
  }
  write_record(*record, output);
  tidy(output, checkpoint);
  return finish(*record);
}

}  // namespace

void add_run_command(CLI::App& app, int& status) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* run_app = app.add_subcommand("run", "Simulate a scene and write its record");
  run_app->add_option("scene", options->scene, "Scene file (TOML)")->required();
  run_app->add_option("-o,--output", options->output, "Record to write (HDF5)")->required();
  run_app->add_flag("--json", options->json, "Print one JSON object with every measured quantity to stdout");
  run_app->add_flag("--resume", options->resume, "Go on from the checkpoint of an earlier, interrupted run");
  run_app->add_flag("--force", options->force, "Replace an existing record or checkpoint");
  run_app->add_option("--checkpoint-period", options->checkpoint_period, "Seconds between checkpoints")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  run_app->footer("Keys of a scene file:\n" + scene_key_help() +
                  "\nStopped by SIGTERM, SIGINT, SIGUSR1 or SIGHUP it writes OUTPUT.checkpoint and exits with 75;\n"
                  "the same command with --resume then reaches the same bits as an undisturbed run.\n"
                  "Example:\n"
                  "  gpf run reference/scenes/channel-smooth-nu30.toml -o nu30.h5\n");
  run_app->callback([options, &status] {
    status = run(*options, {"gpf", "run", options->scene, "-o", options->output});
  });
}

}  // namespace gpf
