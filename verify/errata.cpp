#include "verify/errata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/toml_fields.hpp"

namespace gpf {
namespace {

using Keys = std::span<const std::string_view>;
constexpr std::array<std::string_view, 1> file_keys{"erratum"};
constexpr std::array<std::string_view, 6> erratum_keys{"id", "place", "printed", "correct", "evidence", "claims"};

bool is_id(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_';
  });
}

void check_id(const TomlFields& fields, std::string_view key, const std::string& id) {
  if (!is_id(id))
    throw fields.error(key, fmt::format("{} {} cannot be used", key == "id" ? "id" : "claim", gpf::quoted(id)),
                       "it becomes a link", "use letters, digits, dots, '-' and '_'");
}

Erratum erratum_of(const TomlFields& fields) {
  Erratum erratum{fields.text("id"),      fields.text("place"),    fields.text("printed"),
                  fields.text("correct"), fields.text("evidence"), {}};
  check_id(fields, "id", erratum.id);
  if (erratum.printed == erratum.correct)
    throw fields.error("correct", fmt::format("correct is the same as printed in {}", gpf::quoted(erratum.id)),
                       "then nothing is wrong", "correct one of them");
  if (fields.has("claims")) erratum.claims = fields.texts("claims");
  for (const std::string& claim : erratum.claims) check_id(fields, "claims", claim);
  return erratum;
}

}  // namespace

std::vector<Erratum> parse_errata(std::string_view text, std::string_view name) {
  const TomlTable entries = read_toml(text, name);
  const TomlFields file(entries, {}, "", name, Keys(file_keys));
  std::vector<Erratum> errata;
  for (const TomlFields& fields : file.tables("erratum", "[[erratum]]", Keys(erratum_keys))) {
    Erratum erratum = erratum_of(fields);
    if (std::any_of(errata.begin(), errata.end(), [&](const Erratum& other) { return other.id == erratum.id; }))
      throw fields.error("id", fmt::format("erratum {} is given twice", gpf::quoted(erratum.id)),
                         "an id names one erratum", "join them or name them apart");
    errata.push_back(std::move(erratum));
  }
  if (errata.empty())
    throw file.error("erratum", "no errata", "the file holds no [[erratum]]",
                     "add one, or leave the file out altogether");
  return errata;
}

std::vector<Erratum> load_errata(const std::filesystem::path& path) {
  return parse_errata(read_text(path), path.string());
}

}  // namespace gpf
