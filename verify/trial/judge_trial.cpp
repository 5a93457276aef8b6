#include "verify/trial/judge_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "gpf/base/hash.hpp"
#include "gpf/io/markdown.hpp"
#include "verify/estimators/normal_stress_crossing.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/judge.hpp"

namespace gpf {
namespace {

Outcome judged_outcome(const SyntheticClaim& claim, std::uint64_t key) {
  const std::vector<int> looks = looks_up_to(claim.most_replicas);
  Draws draws(key);
  std::vector<ReplicaValues> replicas;
  Outcome outcome = Outcome::inconclusive;
  for (std::size_t look = 0; look < looks.size() && outcome == Outcome::inconclusive; ++look) {
    while (replicas.size() < static_cast<std::size_t>(looks[look])) replicas.push_back(claim.replica(draws));
    Evidence evidence;
    evidence.checks = claim.checks(replicas);
    outcome = judge({}, Tier::quick, evidence, looks[look], static_cast<int>(look) + 1, static_cast<int>(looks.size()))
                  .outcome;
  }
  return outcome;
}

JudgedKind judged_kind(const SyntheticClaim& claim, const OutcomeCounts& n) {
  const std::string what = fmt::format("{}, {}", claim.kind, claim.truth);
  return {claim.kind, claim.truth, n, at_most(fmt::format("{}: pass", what), n.pass, n.claims, claim.most_pass),
          at_most(fmt::format("{}: fail", what), n.fail, n.claims, claim.most_fail)};
}

Plot power_plot(std::size_t claims) {
  constexpr std::size_t points = 25;
  Plot plot{.title = "One check, deviation half the tolerance, up to 16 replicas",
            .xlabel = "truth, in tolerances from the centre of the band",
            .ylabel = "share of the claims",
            .yrange = std::pair{0.0, 1.0}};
  for (const bool one_sided : {false, true}) {
    std::array<OutcomeCounts, points> counts;
    const auto truth = [](std::size_t k) { return 3.0 * static_cast<double>(k) / (points - 1); };
    for_each_in_parallel(points, [&](std::size_t k) {
      counts[k] = judged_outcomes(value_claim(one_sided ? 1 - truth(k) : truth(k), one_sided), claims);
    });
    for (const bool pass : {true, false}) {
      Series series{.label = fmt::format("{}, {}", one_sided ? "one-sided" : "two-sided", pass ? "pass" : "fail"),
                    .style = one_sided ? SeriesStyle::line : SeriesStyle::points};
      for (std::size_t k = 0; k < points; ++k) {
        const double n = static_cast<double>(claims);
        const double rate = static_cast<double>(pass ? counts[k].pass : counts[k].fail) / n;
        series.x.push_back(truth(k));
        series.y.push_back(rate);
        if (!one_sided) series.yerr.push_back(std::sqrt(rate * (1 - rate) / n));
      }
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

/// As the claims' notes give it: from both ends of a bracket, 8 replicas, ends at 1.5 and
/// -3 deviations of the truth.
std::vector<TrialResult> fieller_misses(std::size_t claims) {
  constexpr std::size_t replicas = 8;
  std::size_t low = 0, high = 0, unbounded = 0;
  for (std::size_t n = 0; n < claims; ++n) {
    Draws draws(mix(hash_text("fieller") + n));
    std::vector<double> below, above;
    for (std::size_t r = 0; r < replicas; ++r) {
      below.push_back(1 + draws.normal() / 1.5);
      above.push_back(-2 + draws.normal() / 1.5);
    }
    const ReplicaSummary b = summarise(below), a = summarise(above);
    const Crossing crossing =
        crossing_between(0, {b.mean, b.standard_error()}, 3, {a.mean, a.standard_error()}, replicas);  // truth: 1
    low += crossing.interval.hi < 1;
    high += crossing.interval.lo > 1;
    unbounded += !crossing.bounded();
  }
  const auto row = [&](const char* what, std::size_t hits, double most) {
    return at_most(fmt::format("Fieller's interval of a zero crossing: {}", what), hits, claims, most);
  };
  return {row("misses the truth", low + high, 2 * crossing_alpha), row("ends below the truth", low, crossing_alpha),
          row("begins above the truth", high, crossing_alpha), row("unbounded", unbounded, 1)};
}

}  // namespace

OutcomeCounts judged_outcomes(const SyntheticClaim& claim, std::size_t claims) {
  OutcomeCounts counts{.claims = claims};
  const std::uint64_t key = hash_text(fmt::format("{}, {}", claim.kind, claim.truth));
  for (std::size_t n = 0; n < claims; ++n) {
    const Outcome outcome = judged_outcome(claim, mix(key + n));
    counts.pass += outcome == Outcome::pass;
    counts.fail += outcome == Outcome::fail;
  }
  return counts;
}

std::vector<TrialResult> JudgeTrial::results() const {
  std::vector<TrialResult> all;
  for (const JudgedKind& k : kinds) all.push_back(k.pass), all.push_back(k.fail);
  all.insert(all.end(), fieller.begin(), fieller.end());
  return all;
}

std::string table_of(const std::vector<JudgedKind>& kinds) {
  const auto stated = [](const TrialResult& r) { return r.stated.empty() ? std::string("-") : r.stated; };
  std::vector<std::vector<std::string>> rows;
  for (const JudgedKind& k : kinds) {
    const OutcomeCounts& n = k.counts;
    const bool any = !k.pass.stated.empty() || !k.fail.stated.empty();
    rows.push_back({k.kind, k.truth, fmt::format("{}", n.claims), rate_text(n.pass, n.claims), stated(k.pass),
                    rate_text(n.fail, n.claims), stated(k.fail), rate_text(n.claims - n.pass - n.fail, n.claims),
                    !any                               ? "-"
                    : k.pass.outside || k.fail.outside ? "**no**"
                                                       : "yes"});
  }
  return markdown_table(
      {"kind", "truth", "claims", "pass", "stated", "fail", "stated", "inconclusive", "within stated"}, rows);
}

JudgeTrial try_judge(std::size_t claims) {
  const std::vector<SyntheticClaim> kinds = synthetic_claims();
  std::vector<OutcomeCounts> counts(kinds.size());
  for_each_in_parallel(kinds.size(), [&](std::size_t k) {
    counts[k] = judged_outcomes(kinds[k], kinds[k].large ? claims / 4 : claims);
  });
  JudgeTrial trial;
  for (std::size_t k = 0; k < kinds.size(); ++k) trial.kinds.push_back(judged_kind(kinds[k], counts[k]));
  trial.fieller = fieller_misses(claims);
  trial.power = power_plot(claims / 8);
  return trial;
}

}  // namespace gpf
