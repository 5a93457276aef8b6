#include "verify/audit/environment.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace gpf {
namespace {

using Facts = std::map<std::string, std::set<std::string>>;

std::string text_of(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : value.is_null() ? "unknown" : value.dump();
}

void add_facts(Facts& facts, const std::string& text, const std::vector<std::string>& wanted) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return;
  for (const std::string& name : wanted)
    if (json.contains(name)) facts[name].insert(text_of(json[name]));
  if (json.contains("libraries") && json["libraries"].is_object())
    for (const auto& [library, version] : json["libraries"].items())
      facts[fmt::format("library {}", library)].insert(text_of(version));
}

Facts facts_of(const EvidenceSet& side) {
  Facts facts;
  for (const auto& [key, run] : side.runs) {
    add_facts(facts, run.build, {"version", "commit", "dirty", "compiler", "flags"});
    add_facts(facts, run.session, {"cpu", "system"});
  }
  return facts;
}

}  // namespace

std::vector<EnvironmentFact> environment_of(const EvidenceSet& before, const EvidenceSet& after) {
  const Facts a = facts_of(before), b = facts_of(after);
  std::set<std::string> names;
  for (const Facts* facts : {&a, &b})
    for (const auto& [name, values] : *facts) names.insert(name);
  const auto said = [](const Facts& facts, const std::string& name) {
    const auto found = facts.find(name);
    return found == facts.end() ? "-" : fmt::format("{}", fmt::join(found->second, "; "));
  };
  std::vector<EnvironmentFact> result;
  for (const std::string& name : names) result.push_back({name, said(a, name), said(b, name)});
  return result;
}

}  // namespace gpf
