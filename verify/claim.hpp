// A claim of the source as data: what is said, where, how it is tested and how far off it may be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gpf {

enum class Tier { quick, standard, full };
enum class Kind { value, band, profile, exponent, sign, order, zero_crossing, classification, same, shape };
enum class Expectation { reproduced, refuted, unresolved };

/// One reason why a measured number may differ from its reference although the claim holds.
struct ToleranceTerm {
  std::string name;      ///< for example "finite N"
  double value;          ///< half width that it adds to the band (relative or absolute: the claim's `tolerance_unit`)
  std::string evidence;  ///< where the number comes from
};

/// What a claim of the estimator `quantities` checks in each of its scenes: value is a QuantityExpression, wanted
/// near a reference or within bounds.
struct ClaimCheck {
  std::string label, value;
  std::optional<double> reference, least, most;  ///< the reference, or at least one of the others
};

/// A claim file, reference/claims/<id>.toml. Scenes are names in reference/scenes/ without ".toml",
/// or in reference/campaigns/: all points of it.
struct Claim {
  std::string id;  ///< never changes once released
  std::string title;
  int chapter = 0;
  std::string source;     ///< figure, section or equation of the thesis, or other reference
  std::string statement;  ///< the claim as a relation
  std::string method;     ///< how it is tested: estimator, equation, which definition
  Kind kind = Kind::value;
  Expectation expected = Expectation::reproduced;
  std::string expected_because;  ///< required unless reproduced: the evidence
  std::string estimator;         ///< name of the function that makes checks of records
  /// Runs that the claim reads, by tier; a tier falls back on the one below.
  std::map<Tier, std::vector<std::string>> scenes;
  std::map<Tier, int> replicas;  ///< most replicas that the judge may ask for, by tier
  std::vector<ToleranceTerm> tolerance;
  std::string tolerance_unit;  ///< "relative", "absolute", ...: what the terms are measured in
  std::map<std::string, double, std::less<>> parameters;       ///< further numbers of the estimator
  std::map<std::string, std::string, std::less<>> structures;  ///< class claims of chapter 5: by scene
  std::vector<ClaimCheck> checks;                              ///< of the estimator `quantities`
  std::vector<std::string> catches;                            ///< faults that the claim is there to catch
  bool transient = false;       ///< it reads the way to the steady state: its runs need not be stationary
  std::uint64_t text_hash = 0;  ///< hash_text of the file: a verdict on another text is stale

  /// Sum of the terms.
  [[nodiscard]] double tolerance_total() const;
  /// Throws InputError when the claim file has no such parameter.
  [[nodiscard]] double parameter(std::string_view name) const;
  /// False when its lowest tier with scenes lies above `tier`; a claim that reads no run is judged in every tier.
  [[nodiscard]] bool judged_in(Tier tier) const;
  /// Scenes of the tier, or of the next one below that has an entry; empty when there is none.
  [[nodiscard]] std::vector<std::string> scenes_in(Tier tier) const;
  /// Most replicas in the tier, with the same fall-back; 1 when there is no entry.
  [[nodiscard]] int replicas_in(Tier tier) const;
};

/// Strict: unknown keys, missing evidence and an id that is not the file's name are errors with file and line; the
/// format is documented in reference/claims/README.md. Throws InputError, StorageError.
Claim load_claim(const std::filesystem::path& path);
/// load_claim of a text; `path` stands for the file.
Claim parse_claim(std::string_view text, const std::filesystem::path& path);
/// All claims of a folder (its *.toml), by id. Throws StorageError, and InputError when there is none.
std::vector<Claim> load_claims(const std::filesystem::path& folder);

std::string_view name_of(Tier tier);
std::string_view name_of(Kind kind);
std::string_view name_of(Expectation expectation);
Tier tier_named(std::string_view name);                ///< Throws InputError that lists the tiers.
Kind kind_named(std::string_view name);                ///< Throws InputError that lists the kinds.
Expectation expectation_named(std::string_view name);  ///< Throws InputError that lists them.

}  // namespace gpf
