// From a scene to its record: the engine, watched, with checkpoints on the way.
#pragma once

#include <csignal>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gpf/io/record.hpp"
#include "gpf/scene/scene_file.hpp"

namespace gpf {

/// How far a run is.
struct Progress {
  double fraction;               ///< of the whole run, start-up included
  double time;                   ///< simulated
  std::uint64_t collisions;      ///< pair contacts
  double collisions_per_second;  ///< since the program started
  double seconds_left;
};

struct SimulationOptions {
  std::optional<std::filesystem::path> checkpoint;   ///< where to keep one; empty: none
  double checkpoint_period = 60;                     ///< seconds
  bool resume = false;                               ///< go on from the checkpoint if it exists
  const volatile std::sig_atomic_t* stop = nullptr;  ///< set: write a checkpoint and stop
  std::function<void(const Progress&)> progress;     ///< called about five times a second
  std::vector<std::string> command;                  ///< for the record's provenance
};

/// Runs a scene to its end and returns the record; nothing when it was stopped (the checkpoint is then on disk).
/// The checkpoint is left in place: remove it once the record is written.
/// Throws PhysicsError, StorageError and what read_checkpoint throws.
std::optional<Record> simulate(const SceneFile& file, const SimulationOptions& options = {});

}  // namespace gpf
