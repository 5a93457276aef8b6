#include "gpf/io/hdf5_seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"

namespace gpf::hdf5 {
namespace {

constexpr std::string_view first_line = "gpf HDF5 file, sealed; format 1\n";

/// Takes eight bytes at a time, each word by a step that is one-to-one both in the word and in the state: a change
/// within one word always changes the result.
std::uint64_t checksum(std::string_view content) {
  std::uint64_t state = 0x9e3779b97f4a7c15u;  // not zero, which zeros would leave at zero
  while (!content.empty()) {
    const std::size_t bytes = std::min(sizeof(std::uint64_t), content.size());
    std::uint64_t word = 0;
    std::memcpy(&word, content.data(), bytes);
    state = mix(state ^ word);
    content.remove_prefix(bytes);
  }
  return state;
}

}  // namespace

std::string seal(std::string_view content) {
  std::string block = fmt::format("{}length of the rest {}\nchecksum of the rest {}\n", first_line, content.size(),
                                  hexadecimal(checksum(content)));
  block.resize(seal_size, '\0');
  return block;
}

void check_seal(std::string_view file, const std::filesystem::path& path) {
  const std::string problem = "cannot use " + path.string();
  const char* const remedy = "restore it from a copy, or delete it and run again";
  if (file.empty()) throw InputError(problem, "the file is empty", remedy);
  if (file.substr(0, first_line.size()) != first_line.substr(0, file.size())) {
    throw InputError(problem, "not a file that this version of gpf wrote, or its beginning is damaged",
                     "name a record or checkpoint written by gpf, or restore it from a copy");
  }
  if (file.size() < seal_size || file.substr(0, seal_size) != seal(file.substr(seal_size))) {
    throw InputError(problem, "truncated or damaged: its content does not match its checksum", remedy);
  }
}

}  // namespace gpf::hdf5
