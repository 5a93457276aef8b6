// What must hold for all bytes, sealed as a record's are, so that they reach HDF5: read_record gives a record or throws
// an error that can be acted upon; a record that it gives has its size, and can be evaluated.
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>

#include "fuzz/check.hpp"
#include "fuzz/memory_file.hpp"
#include "gpf/io/hdf5_seal.hpp"
#include "gpf/io/record.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string content(data, data + size);
  const gpf::fuzz::MemoryFile file(gpf::hdf5::seal(content) + content);
  try {
    const gpf::Record record = gpf::read_record(file.path());
    gpf::fuzz::require(record.final_state.position.size() == static_cast<std::size_t>(record.scene.particles),
                       "a state of another size");
    static_cast<void>(gpf::quantities_of(record));
  } catch (const gpf::Error& error) {
    gpf::fuzz::require_usable(error, "");
  } catch (const std::bad_alloc&) {  // HDF5 asks for as much as a file claims to need
  }
  return 0;
}
