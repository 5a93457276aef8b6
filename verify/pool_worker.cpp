#include "verify/pool_worker.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string_view>

#include "verify/file_lock.hpp"
#include "verify/out_of_memory.hpp"

namespace gpf {
namespace {

/// A line to the parent; that it has gone away is no reason to stop computing.
void tell(int report, std::string line) {
  std::replace(line.begin(), line.end(), '\n', ' ');
  line += '\n';
  std::string_view left = line;
  while (!left.empty()) {
    const ssize_t written = ::write(report, left.data(), left.size());
    if (written <= 0) return;
    left.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::optional<Record> simulate_or_resume(const SceneFile& file, const RunFunction& run, SimulationOptions options) {
  try {
    return run(file, options);
  } catch (const InputError&) {
    if (!std::filesystem::exists(*options.checkpoint)) throw;
    std::filesystem::remove(*options.checkpoint);  // damaged, or of another version
    return run(file, options);
  }
}

std::filesystem::path checkpoint_of(const std::filesystem::path& record) { return record.string() + ".checkpoint"; }

/// A worker killed while it wrote a checkpoint leaves a .part of it as well. In a folder that is read only it stays.
void remove_checkpoint(const std::filesystem::path& checkpoint) {
  std::error_code kept;
  std::filesystem::remove(checkpoint, kept);
  std::filesystem::remove(checkpoint.string() + ".part", kept);
}

ExitStatus do_job(const RecordStore& store, const RunJob& job, const PoolOptions& options, int report) {
  const std::filesystem::path place = store.path(job.file);
  auto lock = FileLock::wait(place.string() + ".lock", options.stop);
  if (!lock) {
    tell(report, "stopped");
    return ExitStatus::interrupted;
  }
  if (is_done(store, job.file)) {
    tell(report, "found");
    return ExitStatus::success;
  }
  SimulationOptions simulation;
  simulation.checkpoint = checkpoint_of(place);
  simulation.checkpoint_period = options.checkpoint_period;
  simulation.resume = true;
  simulation.stop = options.stop;
  simulation.progress = [report](const Progress& p) { tell(report, fmt::format("progress {}", p.fraction)); };
  simulation.command = options.command;
  const std::optional<Record> record = simulate_or_resume(job.file, options.run, simulation);
  if (!record) {
    tell(report, "stopped");
    return ExitStatus::interrupted;
  }
  store.save(job.file, *record);
  remove_checkpoint(*simulation.checkpoint);
  tell(report, fmt::format("done {} {}", record->cpu_seconds, record->counts.pair_contacts));
  return ExitStatus::success;
}

}  // namespace

bool is_done(const RecordStore& store, const SceneFile& file) {
  if (!store.load(file)) return false;
  remove_checkpoint(checkpoint_of(store.path(file)));
  return true;
}

void work(const RecordStore& store, const RunJob& job, const PoolOptions& options, int report) {
  ExitStatus status = ExitStatus::physics;
  try {
    status = do_job(store, job, options, report);
  } catch (const Error& error) {
    tell(report, fmt::format("failed {}", error.what()));
    status = error.status();
  } catch (const std::bad_alloc&) {
    const StorageError error = out_of_memory();
    tell(report, fmt::format("failed {}", error.what()));
    status = error.status();
  } catch (const std::exception& error) {
    tell(report, fmt::format("failed {}", error.what()));
  }
  ::_exit(static_cast<int>(status));  // not exit(): what the parent has buffered is the parent's to write
}

}  // namespace gpf
