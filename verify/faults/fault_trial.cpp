#include "verify/faults/fault_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/faults/faulty_simulation.hpp"
#include "verify/file_lock.hpp"
#include "verify/planner.hpp"
#include "verify/simulation_sources.hpp"
#include "verify/validate.hpp"

namespace gpf {
namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path folder(const Fault& fault, const FaultOptions& options) {
  return options.store / "faults" / folder_of(fault);
}
std::filesystem::path answers_file(const Fault& fault, double dose, const FaultOptions& options) {
  return folder(fault, options) / fmt::format("{}-{:.6g}.json", name_of(options.tier), dose);
}

Caught caught_named(const std::string& name) {
  for (const Caught caught : {Caught::no, Caught::undecided, Caught::health})
    if (name_of(caught) == name) return caught;
  return Caught::yes;
}

std::string sources() { return hexadecimal(mix(simulation_sources() ^ judging_sources())); }

/// What a claim is asked: its file, and the scenes that it reads.
std::uint64_t asked(const Claim& claim, Tier tier, SceneLibrary& scenes) {
  std::uint64_t hash = claim.text_hash;
  for (const std::string& name : claim.scenes_in(tier))
    for (const NamedScene& scene : scenes.of(name))
      hash = mix(hash ^ hash_text(canonical_text(scene.file.scene, scene.file.run)));
  return hash;
}

/// What the store knows; empty when it was found with other sources, or cannot be read.
FaultTrial known_answers(const Fault& fault, double dose, const FaultOptions& options) {
  const FaultTrial nothing{std::string(fault.name), dose, options.tier, {}};
  const std::filesystem::path path = answers_file(fault, dose, options);
  if (!std::filesystem::exists(path)) return nothing;
  try {
    const Json json = Json::parse(read_text(path));
    if (json.at("sources") != sources() || json.at("dose") != dose) return nothing;
    FaultTrial trial = nothing;
    for (const auto& [claim, answer] : json.at("claims").items())
      trial.claims[claim] = {caught_named(answer.at("caught")), answer.at("words"), answer.at("asked")};
    return trial;
  } catch (const Json::exception&) {
    return nothing;
  }
}

void keep_answers(const Fault& fault, const FaultTrial& trial, const FaultOptions& options) {
  Json json{{"fault", trial.fault}, {"dose", trial.dose}, {"sources", sources()}};
  for (const auto& [claim, answer] : trial.claims)
    json["claims"][claim] = {{"caught", name_of(answer.caught)}, {"words", answer.words}, {"asked", answer.asked}};
  write_text_atomically(answers_file(fault, trial.dose, options),
                        json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

FaultTrial::Answer answer_of(const Claim& claim, std::uint64_t asked, const ValidateResult& result) {
  for (const Verdict& verdict : result.verdicts)
    if (verdict.claim_id == claim.id) {
      const bool alarm = std::any_of(verdict.health.begin(), verdict.health.end(),
                                     [](const HealthCheck& h) { return !h.passed && h.chance < alarm_chance; });
      const Caught caught = verdict.green                              ? Caught::no
                            : verdict.outcome != Outcome::inconclusive ? Caught::yes
                            : alarm                                    ? Caught::health
                                                                       : Caught::undecided;
      return {caught, verdict.summary, asked};
    }
  // It could not be judged: the engine refused to go on, or its records made no sense to the estimator.
  std::string words = "not judged";
  for (const ValidateProblem& problem : result.problems)
    if (problem.what == fmt::format("claim {}", claim.id)) words = problem.why;
  return {Caught::yes, words, asked};
}

ValidateOptions judging(const std::vector<Claim>& claims, const FaultOptions& options) {
  ValidateOptions validate;
  validate.tier = options.tier;
  validate.store = options.store;
  validate.reference = options.reference;
  validate.jobs = options.jobs;
  validate.stop = options.stop;
  validate.confirm = false;
  validate.command = {"gpf", "faults"};
  for (const Claim& claim : claims) validate.claims.push_back(claim.id);
  return validate;
}

/// Of the folders of records beside this one, which are of other doses or sources and were left by trials that were
/// stopped, none.
void keep_only(const std::filesystem::path& records) {
  std::vector<std::filesystem::path> others;
  for (const auto& entry : std::filesystem::directory_iterator(records.parent_path()))
    if (entry.is_directory() && entry.path() != records) others.push_back(entry.path());
  for (const std::filesystem::path& other : others) std::filesystem::remove_all(other);
}

}  // namespace

std::string_view name_of(Caught caught) {
  switch (caught) {
    case Caught::no:
      return "not";
    case Caught::undecided:
      return "inconclusive";
    case Caught::health:
      return "health check";
    case Caught::yes:
      break;
  }
  return "caught";
}

std::optional<FaultTrial> try_fault(const Fault& fault, double dose, const std::vector<Claim>& claims,
                                    const FaultOptions& options) {
  if (!(dose >= 0 && dose <= largest_dose(fault)))
    throw InputError(fmt::format("'{}' has no dose {:g}", fault.name, dose),
                     fmt::format("it counts {}", fault.dose_means),
                     fmt::format("choose one from 0 to {:g}", largest_dose(fault)));
  std::error_code ignored;  // the lock says what is wrong
  std::filesystem::create_directories(folder(fault, options), ignored);
  const auto lock = FileLock::wait(folder(fault, options) / "lock", options.stop);
  if (!lock) return std::nullopt;
  FaultTrial trial = known_answers(fault, dose, options);
  SceneLibrary scenes(options.reference);
  std::vector<Claim> open;
  for (const Claim& claim : claims) {
    const auto known = trial.claims.find(claim.id);
    if (known == trial.claims.end() || known->second.asked != asked(claim, options.tier, scenes)) open.push_back(claim);
  }
  if (open.empty()) return trial;

  ValidateOptions validate = judging(open, options);
  validate.store = folder(fault, options) / fmt::format("records-{}-{}", dose, sources());
  validate.run = simulate_with(fault, dose, options.store);
  keep_only(validate.store);
  const ValidateResult result = judge_claims(validate);
  if (result.stopped) return std::nullopt;
  std::filesystem::remove_all(validate.store);
  for (const ValidateProblem& problem : result.problems)
    if (problem.status == ExitStatus::storage)
      throw StorageError(problem.what, problem.why, "the same command goes on");
  for (const Claim& claim : open) trial.claims[claim.id] = answer_of(claim, asked(claim, options.tier, scenes), result);
  keep_answers(fault, trial, options);
  return trial;
}

bool all_green_without_fault(const std::vector<Claim>& claims, const FaultOptions& options) {
  const ValidateResult result = judge_claims(judging(claims, options));
  if (result.stopped) return false;
  const auto refuse = [](const std::string& what, const std::string& why) {
    throw InputError(what, why, "what is not as expected without a fault catches none: mend it first");
  };
  for (const ValidateProblem& problem : result.problems) refuse(problem.what, problem.why);
  for (const Verdict& verdict : result.verdicts)
    if (!verdict.green) refuse(fmt::format("claim '{}' is not green", verdict.claim_id), verdict.summary);
  return true;
}

std::vector<Claim> claims_with_records(const std::filesystem::path& reference, Tier tier) {
  std::vector<Claim> claims = load_claims(reference / "claims");
  std::erase_if(claims, [tier](const Claim& c) { return !c.judged_in(tier) || c.scenes_in(tier).empty(); });
  return claims;
}

std::optional<SmallestDose> smallest_dose(const Fault& fault, const Claim& claim, const FaultOptions& options) {
  const auto catches = [&](double dose) -> std::optional<bool> {
    const auto trial = try_fault(fault, dose, {claim}, options);
    if (!trial) return std::nullopt;
    return is_caught(trial->claims.at(claim.id).caught);
  };
  SmallestDose result{std::string(fault.name), claim.id, 0, fault.dose};
  const auto at_all = catches(fault.dose);
  if (!at_all) return std::nullopt;
  if (!*at_all)
    throw InputError(fmt::format("claim '{}' does not catch '{}' at {}", claim.id, fault.name, fault.dose),
                     "a smallest dose is looked for below it", "choose a claim that catches it");
  for (double dose = fault.dose / 4; dose > fault.dose * 0x1p-16 && result.missed == 0; dose /= 4) {
    const auto caught = catches(dose);
    if (!caught) return std::nullopt;
    (*caught ? result.caught : result.missed) = dose;
  }
  while (result.missed > 0 && result.caught > 1.2 * result.missed) {
    const double dose = std::sqrt(result.missed * result.caught);
    const auto caught = catches(dose);
    if (!caught) return std::nullopt;
    (*caught ? result.caught : result.missed) = dose;
  }
  return result;
}

}  // namespace gpf
