#include "verify/validate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/provenance.hpp"
#include "gpf/scene/nearest_word.hpp"
#include "verify/forked_calls.hpp"
#include "verify/quantity_expression.hpp"
#include "verify/validate_output.hpp"
#include "verify/verdict_file.hpp"

namespace gpf {
namespace {

/// Stopped by a signal: whatever was finished is in the store.
struct Stopped {};

std::vector<Claim> chosen_claims(const ValidateOptions& options) {
  std::vector<Claim> all = load_claims(options.reference / "claims"), chosen;
  for (const std::string& id : options.claims) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Claim& c) { return c.id == id; });
    if (found == all.end()) {
      std::vector<std::string_view> ids;
      for (const Claim& c : all) ids.push_back(c.id);
      throw InputError(fmt::format("unknown claim '{}'", id), fmt::format("there are {}", fmt::join(ids, ", ")),
                       fmt::format("did you mean '{}'?", nearest_word(id, ids)));
    }
    if (!found->judged_in(options.tier))
      throw InputError(fmt::format("claim '{}' is not part of tier {}", id, name_of(options.tier)),
                       "it has no scenes there", "choose a higher --tier");
    chosen.push_back(*found);
  }
  if (!options.claims.empty()) return chosen;
  std::erase_if(all, [&](const Claim& c) { return !c.judged_in(options.tier); });
  return all;
}

class Validation {
 public:
  explicit Validation(const ValidateOptions& options)
      : options_(options),
        store_(options.store, trust_in(options.tier),
               [](const std::string& line) { fmt::print(stderr, "gpf: {}\n", line); }),
        scenes_(options.reference),
        pool_{options.jobs, options.checkpoint_period, options.stop, options.run, options.command} {}

  /// Before hours of runs: every estimator is known, and finds what it asks for.
  void require_estimators(const std::vector<Claim>& claims) {
    for (const Claim& claim : claims) {
      static_cast<void>(options_.estimators(claim.estimator));
      if (claim.checks.empty()) continue;
      for (const std::string& name : claim.scenes_in(options_.tier))
        for (const NamedScene& scene : scenes_.of(name))
          require_quantities(claim, scene.name, scene.file.scene, scene.file.run);
    }
  }

  /// The first look's records of the scenes that options.only_runs names.
  void run_only(const std::vector<Claim>& claims, std::uint64_t seed) {
    Demand demand, wanted;
    for (const Claim& claim : claims) add_demand(demand, claim, options_.tier, looks_of(claim).front());
    for (const std::string& scene : options_.only_runs) {
      const auto found = demand.find(scene);
      if (found == demand.end())
        throw InputError(fmt::format("no claim of tier {} reads scene '{}'", name_of(options_.tier), scene),
                         "only runs that a claim reads are made", "see reference/claims/ for the scenes");
      wanted.insert(*found);
    }
    make_runs(wanted, seed);
  }

  /// Looks at every claim until it is decided or its cap is reached.
  void judge_all(std::vector<Claim> open, std::uint64_t seed, const std::map<std::string, std::string>& notes) {
    for (const Claim& claim : open) std::filesystem::remove(verdict_path(options_.store, options_.tier, claim.id));
    for (int look = 1; !open.empty(); ++look) {
      Demand demand;
      for (const Claim& claim : open)
        add_demand(demand, claim, options_.tier, looks_of(claim)[static_cast<std::size_t>(look - 1)]);
      make_runs(demand, seed);
      look_at(open, look, seed, notes);
    }
  }

  /// It reads campaigns, whose replicas are the same in every release.
  [[nodiscard]] bool has_fixed_seeds(const Claim& claim) const {
    const std::vector<std::string> names = claim.scenes_in(options_.tier);
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return scenes_.is_campaign(name); });
  }

  [[nodiscard]] std::vector<Verdict> verdicts() const {
    std::vector<Verdict> result;
    for (const auto& [id, verdict] : verdicts_) result.push_back(verdict);
    return result;
  }
  [[nodiscard]] const std::vector<ValidateProblem>& problems() const { return problems_; }

 private:
  [[nodiscard]] std::vector<int> looks_of(const Claim& claim) const {
    if (options_.replicas != 0 && !claim.scenes_in(options_.tier).empty()) return {options_.replicas};
    return looks_up_to(claim.replicas_in(options_.tier));
  }

  void make_runs(const Demand& demand, std::uint64_t seed) {
    const std::vector<RunJob> jobs = missing_runs(demand, scenes_, store_, seed);
    if (jobs.empty()) return;
    fmt::print(stderr, "{} run(s) missing, {} at a time\n", jobs.size(), options_.jobs);
    const PoolResult result = run_pool(store_, jobs, pool_);
    for (const RunFailure& failure : result.failures)
      problems_.push_back({fmt::format("run {}", failure.label), failure.what, failure.status});
    if (result.stopped) throw Stopped{};
  }

  /// One look at each claim, side by side; those that need another one stay open.
  void look_at(std::vector<Claim>& open, int look, std::uint64_t seed,
               const std::map<std::string, std::string>& notes) {
    const auto judge_one = [&](std::size_t k) {
      const std::vector<int> looks = looks_of(open[k]);
      const Look this_look{look, static_cast<int>(looks.size()), looks.at(static_cast<std::size_t>(look - 1))};
      const Verdict verdict = review(open[k], options_.tier, this_look, scenes_, store_, seed, options_.estimators);
      const bool is_last = verdict.outcome != Outcome::inconclusive || this_look.number == this_look.of;
      return is_last ? verdict_text(verdict) : std::string();
    };
    std::set<std::string> undecided;
    std::map<std::size_t, ValidateProblem> problems;  // answers come in any order
    std::size_t judged = 0;
    const auto take = [&](std::size_t k, const ForkedAnswer& answer) {
      const std::string& id = open[k].id;
      if (++judged; ::isatty(STDERR_FILENO) == 1)
        fmt::print(stderr, "\rjudged {} of {} claims{}", judged, open.size(), judged == open.size() ? "\n" : "");
      if (answer.status != ExitStatus::success) {
        problems.insert({k, {fmt::format("claim {}", id), answer.text, answer.status}});
        verdicts_.erase(id);
      } else if (answer.text.empty()) {
        undecided.insert(id);
      } else {
        keep(parse_verdict(answer.text, id), notes);
      }
    };
    if (!forked_calls(open.size(), options_.jobs, judge_one, take, options_.stop)) throw Stopped{};
    for (auto& [k, problem] : problems) problems_.push_back(std::move(problem));
    std::erase_if(open, [&](const Claim& claim) { return !undecided.contains(claim.id); });
  }

  void keep(Verdict verdict, const std::map<std::string, std::string>& notes) {
    verdict.program_hash = program_;
    if (const auto note = notes.find(verdict.claim_id); note != notes.end()) verdict.notes.push_back(note->second);
    write_verdict(verdict, options_.store);
    verdicts_.insert_or_assign(verdict.claim_id, std::move(verdict));
  }

  const ValidateOptions& options_;
  RecordStore store_;
  SceneLibrary scenes_;
  PoolOptions pool_;
  std::uint64_t program_ = program_hash();
  std::map<std::string, Verdict> verdicts_;
  std::vector<ValidateProblem> problems_;
};

