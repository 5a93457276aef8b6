#include "verify/health.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "gpf/base/vec2.hpp"
#include "gpf/event/position_grid.hpp"
#include "gpf/measure/tallies.hpp"
#include "gpf/stats/blocks.hpp"
#include "verify/drift.hpp"
#include "verify/main_fields.hpp"

namespace gpf {
namespace {

/// A statistical test of one field of one scene.
struct FieldTest {
  std::string what;
  double p;  ///< two-sided
  double measured;
};

/// A field of a scene: block series of each replica.
using Fields = std::map<std::string, std::vector<std::vector<double>>>;

Fields fields_of(const SceneRecords& records) {
  Fields fields;
  for (const auto& [scene, replicas] : records)
    for (const Record& record : replicas)
      for (BlockedField& field : main_fields(record))
        fields[fmt::format("{}, {}", scene, field.name)].push_back(std::move(field.blocks));
  return fields;
}

double z_of(double p) { return gsl_cdf_ugaussian_Qinv(std::max(p, 1e-300) / 2); }

HealthCheck check_drift(const Fields& fields) {
  const std::string name = "steady: the averaging window's halves agree, and a longer start-up cut changes nothing";
  std::vector<FieldTest> tests;
  for (const auto& [what, replicas] : fields) {
    for (const auto& blocks : replicas)
      if (blocks.size() < fewest_blocks_of_a_steady_run)
        return {
            name, false,
            fmt::format("{}: {} blocks are too few to see a drift, {} are needed: lower the scene's sample_interval "
                        "or measure longer",
                        what, blocks.size(), fewest_blocks_of_a_steady_run)};
    const DriftTest drift = drift_test(replicas);
    if (std::isnan(drift.halves_p)) return {name, false, what + ": one replica cannot show it"};
    tests.push_back({what + ", second half against first", drift.halves_p, z_of(drift.halves_p)});
    tests.push_back({what + ", first quarter against the rest", drift.first_quarter_p, z_of(drift.first_quarter_p)});
  }
  if (tests.empty()) return {name, true, "no scene of the claim has a steady state to drift from"};
  const auto worst = std::min_element(tests.begin(), tests.end(), [](auto& a, auto& b) { return a.p < b.p; });
  const double limit = health_false_alarm_rate / static_cast<double>(tests.size());
  return {name, worst->p >= limit,
          fmt::format("largest of {} |z|: {:.1f}, limit {:.1f} ({})", tests.size(), worst->measured, z_of(limit),
                      worst->what),
          std::min(1.0, static_cast<double>(tests.size()) * worst->p)};
}

/// Correlation of a block with the next one plus that with the one after it, averaged over the replicas.
double neighbour_correlation(const std::vector<std::vector<double>>& replicas) {
  double total = 0;
  for (const auto& blocks : replicas)
    for (const std::size_t lag : {1U, 2U})
      total += gsl_stats_correlation(blocks.data(), 1, blocks.data() + lag, 1, blocks.size() - lag);
  return total / static_cast<double>(replicas.size());
}

/// Block error over scatter of the replicas' means, with the p-value of "they measure the same".
FieldTest compare_errors(const std::string& what, const std::vector<std::vector<double>>& replicas) {
  std::vector<double> means;
  double squared_error = 0, freedom = 0;
  for (const auto& blocks : replicas) {
    const BlockError error = block_error(blocks);
    means.push_back(error.mean);
    squared_error += square(error.error) / static_cast<double>(replicas.size());
    freedom += static_cast<double>(error.blocks - 1);
  }
  const double variance = square(summarise(means).deviation), ratio = std::sqrt(squared_error / variance);
  const double f = variance / squared_error, scatter_freedom = static_cast<double>(means.size() - 1);
  const double tail =
      std::min(gsl_cdf_fdist_P(f, scatter_freedom, freedom), gsl_cdf_fdist_Q(f, scatter_freedom, freedom));
  return {what, std::min(1.0, 2 * tail), ratio};
}

HealthCheck check_block_errors(const Fields& fields) {
  const std::string name = "replicas scatter no less than their block errors";
  std::vector<FieldTest> tests;
  std::string explained;
  for (const auto& [what, replicas] : fields) {
    const bool enough = replicas.size() >= 8 && std::all_of(replicas.begin(), replicas.end(),
                                                            [](const auto& blocks) { return blocks.size() >= 20; });
    if (!enough) continue;
    const FieldTest test = compare_errors(what, replicas);
    const double correlation = neighbour_correlation(replicas);
    if (test.measured > 2 && 1 + 2 * correlation <= 0.25)
      explained += fmt::format("; {}: {:.2f}, for neighbouring blocks undo each other, correlations {:.2f}", what,
                               test.measured, correlation);
    else
      tests.push_back(test);
  }
  if (tests.empty()) return {name, true, "too few to tell: it takes 8 replicas and 20 blocks" + explained};
  const double limit = health_false_alarm_rate / static_cast<double>(tests.size());
  const auto departs = [limit](const FieldTest& t) { return !(t.p >= limit); };
  const auto [least, largest] = std::minmax_element(
      tests.begin(), tests.end(), [](const FieldTest& a, const FieldTest& b) { return a.measured < b.measured; });
  const bool failed =
      std::any_of(tests.begin(), tests.end(), [&](const FieldTest& t) { return !(t.measured <= 2) && departs(t); });
  std::string detail = fmt::format(
      "largest of {} ratios of block error to scatter: {:.2f} ({}; probability of chance "
      "{:.2g}, limit {:.2g})",
      tests.size(), largest->measured, largest->what, largest->p, limit);
  if (least->measured < 0.5 && departs(*least))
    detail += fmt::format("; least: {:.2f} ({}): its runs keep to states of their own, and only the scatter knows",
                          least->measured, least->what);
  return {name, !failed, detail + explained, std::min(1.0, static_cast<double>(tests.size()) * largest->p)};
}

HealthCheck check_hashes(const SceneRecords& records) {
  std::size_t compared = 0;
  for (const auto& [scene, replicas] : records) {
    std::set<std::uint64_t> seen;
    for (const Record& record : replicas)
      if (!seen.insert(record.trace_hash).second)
        return {"replicas differ", false,
                fmt::format("two replicas of {} have the same trace hash: they are one replica", scene)};
    compared += replicas.size();
  }
  return {"replicas differ", true, fmt::format("{} runs, all trace hashes of a scene different", compared)};
}

HealthCheck check_overlaps(const SceneRecords& records) {
  double deepest = 0, limit = deepest_healthy_overlap;  // of the record that is nearest to its limit
  std::string where = "no run";
  for (const auto& [scene, replicas] : records)
    for (const Record& record : replicas) {
      const double overlap = record.deepest_overlap / record.scene.diameter(), allowed = healthy_overlap(record.scene);
      if (overlap / allowed >= deepest / limit || std::isnan(overlap))
        deepest = overlap, limit = allowed, where = scene;
    }
  return {"disks do not overlap", deepest <= limit,
          fmt::format("deepest {:.2g} d, limit {:.2g} d ({})", deepest, limit, where)};
}

/// |work - losses - gain| over the sum of their sizes and the mean kinetic energy.
double imbalance(const Record& record) {
  const TallyLayout layout(record.run);
  const auto total = [&](Tally tally) {
    double sum = 0;
    for (std::size_t b = 0; b < record.blocks; ++b)
      for (std::size_t k = 0; k < layout.extent(tally); ++k)
        sum += record.sums[b * layout.size() + layout.at(tally) + k];
    return sum;
  };
  const double work = total(Tally::gravity_work), pairs = total(Tally::pair_loss), walls = total(Tally::wall_loss),
               gain = total(Tally::energy_change), kinetic = total(Tally::energy) / total(Tally::samples);
  return std::abs(work - pairs - walls - gain) /
         (std::abs(work) + std::abs(pairs) + std::abs(walls) + std::abs(gain) + kinetic);
}

HealthCheck check_energy(const SceneRecords& records) {
  double largest = 0;
  std::string where = "no run";
  for (const auto& [scene, replicas] : records)
    for (const Record& record : replicas)
      if (const double value = imbalance(record); value >= largest || std::isnan(value)) largest = value, where = scene;
  return {"energy balances", largest <= largest_healthy_imbalance,
          fmt::format("largest imbalance {:.2g} of the energy turned over, limit {:.0e} ({})", largest,
                      largest_healthy_imbalance, where)};
}

}  // namespace

double healthy_overlap(const Scene& scene) {
  const double quantum = PositionGrid(scene.length(), 1).quantum() / scene.diameter();
  return std::max(deepest_healthy_overlap, 2 * quantum);
}

std::vector<HealthCheck> check_records(const Claim& claim, const SceneRecords& records, bool statistical) {
  if (records.empty()) return {};
  std::vector<HealthCheck> checks{check_hashes(records), check_overlaps(records), check_energy(records)};
  if (!statistical || claim.transient) return checks;
  const Fields fields = fields_of(records);
  checks.push_back(check_drift(fields));
  checks.push_back(check_block_errors(fields));
  return checks;
}

}  // namespace gpf
