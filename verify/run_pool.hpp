// A pool of processes that runs what is missing and puts the records into the store.
#pragma once

#include <csignal>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/scene/scene_file.hpp"
#include "verify/simulate.hpp"
#include "verify/store.hpp"

namespace gpf {

/// A run to do: a replica and what to call it in messages.
struct RunJob {
  SceneFile file;
  std::string label;
};

/// simulate(), or what stands in for it in tests.
using RunFunction = std::function<std::optional<Record>(const SceneFile&, const SimulationOptions&)>;

struct PoolOptions {
  int jobs = 1;                                      ///< processes at a time
  double checkpoint_period = 60;                     ///< seconds
  const volatile std::sig_atomic_t* stop = nullptr;  ///< set: let the runs write checkpoints, and return
  RunFunction run = simulate;
  std::vector<std::string> command;  ///< for the records' provenance
};

struct RunFailure {
  std::string label, what;
  ExitStatus status;
};

struct PoolResult {
  std::vector<RunFailure> failures;
  bool stopped = false;
};

/// Runs the jobs in their order, each in a process of its own (forked, so the caller must have no other thread): a
/// crash costs one run. A record is renamed into the store when it is complete, and its checkpoint removed; a run that
/// finds a checkpoint goes on from it, or starts anew when the checkpoint cannot be used. A lock beside the record
/// keeps two processes from computing the same run: the second waits and finds the record done. If this process dies
/// its runs write checkpoints and stop.
/// On standard error: on a terminal what is running and the time left, anywhere one line for each run that ended.
/// A run that fails is reported in the result and does not stop the others. Throws StorageError when no process can be
/// started.
PoolResult run_pool(const RecordStore& store, const std::vector<RunJob>& jobs, const PoolOptions& options);

/// Whether the record of a run is there. Then its checkpoint, which a worker that was killed between its last two steps
/// has left, is removed.
bool is_done(const RecordStore& store, const SceneFile& file);

/// Rough number of collisions of a run, by Enskog's rate at the start's temperature: for ordering runs.
double expected_collisions(const SceneFile& file);

}  // namespace gpf
