#include "verify/trial/audit_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "gpf/stats/uniformity.hpp"
#include "verify/audit/findings.hpp"
#include "verify/audit/shifts.hpp"
#include "verify/estimators/parallel.hpp"

namespace gpf {
namespace {

/// A thousandth is the smallest p-value then: alpha .05 and .01 are reached exactly.
constexpr int relabellings = 999;

std::vector<ClaimEstimate> estimates(const TrialRuns& runs, std::size_t first) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto scenes = trial_scenes();
  std::vector<ClaimEstimate> result;
  for (std::size_t s = 0; s < runs.runs.size(); ++s)
    for (std::size_t k = 0; k < runs.labels[s].size(); ++k) {
      ClaimEstimate e{.claim = scenes[s].name, .label = runs.labels[s][k], .values = {}, .band = {-infinity, infinity}};
      for (std::size_t r = first; r < first + replicas_a_side; ++r) e.values.push_back(runs.runs[s][r].values[k]);
      result.push_back(std::move(e));
    }
  return result;
}

/// p-value of each number (first index) in each audit, and global ones.
struct PValues {
  std::vector<std::vector<double>> single;
  std::vector<double> global;
};

PValues p_values(const std::vector<Shifts>& audits) {
  PValues p;
  p.single.resize(audits.front().all.size());
  for (const Shifts& audit : audits) {
    p.global.push_back(audit.global_p);
    for (std::size_t k = 0; k < audit.all.size(); ++k) p.single[k].push_back(audit.all[k].p_single);
  }
  return p;
}

Series distribution_function(std::string label, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  Series series{.label = std::move(label), .style = SeriesStyle::line};
  const std::size_t step = std::max<std::size_t>(1, values.size() / 400);
  for (std::size_t k = 0; k < values.size(); k += step) {
    series.x.push_back(values[k]);
    series.y.push_back(static_cast<double>(k + 1) / static_cast<double>(values.size()));
  }
  return series;
}

}  // namespace

AuditTrial try_audits(const TrialRuns& runs) {
  std::vector<Shifts> audits(runs.runs.front().size() / (2 * replicas_a_side));
  for_each_in_parallel(audits.size(), [&](std::size_t n) {
    const std::size_t first = 2 * replicas_a_side * n;
    audits[n] = compare(estimates(runs, first), estimates(runs, first + replicas_a_side),
                        {.permutations = relabellings, .seed = n + 1});
  });
  const PValues p = p_values(audits);
  AuditTrial trial{.audits = audits.size(), .numbers = p.single.size(), .results = {}, .distribution = {}};

  const auto count = [&](auto&& of) {
    return static_cast<std::size_t>(std::count_if(audits.begin(), audits.end(), of));
  };
  const ShiftOptions stated;
  const double global_alpha = ClassLimits{}.global_alpha;
  trial.results.push_back(at_most("audits that name a number", count([](const Shifts& s) { return s.any_named(); }),
                                  audits.size(), stated.family_alpha));
  trial.results.push_back(at_most("audits whose global answer is that something moved",
                                  count([&](const Shifts& s) { return s.global_p <= global_alpha; }), audits.size(),
                                  global_alpha));

  // Numbers of one audit depend on one another. One of each audit, in turn, are independent; and each number's p-values
  // over the audits are, the worst of which counts for as many as there are numbers.
  std::vector<double> in_turn, all;
  for (std::size_t n = 0; n < audits.size(); ++n) in_turn.push_back(p.single[n % p.single.size()][n]);
  double worst = 1;
  for (const std::vector<double>& number : p.single) {
    worst = std::min(worst, uniformity_p_value(number));
    all.insert(all.end(), number.begin(), number.end());
  }
  const auto uniform = [&](const char* what, const std::vector<double>& values) {
    trial.results.push_back(expected_by_chance(
        what, uniformity_p_value(values), fmt::format("{} p-values, Kolmogorov-Smirnov", values.size()), "uniform"));
  };
  uniform("p-values of single numbers, one of each audit in turn", in_turn);
  uniform("global p-values", p.global);
  trial.results.push_back(expected_by_chance(
      "p-values of each number over the audits, the least uniform of them",
      std::min(1.0, worst * static_cast<double>(p.single.size())),
      fmt::format("{} numbers, Kolmogorov-Smirnov with Bonferroni's correction", p.single.size()), "uniform"));

  trial.distribution = {.title = "p-values of audits of unchanged physics",
                        .xlabel = "p",
                        .ylabel = "share of p-values at most p",
                        .xrange = std::pair{0.0, 1.0},
                        .yrange = std::pair{0.0, 1.0},
                        .series = {distribution_function("single numbers, all audits", all),
                                   distribution_function("global", p.global),
                                   {.label = "uniform", .style = SeriesStyle::line, .x = {0, 1}, .y = {0, 1}}}};
  return trial;
}

}  // namespace gpf
