#include "verify/version_text.hpp"

#include <fmt/format.h>

#include <CLI/Version.hpp>
#include <nlohmann/json.hpp>

#include "gpf/event/physics_version.hpp"
#include "gpf/io/provenance.hpp"

namespace gpf {
namespace {

BuildProvenance program_provenance() {
  BuildProvenance facts = build_provenance();
  facts.libraries["CLI11"] = CLI11_VERSION;
  return facts;
}

}  // namespace

std::string version_text() {
  const BuildProvenance facts = program_provenance();
  std::string text =
      fmt::format("gpf {}\ncommit: {}{}\nphysics version: {}\ncompiler: {}\nflags: {}", facts.version, facts.commit,
                  facts.dirty.value_or(false) ? ", and changes" : "", physics_version, facts.compiler, facts.flags);
  for (const auto& [name, version] : facts.libraries) text += fmt::format("\n{}: {}", name, version);
  return text;
}

std::string version_json() {
  auto json = nlohmann::ordered_json::parse(to_json(program_provenance()));
  json["physics_version"] = physics_version;
  return json.dump(2);
}

}  // namespace gpf
