// A run stopped on the way: enough to go on to the same bits and the same record.
#pragma once

#include <filesystem>

#include "gpf/event/engine_state.hpp"
#include "gpf/measure/history.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

struct Checkpoint {
  EngineState engine;
  Measurement::Memory measurement;
  History history;
  std::vector<Snapshot> snapshots;      ///< as far as the run has come
  std::uint64_t samples = 0;            ///< sample intervals completed since the start of the run
  std::uint64_t contacts_at_begin = 0;  ///< pair contacts before measurement began
  double deepest_overlap = 0;
  double wall_seconds = 0, cpu_seconds = 0;  ///< spent so far
};

/// Written atomically. Throws StorageError.
void write_checkpoint(const Scene& scene, const Run& run, const Checkpoint& checkpoint,
                      const std::filesystem::path& path);

/// Throws InputError when it is damaged or was written for another scene, run or physics version.
Checkpoint read_checkpoint(const Scene& scene, const Run& run, const std::filesystem::path& path);

}  // namespace gpf
