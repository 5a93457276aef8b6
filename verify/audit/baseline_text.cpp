#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "verify/audit/baseline.hpp"

namespace gpf {
namespace {

constexpr std::string_view head =
    "# What tier quick gives: trace hashes of its runs, and of each claim's checks kind, band and values. "
    "gpf audit --write-baseline writes it.\n";

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result += '"';
}

/// Fields of a line; within double quotes commas count as they are, and two quotes are one.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool within = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && within && k + 1 < line.size() && line[k + 1] == '"')
      fields.back() += line[++k];
    else if (c == '"')
      within = !within;
    else if (c == ',' && !within)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

std::string kind_of(const ClaimEstimate& number) { return number.exact ? "exact" : number.share ? "share" : "mean"; }

/// A line that is being read.
struct Line {
  std::string_view file;
  int number;

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("'{}' line {} is no line of a baseline", file, number), why,
                     "write it with gpf audit --write-baseline");
  }
  [[nodiscard]] double number_in(const std::string& text) const {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || end != text.c_str() + text.size()) refuse(fmt::format("'{}' is no number", text));
    return value;
  }
  [[nodiscard]] ClaimEstimate check_in(const std::vector<std::string>& fields) const {
    ClaimEstimate check;
    check.claim = fields[1];
    check.label = fields[2];
    check.exact = fields[3] == "exact";
    check.share = fields[3] == "share";
    if (!check.exact && !check.share && fields[3] != "mean") refuse(fmt::format("'{}' is no kind of check", fields[3]));
    check.band = {number_in(fields[4]), number_in(fields[5])};
    std::istringstream values(fields[6]);
    for (std::string value; values >> value;) check.values.push_back(number_in(value));
    return check;
  }
};

}  // namespace

std::string baseline_text(const EvidenceSet& evidence) {
  std::string text(head);
  for (const auto& [name, run] : evidence.runs) text += fmt::format("run,{},{}\n", name, hexadecimal(run.trace_hash));
  for (const ClaimEstimate& c : evidence.numbers)
    text += fmt::format("check,{},{},{},{:.9g},{:.9g},{:.9g}\n", c.claim, quoted(c.label), kind_of(c), c.band.lo,
                        c.band.hi, fmt::join(c.values, " "));
  return text;
}

EvidenceSet parse_baseline(std::string_view text, std::string_view name) {
  EvidenceSet set;
  std::istringstream lines{std::string(text)};
  Line at{name, 0};
  for (std::string line; std::getline(lines, line);) {
    ++at.number;
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() == 3 && fields[0] == "run") {
      char* end = nullptr;
      RunDigest& run = set.runs[fields[1]];
      run.name = fields[1];
      run.trace_hash = std::strtoull(fields[2].c_str(), &end, 16);
      if (fields[2].size() != 16 || *end != '\0') at.refuse(fmt::format("'{}' is no trace hash", fields[2]));
    } else if (fields.size() == 7 && fields[0] == "check") {
      set.numbers.push_back(at.check_in(fields));
    } else {
      at.refuse("it is neither run,NAME,HASH nor check,CLAIM,LABEL,KIND,LOW,HIGH,VALUES");
    }
  }
  return set;
}

}  // namespace gpf
