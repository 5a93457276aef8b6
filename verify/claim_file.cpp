#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/claim.hpp"
#include "verify/quantity_expression.hpp"
#include "verify/toml_fields.hpp"

namespace gpf {
namespace {

using Keys = std::span<const std::string_view>;
constexpr std::array<std::string_view, 19> claim_keys{
    "id",      "title",    "chapter",          "source",    "statement",  "method",
    "kind",    "expected", "expected_because", "estimator", "transient",  "tolerance_unit",
    "catches", "scenes",   "replicas",         "tolerance", "parameters", "structures",
    "check"};
constexpr std::array<std::string_view, 3> tier_keys{"quick", "standard", "full"};
constexpr std::array<std::string_view, 3> term_keys{"name", "value", "evidence"};
constexpr std::array<std::string_view, 5> check_keys{"label", "value", "reference", "least", "most"};
constexpr std::array<std::int64_t, 5> replica_caps{1, 4, 8, 16, 32};

/// The value of an enumeration, with the place in the file added to what `named` throws.
template <class Named>
auto word(const TomlFields& file, std::string_view key, Named named) {
  const std::string text = file.text(key);
  try {
    return named(text);
  } catch (const InputError& error) {
    throw file.error(key, error.problem(), error.why(), error.remedy());
  }
}

/// Letters, digits, '-', '_' and single dots between them: a claim's id is a file name and a ctest name.
bool is_name(std::string_view text) {
  char before = '.';
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    if (!plain && !(c == '.' && before != '.')) return false;
    before = c;
  }
  return before != '.';
}

std::string id_of(const TomlFields& file, const std::filesystem::path& path) {
  std::string id = file.text("id");
  if (!is_name(id))
    throw file.error("id", fmt::format("id {} cannot be used", gpf::quoted(id)),
                     "it is the name of a file and of a test", "use letters, digits, '-', '_' and dots between them");
  if (path.filename().string() != id + ".toml")
    throw file.error("id", fmt::format("id '{}' is not the name of the file", id), "a claim is found by its id",
                     fmt::format("rename the file to {}.toml, or correct the id", id));
  return id;
}

void read_expectation(const TomlFields& file, Claim& claim) {
  claim.expected = word(file, "expected", expectation_named);
  const bool plain = claim.expected == Expectation::reproduced, because = file.has("expected_because");
  if (because && plain)
    throw file.error("expected_because", "expected_because is given", "what is reproduced needs no excuse",
                     "remove it, or correct expected");
  if (because) claim.expected_because = file.text("expected_because");
  if (!because && !plain)
    throw file.error("expected", fmt::format("expected = \"{}\" without expected_because", name_of(claim.expected)),
                     "departing from the source needs evidence", "add expected_because = \"...\"");
}

void read_scenes(const TomlFields& file, Claim& claim) {
  if (!file.has("scenes")) {
    if (file.has("replicas"))
      throw file.error("replicas", "[replicas] without [scenes]", "without runs there is nothing to repeat",
                       "add [scenes] or remove [replicas]");
    return;
  }
  const TomlFields scenes = file.table("scenes", "[scenes]", Keys(tier_keys));
  for (const TomlEntry& entry : scenes.entries()) {
    std::vector<std::string> names = scenes.texts(entry.key);
    for (const std::string& name : names)
      if (!is_name(name))
        throw scenes.error(entry.key, fmt::format("scene {} cannot be used", gpf::quoted(name)),
                           "it is the name of a file in reference/scenes/ or reference/campaigns/ without .toml",
                           "correct it");
    claim.scenes[tier_named(entry.key)] = std::move(names);
  }
  if (claim.scenes.empty())
    throw file.error("scenes", "[scenes] is empty", "a claim without runs has no such table",
                     "add quick = [\"...\"] or remove the table");

  const TomlFields replicas = file.table("replicas", "[replicas]", Keys(tier_keys));
  for (const TomlEntry& entry : replicas.entries()) {
    const std::int64_t cap = replicas.integer(entry.key);
    if (std::find(replica_caps.begin(), replica_caps.end(), cap) == replica_caps.end())
      throw replicas.error(entry.key, fmt::format("{} = {} replicas", entry.key, cap),
                           fmt::format("the judge looks at {}", fmt::join(replica_caps, ", ")), "write one of these");
    claim.replicas[tier_named(entry.key)] = static_cast<int>(cap);
  }
  const Tier lowest = claim.scenes.begin()->first;
  if (claim.replicas.empty() || claim.replicas.begin()->first > lowest)
    throw file.error("replicas", fmt::format("[replicas] has no entry for {} or below", name_of(lowest)),
                     "the claim has scenes in that tier", fmt::format("add {} = 4 or more", name_of(lowest)));
}

void read_tolerance(const TomlFields& file, Claim& claim) {
  for (const TomlFields& fields : file.tables("tolerance", "[[tolerance]]", Keys(term_keys))) {
    ToleranceTerm term{fields.text("name"), fields.number("value"), fields.text("evidence")};
    if (term.value < 0)
      throw fields.error("value", fmt::format("tolerance {} = {} is negative", gpf::quoted(term.name), term.value),
                         "terms add up to half the width of the band", "write 0 or more");
    for (const ToleranceTerm& other : claim.tolerance)
      if (other.name == term.name)
        throw fields.error("name", fmt::format("tolerance {} is given twice", gpf::quoted(term.name)),
                           "each reason counts once", "join them or name them apart");
    claim.tolerance.push_back(std::move(term));
    if (!std::isfinite(claim.tolerance_total()))
      throw fields.error("value", "the terms add up to more than a number holds", "they are half the width of the band",
                         "write smaller ones");
  }
  if (claim.tolerance.empty() == file.has("tolerance_unit"))
    throw file.error(
        "tolerance_unit",
        claim.tolerance.empty() ? "tolerance_unit without [[tolerance]]" : "[[tolerance]] without tolerance_unit",
        "numbers and their unit belong together", "add what is missing or remove the other");
  if (file.has("tolerance_unit")) claim.tolerance_unit = file.text("tolerance_unit");
}

void read_checks(const TomlFields& file, Claim& claim) {
  if (file.has("check") != (claim.estimator == "quantities"))
    throw file.error(file.has("check") ? "check" : "estimator",
                     file.has("check") ? "[[check]] is given" : "estimator = \"quantities\" without [[check]]",
                     "it is what the estimator 'quantities' judges", "add what is missing, or remove it");
  for (const TomlFields& fields : file.tables("check", "[[check]]", Keys(check_keys))) {
    const auto number = [&](std::string_view key) {
      return fields.has(key) ? std::optional(fields.number(key)) : std::nullopt;
    };
    ClaimCheck check{fields.has("label") ? fields.text("label") : fields.text("value"), fields.text("value"),
                     number("reference"), number("least"), number("most")};
    try {
      parse_quantity_expression(check.value);
    } catch (const InputError& error) {
      throw fields.error("value", error.problem(), error.why(), error.remedy());
    }
    if (check.reference.has_value() == (check.least || check.most))
      throw fields.error("value", fmt::format("what is wanted of \"{}\" is not clear", check.value),
                         "a check has a reference, with the tolerance about it, or else bounds",
                         "write reference = ..., or least = ... and most = ..., or one of the two");
    if (check.reference && claim.tolerance_total() == 0)
      throw fields.error("reference", "a reference without a tolerance", "no measured number meets it exactly",
                         "add [[tolerance]] with its evidence");
    if (check.least && check.most && !(*check.least <= *check.most))
      throw fields.error("least", fmt::format("least = {} is above most = {}", *check.least, *check.most),
                         "no number lies between them", "exchange them");
    claim.checks.push_back(std::move(check));
  }
}

}  // namespace

