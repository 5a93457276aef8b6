#include "verify/audit/evidence_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/io/record.hpp"
#include "verify/store.hpp"
#include "verify/verdict_file.hpp"

namespace gpf {
namespace {

constexpr int most_replicas = 32;

std::uint64_t hash_of_measured(const Record& record) {
  std::uint64_t hash = mix(record.blocks);
  const auto add = [&hash](const std::vector<double>& numbers) {
    for (const double x : numbers) hash = mix(hash ^ std::bit_cast<std::uint64_t>(x));
  };
  add(record.sums);
  for (const NamedArray& array : record.arrays) {
    hash = mix(hash ^ hash_text(array.name));
    add(array.values);
  }
  for (const auto* numbers : {&record.history.time, &record.history.energy, &record.history.temperature}) add(*numbers);
  const auto add_state = [&](const State& state) {
    for (const auto* vectors : {&state.position, &state.velocity})
      for (const Vec2 v : *vectors) add({v.x, v.y});
  };
  for (const Snapshot& snapshot : record.snapshots) add_state(snapshot.state);
  add_state(record.final_state);
  return hash;
}

/// RunDigest::sums and sizes.
void sum_up(const Record& record, RunDigest& digest) {
  const std::size_t tallies = record.blocks == 0 ? 0 : record.sums.size() / record.blocks;
  digest.sums.assign(tallies, 0);
  digest.sizes.assign(tallies, 0);
  for (std::size_t k = 0; k < tallies * record.blocks; ++k) {
    digest.sums[k % tallies] += record.sums[k];
    digest.sizes[k % tallies] += std::abs(record.sums[k]);
  }
  const auto append = [&digest](const std::vector<double>& numbers) {
    for (const double x : numbers) {
      digest.sums.push_back(x);
      digest.sizes.push_back(std::abs(x));
    }
  };
  for (const NamedArray& array : record.arrays) append(array.values);
  append(record.history.time);
  append(record.history.energy);
  append(record.history.temperature);
  const auto append_state = [&](const State& state) {
    for (const auto* vectors : {&state.position, &state.velocity})
      for (const Vec2 v : *vectors) append({v.x, v.y});
  };
  for (const Snapshot& snapshot : record.snapshots) append_state(snapshot.state);
  append_state(record.final_state);
}

RunDigest digest_of(const Record& record, std::string name) {
  RunDigest digest;
  digest.name = std::move(name);
  digest.trace_hash = record.trace_hash;
  digest.measured = hash_of_measured(record);
  digest.contacts = record.counts.pair_contacts;
  digest.time = record.time;
  digest.epoch_length = record.epoch_length;
  digest.cpu_seconds = record.cpu_seconds;
  digest.build = record.build;
  digest.session = record.session;
  sum_up(record, digest);
  return digest;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> files;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::filesystem::path verdict_folder(const std::filesystem::path& store) { return store / "verdicts" / "quick"; }

}  // namespace

std::map<std::string, std::string> run_names(const std::filesystem::path& reference) {
  std::map<std::string, std::string> names;
  for (const std::filesystem::path& path : files_in(reference / "scenes", ".toml")) {
    try {
      const SceneFile file = load_scene(path);
      for (int replica = 0; replica < most_replicas; ++replica) {
        const SceneFile run = replica_of(file, replica, 0);
        names.emplace(canonical_text(run.scene, run.run), fmt::format("{} #{}", path.stem().string(), replica + 1));
      }
    } catch (const Error&) {
      continue;  // of another version of the program; its runs are called by their records
    }
  }
  return names;
}

ClaimEstimate estimate_of(const std::string& claim, const JudgedCheck& judged) {
  const Check& check = judged.check;
  return {claim, check.label, check.values, check.band, check.exact, check.share};
}

bool is_store(const std::filesystem::path& folder) { return !files_in(verdict_folder(folder), ".json").empty(); }

EvidenceSet read_evidence(const std::filesystem::path& store, const std::map<std::string, std::string>& names,
                          const std::vector<std::string>& claims) {
  EvidenceSet set;
  std::set<std::string> records;
  for (const std::filesystem::path& path : files_in(verdict_folder(store), ".json")) {
    const std::string id = path.stem().string();
    if (!claims.empty() && std::find(claims.begin(), claims.end(), id) == claims.end()) continue;
    const Verdict verdict = read_verdict(store, Tier::quick, id);
    set.claims[id] = {verdict.outcome, verdict.green, verdict.claim_hash, verdict.summary};
    for (const JudgedCheck& check : verdict.checks) set.numbers.push_back(estimate_of(id, check));
    records.insert(verdict.records.begin(), verdict.records.end());
  }
  if (set.claims.empty())
    throw InputError(fmt::format("'{}' holds no verdict to compare", store.string()),
                     claims.empty() ? "no claim of tier quick was judged there" : "the claims asked for are not there",
                     "gpf validate --tier quick --store makes them");
  for (const std::string& name : records) {
    const std::filesystem::path path = store / fmt::format("{}.h5", name);
    if (!std::filesystem::exists(path)) {
      set.missing_records.push_back(name);
      continue;
    }
    const Record record = read_record(path);
    const std::string key = canonical_text(record.scene, record.run);
    const auto known = names.find(key);
    set.runs[key] = digest_of(record, known == names.end() ? name : known->second);
  }
  return set;
}

}  // namespace gpf
