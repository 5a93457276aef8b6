#include "verify/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "gpf/base/error.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/planner.hpp"
#include "verify/verdict_file.hpp"

namespace gpf {
namespace {

std::set<std::string> required_ids(const std::filesystem::path& list) {
  std::set<std::string> ids;
  std::istringstream lines(read_text(list));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string id; words >> id;) ids.insert(id);
  }
  return ids;
}

class Gate {
 public:
  explicit Gate(const GateOptions& options)
      : options_(options),
        store_(options.store, trust_in(options.tier), [this](const std::string& line) { findings_.push_back(line); }),
        scenes_(options.reference) {}

  std::vector<std::string> findings() {
    const std::vector<Claim> claims = load_claims(options_.reference / "claims");
    std::set<std::string> missing = required_ids(options_.reference / "claims" / "required.txt");
    for (const Claim& claim : claims) {
      if (missing.erase(claim.id) == 0)
        add("claim {} is not listed in required.txt: add it, so that its loss would be noticed", claim.id);
      if (claim.judged_in(options_.tier)) check(claim);
    }
    for (const std::string& id : missing) add("claim {} is required but has no file", id);
    return std::move(findings_);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    findings_.push_back(fmt::format(format, std::forward<Values>(values)...));
  }

  void check(const Claim& claim) {
    if (!std::filesystem::exists(verdict_path(options_.store, options_.tier, claim.id)))
      return add("claim {} has no verdict: gpf validate {}", claim.id, claim.id);
    Verdict verdict;
    try {
      verdict = read_verdict(options_.store, options_.tier, claim.id);
    } catch (const Error& error) {
      return add("claim {}: {}", claim.id, error.what());
    }
    if (!agrees(verdict.outcome, claim.expected))
      add("claim {}: {}, expected {}: {}", claim.id, name_of(verdict.outcome), name_of(claim.expected),
          verdict.summary);
    if (const std::string why = staleness(claim, verdict); !why.empty())
      add("claim {}: its verdict is stale, {}: gpf validate {}", claim.id, why, claim.id);
  }

  std::string staleness(const Claim& claim, const Verdict& verdict) {
    if (verdict.claim_hash != claim.text_hash) return "the claim file has changed";
    if (verdict.physics_version != physics_version) return "it was made with another physics version";
    if (options_.program_hash != 0 && verdict.program_hash != options_.program_hash)
      return "another build of the program made it";
    std::vector<std::string> names;
    for (const std::string& name : claim.scenes_in(options_.tier))
      for (const NamedScene& scene : scenes_.of(name))
        for (int replica = 0; replica < verdict.replicas; ++replica) {
          const SceneFile file = replica_of(scene, replica, verdict.release_seed);
          names.push_back(record_name(file.scene, file.run));
          const auto [checked, is_new] = readable_.try_emplace(names.back());
          if (is_new) checked->second = store_.load(file).has_value();
          if (!checked->second) return fmt::format("the record of {} #{} is gone or damaged", scene.name, replica + 1);
        }
    return names == verdict.records ? "" : "its scenes have changed";
  }

  const GateOptions& options_;
  std::vector<std::string> findings_;
  RecordStore store_;
  SceneLibrary scenes_;
  std::map<std::string, bool> readable_;  // by the name of a record that has been looked at
};

}  // namespace

std::vector<std::string> gate_findings(const GateOptions& options) { return Gate(options).findings(); }

}  // namespace gpf
