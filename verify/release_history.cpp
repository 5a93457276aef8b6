#include "verify/release_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/markdown.hpp"
#include "verify/verdict_summary.hpp"

namespace gpf {
namespace {

constexpr std::string_view header = "claim,outcome,green,replicas,physics_version,value,error,check\n";

/// {0, 10, 2} of "0.10.2", for the order of releases.
std::vector<int> numbers_of(const std::string& release) {
  std::vector<int> numbers;
  std::istringstream parts(release);
  for (std::string part; std::getline(parts, part, '.');) {
    int number = 0;
    std::from_chars(part.data(), part.data() + part.size(), number);
    numbers.push_back(number);
  }
  return numbers;
}

/// The label is the last field and may hold commas; the others do not.
ReleaseEntry parse_line(const std::string& line, const std::string& release, std::string& claim,
                        const std::filesystem::path& path) {
  ReleaseEntry entry;
  entry.release = release;
  std::istringstream fields(line);
  std::string green, replicas, version, value, error;
  for (std::string* field : {&claim, &entry.outcome, &green, &replicas, &version, &value, &error})
    std::getline(fields, *field, ',');
  std::getline(fields, entry.check);
  try {
    entry.green = green == "yes";
    entry.replicas = std::stoi(replicas);
    entry.physics_version = std::stoi(version);
    entry.value = std::stod(value);
    entry.error = std::stod(error);
  } catch (const std::exception&) {
    throw InputError(fmt::format("'{}' has a damaged line: {}", path.string(), line), "it is written by gpf report",
                     "restore it from the repository");
  }
  return entry;
}

const JudgedCheck* kept_check(const Verdict& verdict, const ReleaseHistory& history) {
  const auto earlier = history.find(verdict.claim_id);
  if (earlier != history.end())
    for (const JudgedCheck& c : verdict.checks)
      if (c.check.label == earlier->second.back().check) return &c;
  return deciding_check(verdict);
}

}  // namespace

ReleaseHistory load_release_history(const std::filesystem::path& folder) {
  ReleaseHistory history;
  if (!std::filesystem::is_directory(folder)) return history;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return numbers_of(a.stem().string()) < numbers_of(b.stem().string()); });
  for (const std::filesystem::path& path : files) {
    std::istringstream lines(read_text(path));
    std::string line, claim;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      const ReleaseEntry entry = parse_line(line, path.stem().string(), claim, path);
      history[claim].push_back(entry);
    }
  }
  return history;
}

void write_release(const std::vector<const Verdict*>& verdicts, const std::string& release,
                   const std::filesystem::path& folder) {
  ReleaseHistory earlier = load_release_history(folder);
  for (auto& [claim, entries] : earlier) std::erase_if(entries, [&](const auto& e) { return e.release == release; });
  std::erase_if(earlier, [](const auto& claim) { return claim.second.empty(); });
  std::string text(header);
  for (const Verdict* verdict : verdicts) {
    const JudgedCheck* check = kept_check(*verdict, earlier);
    if (check == nullptr) continue;
    const double error = check->check.values.size() < 2 ? std::nan("") : check->summary.standard_error();
    text += fmt::format("{},{},{},{},{},{:.6g},{:.2g},{}\n", verdict->claim_id, name_of(verdict->outcome),
                        verdict->green ? "yes" : "no", verdict->replicas, verdict->physics_version, check->summary.mean,
                        error, check->check.label);
  }
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  write_text_atomically(folder / fmt::format("{}.csv", release), text);
}

std::string history_table(const std::vector<ReleaseEntry>& entries) {
  if (entries.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const ReleaseEntry& e : entries)
    rows.push_back({e.release, fmt::format("{}{}", e.outcome, e.green ? "" : ", not as expected"),
                    std::isfinite(e.error) ? number_with_error(e.value, e.error) : fmt::format("{:.6g}", e.value),
                    std::to_string(e.replicas), std::to_string(e.physics_version), e.check});
  return markdown_table({"release", "verdict", "value", "R", "physics version", "of"}, rows);
}

}  // namespace gpf
