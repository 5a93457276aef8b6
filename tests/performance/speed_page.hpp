// What the benchmark measured, as a page beside other codes.
#pragma once

#include <filesystem>
#include <vector>

#include "gpf/scene/scene.hpp"

namespace gpf::performance {

/// One scene; times in nanoseconds of CPU time per pair collision.
struct SpeedRow {
  Scene scene;
  double best, median, heap_best;
  double crossings;  ///< per collision
  double bytes;      ///< per disk, of the engine in motion
  double calibration;
};

/// Writes speed.md, speed.csv and speed.svg into the folder. Throws StorageError.
void write_speed_page(const std::vector<SpeedRow>& rows, int repeats, const std::filesystem::path& folder);

}  // namespace gpf::performance
