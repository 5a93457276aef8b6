#include "verify/audit/physics_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 4> names{"bitwise", "roundoff", "same physics", "new physics"};

}  // namespace

std::string_view name_of(PhysicsChange change) { return names.at(static_cast<std::size_t>(change)); }

PhysicsChange physics_change_named(std::string_view name) {
  std::string plain;
  for (const char c : name)
    plain += c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (plain == "round off") plain = "roundoff";
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names.at(k) == plain) return static_cast<PhysicsChange>(k);
  throw InputError(fmt::format("unknown class of change '{}'", name),
                   fmt::format("there are {}", fmt::join(names, ", ")), "declare one of these");
}

PhysicsChange strongest_declared(std::string_view trailers) {
  PhysicsChange strongest = PhysicsChange::bitwise;
  std::istringstream lines{std::string(trailers)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(" \t\r"), end = line.find_last_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    strongest = std::max(strongest, physics_change_named(line.substr(begin, end - begin + 1)));
  }
  return strongest;
}

}  // namespace gpf
