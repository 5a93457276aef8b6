#include "verify/trial/trial_result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "gpf/io/markdown.hpp"
#include "gpf/stats/proportion.hpp"

namespace gpf {

std::string rate_text(std::size_t hits, std::size_t trials) {
  const double n = static_cast<double>(trials), rate = static_cast<double>(hits) / n;
  // Without a hit, or without a miss: what one would have been worth.
  const double error = hits == 0 || hits == trials ? 1 / n : std::sqrt(rate * (1 - rate) / n);
  return fmt::format("{:.4f} ± {:.1g}", rate, error);
}

TrialResult at_most(std::string what, std::size_t hits, std::size_t trials, double most) {
  TrialResult result{std::move(what), fmt::format("{} ({} of {})", rate_text(hits, trials), hits, trials), {}, false};
  if (most >= 1) return result;
  result.stated = fmt::format("at most {:g}", most);
  result.outside = outside_band_p_value(Share{hits, trials}, {0, most}) <= trial_alpha;
  return result;
}

TrialResult expected_by_chance(std::string what, double p, std::string measured, std::string statement) {
  return {std::move(what), fmt::format("{}; p = {:.3g}", measured, p), std::move(statement), !(p > trial_alpha)};
}

std::string table_of(const std::vector<TrialResult>& results) {
  std::vector<std::vector<std::string>> rows;
  for (const TrialResult& r : results)
    rows.push_back({r.what, r.measured, r.stated.empty() ? "-" : r.stated,
                    r.stated.empty() ? "-"
                    : r.outside      ? "**no**"
                                     : "yes"});
  return markdown_table({"what", "measured", "stated", "within stated"}, rows);
}

}  // namespace gpf