/// Claims that failed although they should not, once more with new seeds.
void confirm(Validation& validation, const std::vector<Claim>& claims, std::uint64_t seed) {
  std::vector<Claim> again;
  std::map<std::string, std::string> notes;
  for (const Verdict& verdict : validation.verdicts()) {
    if (verdict.outcome != Outcome::fail || verdict.green) continue;
    const Claim& claim =
        *std::find_if(claims.begin(), claims.end(), [&](const Claim& c) { return c.id == verdict.claim_id; });
    if (validation.has_fixed_seeds(claim)) continue;
    again.push_back(claim);
    notes[verdict.claim_id] =
        fmt::format("Confirmation run with new seeds; with release seed {} it failed: {}.", seed, verdict.summary);
  }
  if (again.empty()) return;
  fmt::print(stderr, "{} claim(s) failed: one confirmation run with new seeds\n", again.size());
  validation.judge_all(again, mix(seed), notes);
}

int exit_status(const std::vector<Verdict>& verdicts, const std::vector<ValidateProblem>& problems) {
  if (!problems.empty()) return static_cast<int>(problems.front().status);
  const auto any = [&](auto condition) { return std::any_of(verdicts.begin(), verdicts.end(), condition); };
  if (any([](const Verdict& v) { return !v.green && v.outcome != Outcome::inconclusive; }))
    return static_cast<int>(ExitStatus::red);
  if (any([](const Verdict& v) { return !v.green; })) return static_cast<int>(ExitStatus::inconclusive);
  return static_cast<int>(ExitStatus::success);
}

}  // namespace

ValidateResult judge_claims(const ValidateOptions& options) {
  const std::vector<Claim> claims = chosen_claims(options);
  std::uint64_t seed = options.release_seed;
  if (options.tier == Tier::quick) {
    if (seed != 0)
      throw InputError("a release seed in tier quick",
                       "its seeds are fixed, so that a verdict changes only with the "
                       "program",
                       "leave out --release-seed, or choose --tier standard");
  } else {
    if (options.replicas != 0)
      throw InputError(fmt::format("a number of replicas in tier {}", name_of(options.tier)),
                       "there the looks are part of the stated error rates", "leave out --replicas");
    if (seed == 0) seed = default_release_seed();
    fmt::print(stderr, "release seed {}: --release-seed {} repeats these runs\n", seed, seed);
  }
  Validation validation(options);
  validation.require_estimators(claims);
  bool stopped = false;
  try {
    if (!options.only_runs.empty()) {
      validation.run_only(claims, seed);
    } else {
      validation.judge_all(claims, seed, {});
      if (options.tier != Tier::quick && options.confirm) confirm(validation, claims, seed);
    }
  } catch (const Stopped&) {
    stopped = true;
  }
  return {validation.verdicts(), validation.problems(), stopped};
}

int validate(const ValidateOptions& options) {
  const ValidateResult result = judge_claims(options);
  if (result.stopped) {
    fmt::print(stderr, "gpf: stopped by a signal; the same command goes on\n");
    return static_cast<int>(ExitStatus::interrupted);
  }
  if (options.only_runs.empty()) {
    if (options.json)
      print_json(options, result.verdicts, result.problems);
    else
      print_table(options, result.verdicts);
  }
  print_problems(result.problems);
  return exit_status(result.verdicts, result.problems);
}

std::uint64_t default_release_seed() { return hash_text("release " + build_provenance().version); }

std::uint64_t program_hash() {
  try {
    return hash_text(read_text("/proc/self/exe"));
  } catch (const StorageError&) {
    return 0;
  }
}

}  // namespace gpf
