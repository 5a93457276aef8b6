#include "verify/trial/seed_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "gpf/base/vec2.hpp"
#include "gpf/scene/start.hpp"
#include "gpf/stats/hypothesis.hpp"
#include "gpf/stats/uniformity.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/store.hpp"

namespace gpf {
namespace {

std::size_t repeats(std::vector<std::uint64_t> values) {
  std::sort(values.begin(), values.end());
  return values.size() - static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
}

TrialResult none_repeated(std::string what, const std::vector<std::uint64_t>& values) {
  const std::size_t found = repeats(values);
  return {std::move(what), fmt::format("{} of {}", found, values.size()), "0", found > 0};
}

SceneFile with_restitution(SceneFile file, double restitution) {
  file.scene.normal_restitution = restitution;
  return file;
}

std::vector<std::uint64_t> many_seeds(std::size_t count) {
  constexpr std::size_t scenes = 1000;
  const SceneFile file = trial_scenes().front();
  std::vector<std::uint64_t> seeds(count / scenes * scenes);
  for_each_in_parallel(scenes, [&](std::size_t s) {
    const auto row = static_cast<double>(s % 4), place = static_cast<double>(s / 4);
    const SceneFile scene = with_restitution(file, 0.5 + row / 10 + place * std::pow(10.0, -4 - row));
    for (std::size_t r = 0; r < count / scenes; ++r)
      seeds[s * (count / scenes) + r] = replica_of(scene, static_cast<int>(r), 0).scene.seed;
  });
  return seeds;
}

/// Correlation of all velocity components of two starts, in its standard deviations. Start velocities have no mean and
/// a fixed sum of squares: independent ones are two points of a sphere in 2 N - 2 dimensions, and the cosine of their
/// angle has mean 0 and variance 1/(2 N - 2).
double start_correlation(const State& a, const State& b) {
  double product = 0, squares = 0;
  for (std::size_t k = 0; k < a.velocity.size(); ++k) {
    product += a.velocity[k].x * b.velocity[k].x + a.velocity[k].y * b.velocity[k].y;
    squares += square(a.velocity[k].x) + square(a.velocity[k].y);
  }
  return product / squares * std::sqrt(2 * static_cast<double>(a.velocity.size()) - 2);
}

using Partner = std::function<State(const SceneFile&, int replica)>;

std::vector<TrialResult> start_correlations(std::string what, std::size_t pairs, const Partner& first,
                                            const Partner& second) {
  const SceneFile file = trial_scenes().front();
  std::vector<double> z(pairs), p;
  for_each_in_parallel(pairs, [&](std::size_t k) {
    const int replica = 2 * static_cast<int>(k);
    z[k] = start_correlation(first(file, replica), second(file, replica));
  });
  for (const double x : z) p.push_back(std::erfc(x / std::sqrt(2.0)) / 2);
  const double chi2 = std::inner_product(z.begin(), z.end(), z.begin(), 0.0), upper = chi2_p_value(chi2, pairs);
  return {expected_by_chance(fmt::format("start velocities, {}: sum of z^2", what), 2 * std::min(upper, 1 - upper),
                             fmt::format("chi square {:.1f} over {} pairs", chi2, pairs), "independent"),
          expected_by_chance(fmt::format("start velocities, {}: distribution of z", what), uniformity_p_value(p),
                             fmt::format("{} pairs, Kolmogorov-Smirnov", pairs), "normal")};
}

std::vector<double> values_of(const std::vector<TrialRun>& runs, std::size_t number) {
  std::vector<double> values;
  for (const TrialRun& r : runs) values.push_back(r.values[number]);
  return values;
}

/// Correlation coefficient of replica r of `a` with replica r + lag of `b`, over pairs that share no replica of the
/// same scene, as a normal variable of unit variance (Fisher's transform).
double correlation_z(const std::vector<double>& a, const std::vector<double>& b, std::size_t lag) {
  std::vector<double> x, y;
  const std::size_t block = std::max<std::size_t>(1, 2 * lag);
  for (std::size_t r = 0; r + lag < a.size(); ++r)
    if (lag == 0 || r % block < lag) x.push_back(a[r]), y.push_back(b[r + lag]);
  const ReplicaSummary sx = summarise(x), sy = summarise(y);
  double product = 0;
  for (std::size_t k = 0; k < x.size(); ++k) product += (x[k] - sx.mean) * (y[k] - sy.mean);
  const double n = static_cast<double>(x.size());
  return std::atanh(product / ((n - 1) * sx.deviation * sy.deviation)) * std::sqrt(n - 3);
}

/// The largest |z| of the numbers, which depend on one another: with Bonferroni's correction.
TrialResult largest_correlation(std::string what, const std::vector<double>& z) {
  double largest = 0;
  for (const double x : z) largest = std::max(largest, std::abs(x));
  const double count = static_cast<double>(z.size());
  return expected_by_chance(std::move(what), std::min(1.0, count * std::erfc(largest / std::sqrt(2.0))),
                            fmt::format("largest |z| of {} numbers: {:.2f}", z.size(), largest), "independent");
}

std::vector<TrialResult> run_correlations(const TrialRuns& runs) {
  std::vector<TrialResult> results;
  for (const std::size_t lag : {1U, 2U, 16U}) {
    std::vector<double> z;
    for (const auto& scene : runs.runs)
      for (std::size_t k = 0; k < scene.front().values.size(); ++k) {
        const std::vector<double> values = values_of(scene, k);
        z.push_back(correlation_z(values, values, lag));
      }
    results.push_back(largest_correlation(fmt::format("measured numbers, replicas r and r + {}", lag), z));
  }
  std::vector<double> z;  // the first two scenes differ by their restitution alone
  for (std::size_t k = 0; k < runs.labels[0].size(); ++k)
    z.push_back(correlation_z(values_of(runs.runs[0], k), values_of(runs.runs[1], k), 0));
  results.push_back(largest_correlation("measured numbers, the same replica of e_n .90 and .91", z));
  return results;
}

}  // namespace

std::vector<TrialResult> try_seeds(const TrialRuns& runs, std::size_t seeds, std::size_t pairs) {
  std::vector<TrialResult> results;
  const auto add = [&](const std::vector<TrialResult>& more) {
    results.insert(results.end(), more.begin(), more.end());
  };
  add({none_repeated("repeated seeds", many_seeds(seeds))});
  std::vector<std::uint64_t> hashes;
  for (const auto& scene : runs.runs)
    for (const TrialRun& r : scene) hashes.push_back(r.trace_hash);
  add({none_repeated("repeated trace hashes of runs", hashes)});

  const Partner itself = [](const SceneFile& f, int r) { return start_state(replica_of(f, r, 0).scene); };
  add(start_correlations("replicas r and r + 1", pairs, itself,
                         [](const SceneFile& f, int r) { return start_state(replica_of(f, r + 1, 0).scene); }));
  add(start_correlations("the same replica of scenes whose e_n differs by 1e-9", pairs, itself,
                         [](const SceneFile& f, int r) {
                           const double other = f.scene.normal_restitution + 1e-9;
                           return start_state(replica_of(with_restitution(f, other), r, 0).scene);
                         }));
  add(start_correlations(
      "the same replica of release seeds 1 and 2", pairs,
      [](const SceneFile& f, int r) { return start_state(replica_of(f, r, 1).scene); },
      [](const SceneFile& f, int r) { return start_state(replica_of(f, r, 2).scene); }));
  add(run_correlations(runs));
  return results;
}

}  // namespace gpf
