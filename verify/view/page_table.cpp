#include "verify/view/page_table.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "gpf/base/hash.hpp"
#include "gpf/io/provenance.hpp"

namespace gpf {
namespace {

/// The lines `key = value` of the canonical text, [scene] and [run].
std::vector<PageTable> scene_tables(const ViewSource& source) {
  std::vector<PageTable> tables;
  std::istringstream lines(canonical_text(source.scene, source.run));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t sign = line.find(" = ");
    if (line.starts_with("["))
      tables.push_back({line == "[scene]" ? "Scene" : "Run", {}});
    else if (sign != std::string::npos && !tables.empty())
      tables.back().rows.emplace_back(line.substr(0, sign), line.substr(sign + 3));
  }
  tables.front().rows.emplace_back("area fraction", fmt::format("{:.6g}", source.scene.area_fraction()));
  return tables;
}

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_structured()) return value.dump();
  std::string text;
  for (const auto& [key, part] : value.items())
    text += fmt::format("{}{}{}",
                        text.empty()        ? ""
                        : value.is_object() ? ", "
                                            : " ",
                        value.is_object() ? key + " " : "", text_of(part));
  return text;
}

/// The members of a JSON object; a text that is none, as it is.
void append_json(PageTable& table, const std::string& text) {
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!json.is_object()) {
    table.rows.emplace_back("provenance", text);
    return;
  }
  for (const auto& [key, value] : json.items()) table.rows.emplace_back(key, text_of(value));
}

PageTable record_table(const Record& record) {
  PageTable table{"Record", {}};
  table.rows = {{"trace hash", hexadecimal(record.trace_hash)},
                {"time at its end", fmt::format("{:.6g}", record.time)},
                {"pair contacts", fmt::format("{}", record.counts.pair_contacts)},
                {"wall contacts", fmt::format("{}", record.counts.wall_contacts)},
                {"physics version", fmt::format("{}", record.physics_version)},
                {"wall seconds", fmt::format("{:.3g}", record.wall_seconds)}};
  append_json(table, record.build);
  append_json(table, record.session);
  return table;
}

}  // namespace

std::vector<PageTable> page_tables(const ViewSource& source, std::uint64_t frames_hash) {
  std::vector<PageTable> tables = scene_tables(source);
  if (source.record) tables.push_back(record_table(*source.record));
  tables.push_back({"This page", {{"shows", source.name}, {"trace hash of its frames", hexadecimal(frames_hash)}}});
  append_json(tables.back(), to_json(build_provenance()));
  return tables;
}

}  // namespace gpf
