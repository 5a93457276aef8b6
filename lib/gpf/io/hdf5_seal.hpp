// The first 512 bytes of our HDF5 files: length and checksum of the rest, so that damage is found before HDF5 reads.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace gpf::hdf5 {

/// HDF5's smallest user block.
inline constexpr std::size_t seal_size = 512;

/// The seal of a file whose bytes after the seal are `content`: three readable lines, padded with NUL.
std::string seal(std::string_view content);

/// Checks a whole file. Every change of a single byte is found with certainty, others with probability 1 - 2^-64.
/// The seal guards against accidents, not against someone who computes it anew.
/// @throws InputError that names `path` when the file is foreign, incomplete or damaged.
void check_seal(std::string_view file, const std::filesystem::path& path);

}  // namespace gpf::hdf5
