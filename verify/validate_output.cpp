#include "verify/validate_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "verify/validate.hpp"
#include "verify/verdict_file.hpp"

namespace gpf {

std::string_view colour_of(const Verdict& verdict) {
  if (verdict.green) return "green";
  return verdict.outcome == Outcome::inconclusive ? "open" : "red";
}

void print_table(const ValidateOptions& options, const std::vector<Verdict>& verdicts) {
  std::vector<Verdict> rows = verdicts;
  const auto rank = [](const Verdict& v) { return v.green ? 2 : v.outcome == Outcome::inconclusive ? 1 : 0; };
  std::stable_sort(rows.begin(), rows.end(), [&](const Verdict& a, const Verdict& b) { return rank(a) < rank(b); });
  std::size_t width = 5;
  for (const Verdict& v : rows) width = std::max(width, v.claim_id.size());
  fmt::print("{:<{}}  {:<12}  {:<10}  {:<5}  {:>2}  {}\n", "claim", width, "outcome", "expected", "", "R", "in words");
  for (const Verdict& v : rows)
    fmt::print("{:<{}}  {:<12}  {:<10}  {:<5}  {:>2}  {}\n", v.claim_id, width, name_of(v.outcome), name_of(v.expected),
               colour_of(v), v.replicas, v.summary);
  const auto count = [&](std::string_view colour) {
    return std::count_if(rows.begin(), rows.end(), [&](const Verdict& v) { return colour_of(v) == colour; });
  };
  fmt::print("tier {}: {} claim(s), {} green, {} red, {} open; verdicts in {}\n", name_of(options.tier), rows.size(),
             count("green"), count("red"), count("open"),
             verdict_path(options.store, options.tier, "").parent_path().string());
  std::fflush(stdout);
}

void print_json(const ValidateOptions& options, const std::vector<Verdict>& verdicts,
                const std::vector<ValidateProblem>& problems) {
  using Json = nlohmann::ordered_json;
  Json claims = Json::array(), troubles = Json::array();
  for (const Verdict& v : verdicts)
    claims.push_back({{"id", v.claim_id},
                      {"outcome", name_of(v.outcome)},
                      {"expected", name_of(v.expected)},
                      {"green", v.green},
                      {"replicas", v.replicas},
                      {"summary", v.summary},
                      {"cpu_seconds", v.cpu_seconds},
                      {"records", v.records}});
  for (const ValidateProblem& p : problems) troubles.push_back({{"what", p.what}, {"why", p.why}});
  const Json json{{"tier", name_of(options.tier)}, {"claims", claims}, {"problems", troubles}};
  fmt::print("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
  std::fflush(stdout);
}

void print_problems(const std::vector<ValidateProblem>& problems) {
  for (const ValidateProblem& p : problems) fmt::print(stderr, "gpf: {}: {}\n", p.what, p.why);
}

}  // namespace gpf
