#include "verify/report_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "gpf/base/error.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/io/record.hpp"
#include "verify/command_text.hpp"
#include "verify/planner.hpp"
#include "verify/verdict_file.hpp"

namespace gpf {
namespace {

std::string validate_command(Tier tier) { return fmt::format("gpf validate --tier {}", name_of(tier)); }

Verdict verdict_of(const Claim& claim, Tier tier, const std::filesystem::path& store, SceneLibrary& scenes) {
  Verdict verdict = read_verdict(store, tier, claim.id);
  const auto stale = [&](std::string_view why) {
    return InputError(fmt::format("the verdict on claim '{}' is stale", claim.id), std::string(why),
                      fmt::format("{} {}", validate_command(tier), claim.id));
  };
  if (verdict.claim_hash != claim.text_hash) throw stale("the claim file has changed since");
  if (verdict.physics_version != physics_version) throw stale("it was made with another physics version");
  std::size_t runs = 0;
  for (const std::string& name : claim.scenes_in(tier))
    runs += scenes.count(name) * static_cast<std::size_t>(verdict.replicas);
  if (verdict.records.size() != runs) throw stale("it rests on other runs than the claim's scenes");
  return verdict;
}

/// The facts of a provenance text, which is a flat JSON object but for `libraries`.
void add_provenance(ReportData& data, const std::string& text, const std::filesystem::path& path) {
  ProvenanceFacts& facts = data.provenance;
  try {
    const auto json = nlohmann::json::parse(text);
    if (json.contains("utc_time")) data.dates.insert(json.at("utc_time").get<std::string>().substr(0, 10));
    for (const char* key : {"version", "compiler", "flags", "cpu", "system"})
      if (json.contains(key)) facts[key].insert(json.at(key).get<std::string>());
    if (json.contains("commit")) {
      const auto& dirty = json.at("dirty");
      facts["commit"].insert(json.at("commit").get<std::string>() +
                             (dirty.is_boolean() && dirty.get<bool>() ? " with local changes" : ""));
    }
    if (json.contains("libraries")) {
      std::string list;
      for (const auto& [name, version] : json.at("libraries").items())
        list += fmt::format("{}{} {}", list.empty() ? "" : ", ", name, version.get<std::string>());
      facts["libraries"].insert(list);
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("the provenance in '{}' cannot be read", path.string()), error.what(),
                     "delete the file and validate again");
  }
}

/// Errata of the source; each claim that they name must have a file.
std::vector<Erratum> errata_of(const std::filesystem::path& reference, const std::vector<Claim>& claims) {
  const std::filesystem::path path = reference / "errata.toml";
  if (!std::filesystem::exists(path)) return {};
  std::vector<Erratum> errata = load_errata(path);
  for (const Erratum& erratum : errata)
    for (const std::string& id : erratum.claims)
      if (std::none_of(claims.begin(), claims.end(), [&](const Claim& c) { return c.id == id; }))
        throw InputError(fmt::format("{}: erratum '{}' names claim '{}'", path.string(), erratum.id, id),
                         "there is no such claim file", "correct its claims");
  return errata;
}

class Loader {
 public:
  Loader(Tier tier, const std::filesystem::path& store, const std::filesystem::path& reference)
      : store_(store), scenes_(reference) {
    data_.tier = tier;
  }

  void add(Claim claim) {
    Verdict verdict = verdict_of(claim, data_.tier, store_, scenes_);
    data_.cpu_seconds += verdict.cpu_seconds;
    std::size_t next = 0;  // a verdict names its records scene by scene, as the claim lists them
    for (const std::string& scene : claim.scenes_in(data_.tier)) {
      SceneCost& cost = data_.scenes[scene];
      if (cost.claims.empty() || cost.claims.back() != claim.id) cost.claims.push_back(claim.id);
      for (std::size_t run_left = scenes_.count(scene) * static_cast<std::size_t>(verdict.replicas); run_left > 0;
           --run_left) {
        const std::string& name = verdict.records.at(next++);
        const RunCost& run = run_of(name, claim.id);
        data_.cpu_seconds -= run.cpu_seconds;
        if (!cost.records.insert(name).second) continue;
        cost.collisions += run.collisions;
        cost.cpu_seconds += run.cpu_seconds;
      }
    }
    data_.claims.push_back({std::move(claim), std::move(verdict)});
  }

  ReportData finish() && {
    for (const auto& [name, run] : runs_) {
      data_.collisions += run.collisions;
      data_.cpu_seconds += run.cpu_seconds;
    }
    data_.runs = runs_.size();
    return std::move(data_);
  }

 private:
  struct RunCost {
    std::uint64_t collisions;
    double cpu_seconds;
  };

  const RunCost& run_of(const std::string& name, const std::string& claim) {
    if (const auto found = runs_.find(name); found != runs_.end()) return found->second;
    const std::filesystem::path path = store_ / (name + ".h5");
    if (!std::filesystem::exists(path))
      throw InputError(fmt::format("the record '{}' is gone", path.string()),
                       fmt::format("the verdict on claim '{}' rests on it", claim), validate_command(data_.tier));
    const Record record = read_record(path);
    for (const std::string& text : {record.build, record.session}) add_provenance(data_, text, path);
    return runs_.emplace(name, RunCost{record.counts.pair_contacts, record.cpu_seconds}).first->second;
  }

  std::filesystem::path store_;
  SceneLibrary scenes_;
  ReportData data_;
  std::map<std::string, RunCost> runs_;
};

}  // namespace

ReportData load_report_data(Tier tier, const std::filesystem::path& store, const std::filesystem::path& reference,
                            const std::vector<std::string>& chosen) {
  std::vector<Claim> claims = load_claims(reference / "claims");
  std::vector<Erratum> errata = errata_of(reference, claims);
  std::erase_if(claims, [tier](const Claim& c) { return !c.judged_in(tier); });
  const std::size_t of_claims = claims.size();
  for (const std::string& id : chosen)
    if (std::none_of(claims.begin(), claims.end(), [&](const Claim& c) { return c.id == id; }))
      throw InputError(fmt::format("claim '{}' is not part of tier {}", id, name_of(tier)),
                       "there is no such claim, or it has no scenes there", "see reference/claims/");
  std::vector<Claim> others;
  if (!chosen.empty()) {
    const auto first_other = std::stable_partition(claims.begin(), claims.end(), [&](const Claim& c) {
      return std::find(chosen.begin(), chosen.end(), c.id) != chosen.end();
    });
    others.assign(std::make_move_iterator(first_other), std::make_move_iterator(claims.end()));
    claims.erase(first_other, claims.end());
  }
  std::vector<std::string> missing;
  for (const Claim& claim : claims)
    if (!std::filesystem::exists(verdict_path(store, tier, claim.id))) missing.push_back(claim.id);
  if (claims.empty())
    throw InputError(fmt::format("nothing to report in tier {}", name_of(tier)), "no claim is judged in it",
                     "choose a higher --tier");
  if (!missing.empty())
    throw InputError(fmt::format("{} of {} claims have no verdict in '{}'", missing.size(), claims.size(),
                                 verdict_path(store, tier, "").parent_path().string()),
                     fmt::format("{}", fmt::join(missing, ", ")), validate_command(tier));
  Loader loader(tier, store, reference);
  for (Claim& claim : claims) loader.add(std::move(claim));
  ReportData data = std::move(loader).finish();
  data.errata = std::move(errata);
  data.of_claims = of_claims;
  data.others = std::move(others);
  data.folders = folder_options(reference, store);
  return data;
}

}  // namespace gpf