Claim parse_claim(std::string_view text, const std::filesystem::path& path) {
  const std::string name = path.string();
  const TomlTable entries = read_toml(text, name);
  const TomlFields file(entries, {}, "", name, Keys(claim_keys));
  Claim claim;
  claim.id = id_of(file, path);
  claim.title = file.text("title");
  const std::int64_t chapter = file.integer("chapter");
  if (chapter < 1 || chapter > 99)
    throw file.error("chapter", fmt::format("chapter = {}", chapter), "chapters are counted from 1",
                     "write the chapter of the thesis");
  claim.chapter = static_cast<int>(chapter);
  claim.source = file.text("source");
  claim.statement = file.text("statement");
  claim.method = file.text("method");
  claim.kind = word(file, "kind", kind_named);
  read_expectation(file, claim);
  claim.estimator = file.text("estimator");
  claim.catches = file.texts("catches");
  if (file.has("transient")) claim.transient = file.boolean("transient");
  read_scenes(file, claim);
  read_tolerance(file, claim);
  read_checks(file, claim);
  if (file.has("parameters")) {
    const TomlFields parameters = file.table("parameters", "[parameters]", {});
    for (const TomlEntry& entry : parameters.entries()) claim.parameters[entry.key] = parameters.number(entry.key);
  }
  if (file.has("structures")) {
    const TomlFields structures = file.table("structures", "[structures]", {});
    for (const TomlEntry& entry : structures.entries()) claim.structures[entry.key] = structures.text(entry.key);
  }
  claim.text_hash = hash_text(text);
  return claim;
}

Claim load_claim(const std::filesystem::path& path) { return parse_claim(read_text(path), path); }

std::vector<Claim> load_claims(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  if (failure)
    throw StorageError(fmt::format("cannot list the claims in '{}'", folder.string()), failure.message(),
                       "give the folder that holds claims/ and scenes/ with --reference");
  if (paths.empty())
    throw InputError(fmt::format("no claims in '{}'", folder.string()), "it holds no .toml file",
                     "give the folder that holds claims/ and scenes/ with --reference");
  std::sort(paths.begin(), paths.end());
  std::vector<Claim> claims;
  for (const auto& path : paths) claims.push_back(load_claim(path));
  return claims;
}

}  // namespace gpf
