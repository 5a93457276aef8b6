// What must hold for every text: parse_claim gives a claim or throws an InputError that can be acted upon, and what a
// claim gives is sound: its names are names of files in one folder, its numbers are finite, its texts have one line.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/check.hpp"
#include "verify/claim.hpp"

namespace {

using gpf::fuzz::require;

constexpr std::string_view file = "folder/fuzz.toml";

bool is_file_name(std::string_view name) {
  return !name.empty() && name.front() != '.' &&
         name.find_first_of(std::string_view("/\\\n\0", 4)) == std::string_view::npos &&
         name.find("..") == std::string_view::npos;
}

void check_sound(const gpf::Claim& claim) {
  require(claim.id == "fuzz", "another id than the name of the file");
  require(claim.chapter >= 1, "a chapter below 1");
  require(std::isfinite(claim.tolerance_total()) && claim.tolerance_total() >= 0, "a tolerance that is no number");
  for (const auto& [name, value] : claim.parameters) require(std::isfinite(value), "a parameter that is not finite");
  for (const gpf::Tier tier : {gpf::Tier::quick, gpf::Tier::standard, gpf::Tier::full}) {
    for (const std::string& scene : claim.scenes_in(tier)) require(is_file_name(scene), "a scene in another folder");
    require(claim.replicas_in(tier) >= 1, "no replicas");
    require(claim.scenes.empty() || !claim.judged_in(tier) || !claim.scenes_in(tier).empty(), "judged without scenes");
  }
  for (const std::string* text : {&claim.title, &claim.source, &claim.statement, &claim.method, &claim.estimator})
    require(!text->empty() && text->find('\n') == std::string::npos, "an empty text, or one of two lines");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    check_sound(gpf::parse_claim(text, file));
  } catch (const gpf::InputError& error) {
    gpf::fuzz::require_usable(error, file);
  }
  return 0;
}
