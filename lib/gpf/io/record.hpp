// The record of a run: what was simulated, by which program, and every sum that was measured.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gpf/event/engine_state.hpp"
#include "gpf/measure/history.hpp"
#include "gpf/measure/named_array.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// A finished run. In the file: /scene (texts), /tallies (names, sums [blocks][tallies]), /history, /arrays,
/// /snapshots, /final (states), /provenance (JSON), attributes of "/" for the rest, and /session for what differs
/// between equal runs.
struct Record {
  std::string scene_text;  ///< the scene file as read
  Scene scene;
  Run run;

  int physics_version = 0;
  std::uint64_t trace_hash = 0;
  double time = 0;  ///< end of the run
  double epoch_length = 0;
  double deepest_overlap = 0;  ///< a length
  EventCounts counts;          ///< of the whole run, start-up included

  std::size_t blocks = 0;
  std::vector<double> sums;  ///< blocks x tallies, row-major; layout TallyLayout(run)
  NamedArrays arrays;        ///< what run.detail asks for; see Measurement::arrays()
  History history;
  std::vector<Snapshot> snapshots;  ///< one for each of run.snapshots
  State final_state;

  std::string build;    ///< JSON of BuildProvenance
  std::string session;  ///< JSON of SessionProvenance, with "wall_seconds" and "cpu_seconds"
  double wall_seconds = 0, cpu_seconds = 0;
};

/// [scene] and [run] tables that parse_scene reads back to the same bits.
std::string canonical_text(const Scene& scene, const Run& run);

/// Name of the record of a run: hash of canonical_text and the physics version, sixteen hexadecimal digits.
std::string record_name(const Scene& scene, const Run& run);

/// Written atomically. Throws StorageError.
void write_record(const Record& record, const std::filesystem::path& path);

/// Throws StorageError when it cannot be read, InputError when it is damaged, incomplete or of another format.
Record read_record(const std::filesystem::path& path);

/// Means and errors of everything that the record measured.
MeasuredQuantities quantities_of(const Record& record);

}  // namespace gpf
