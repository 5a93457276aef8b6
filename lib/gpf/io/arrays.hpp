// The arrays of a measurement in an HDF5 file: /arrays/<name>.
#pragma once

#include "gpf/io/hdf5.hpp"
#include "gpf/measure/named_array.hpp"
#include "gpf/scene/scene.hpp"

namespace gpf {

void write_arrays(Hdf5Writer& file, const NamedArrays& arrays);

/// Those that a run of that detail has. Throws InputError when one is missing or has another shape.
NamedArrays read_arrays(const Hdf5Reader& file, const Scene& scene, const Run& run);

}  // namespace gpf
