// States as extended XYZ, which OVITO and ASE read.
#pragma once

#include <filesystem>
#include <functional>

#include "verify/export/states.hpp"

namespace gpf {

/// Writes the states one after the other, atomically. Each is a line with the number of disks, a line with Lattice
/// (L, W and one diameter), pbc, Properties and Time, and for each disk in order: X (no element), position with z = 0,
/// velocity, radius; numbers read back to the same bits. `shown` is told how many states are done. Throws
/// StorageError, and what ExportedStates::show_all throws.
void write_xyz(const ExportedStates& states, const std::filesystem::path& path, const std::function<void(int)>& shown);

}  // namespace gpf
