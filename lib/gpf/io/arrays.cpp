#include "gpf/io/arrays.hpp"

#include <algorithm>

#include "gpf/base/error.hpp"
#include "gpf/measure/measurement.hpp"

namespace gpf {

void write_arrays(Hdf5Writer& file, const NamedArrays& arrays) {
  for (const NamedArray& array : arrays)
    file.write("/arrays/" + array.name, array.values, Dims(array.shape.begin(), array.shape.end()));
}

NamedArrays read_arrays(const Hdf5Reader& file, const Scene& scene, const Run& run) {
  NamedArrays arrays = Measurement(scene, run).arrays();
  for (NamedArray& array : arrays) {
    auto read = file.doubles("/arrays/" + array.name);
    if (!std::equal(read.dims.begin(), read.dims.end(), array.shape.begin(), array.shape.end()))
      throw InputError("the array " + array.name + " of a record or checkpoint has another shape than its run",
                       "it was written by another version of gpf", "delete the file and run the scene again");
    array.values = std::move(read.values);
  }
  return arrays;
}

}  // namespace gpf
