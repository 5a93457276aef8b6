// What a report is made of: claims, their verdicts, and facts of the runs that they read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "verify/claim.hpp"
#include "verify/errata.hpp"
#include "verify/judge.hpp"
#include "verify/release_history.hpp"

namespace gpf {

/// A claim of the tier with its verdict.
struct JudgedClaim {
  Claim claim;
  Verdict verdict;
};

/// What a report says of the runs of one scene.
struct SceneCost {
  std::set<std::string> records;  ///< their names
  std::uint64_t collisions = 0;   ///< between disks
  double cpu_seconds = 0;
  std::vector<std::string> claims;  ///< ids of those that read them
};

/// Where and by what the records were made: each line of the provenance with the values that occur.
using ProvenanceFacts = std::map<std::string, std::set<std::string>>;

struct ReportData {
  Tier tier = Tier::quick;
  std::vector<JudgedClaim> claims;          ///< by id
  std::size_t of_claims = 0;                ///< how many the tier has
  std::vector<Claim> others;                ///< of the tier, when claims were chosen: those that were not
  std::map<std::string, SceneCost> scenes;  ///< by name
  std::vector<Erratum> errata;              ///< of the source, in its order; none: no page
  ProvenanceFacts provenance;               ///< "version", "commit", "compiler", "flags", "libraries", "cpu", "system"
  ReleaseHistory history;                   ///< of the releases so far
  std::set<std::string> dates;              ///< of the runs, "2024-05-06"
  std::uint64_t collisions = 0;             ///< of all runs, each counted once
  std::size_t runs = 0;
  std::string folders;     ///< folder_options() of what it was loaded from
  double cpu_seconds = 0;  ///< of all runs, each counted once, and of the estimators
};

/// Everything of a tier, or of the chosen claims of it where any are named, from <reference>/claims,
/// <reference>/errata.toml (where there is one) and the store; runs nothing and judges nothing. Throws InputError when
/// a chosen claim is not one of the tier, or has no verdict, or one on another text of the claim, another physics
/// version or other runs, when a record is gone, or when an erratum names a claim without a file; StorageError when a
/// file cannot be read.
ReportData load_report_data(Tier tier, const std::filesystem::path& store, const std::filesystem::path& reference,
                            const std::vector<std::string>& chosen = {});

}  // namespace gpf
