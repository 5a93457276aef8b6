// What the source prints wrongly, and what it must read: reference/errata.toml.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gpf {

struct Erratum {
  std::string id;                   ///< never changes: "eq2.7", "fig5.3"
  std::string place;                ///< equation, figure, section
  std::string printed, correct;     ///< what stands there, and what it must read
  std::string evidence;             ///< why: a computation, or another place of the source
  std::vector<std::string> claims;  ///< ids of claims that test it; may be empty
};

/// In the order of the file. Strict: a missing, unknown or empty key, an id that is given twice or cannot be a link,
/// and a file without errata are errors with file and line. Throws InputError.
std::vector<Erratum> parse_errata(std::string_view text, std::string_view name);
/// parse_errata of a file. Throws InputError, StorageError.
std::vector<Erratum> load_errata(const std::filesystem::path& path);

}  // namespace gpf
