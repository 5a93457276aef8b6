// States in an HDF5 file: the last one of a run, and the snapshots on the way.
#pragma once

#include <string>
#include <vector>

#include "gpf/io/hdf5.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// <group>/position and <group>/velocity, [disks][2].
void write_state(Hdf5Writer& file, const std::string& group, const State& state);

/// Throws InputError when it is not one of that many disks.
State read_state(const Hdf5Reader& file, const std::string& group, std::size_t disks);

/// /snapshots/time, [snapshots], and /snapshots/position and /snapshots/velocity, [snapshots][disks][2].
void write_snapshots(Hdf5Writer& file, const std::vector<Snapshot>& snapshots, std::size_t disks);

/// The first of those that the run asks for, as far as they are there. Throws InputError when their shapes differ, or a
/// time is not that of the sample nearest to the one asked for.
std::vector<Snapshot> read_snapshots(const Hdf5Reader& file, std::size_t disks, const Run& run);

}  // namespace gpf
