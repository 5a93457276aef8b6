#include "verify/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gpf/base/error.hpp"
#include "gpf/stats/hypothesis.hpp"
#include "gpf/stats/proportion.hpp"
#include "verify/verdict_summary.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 3> outcomes{"pass", "fail", "inconclusive"};

bool all_finite(const std::vector<double>& values) {
  return !values.empty() && std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Outcome exact_outcome(const Check& check) {
  if (!all_finite(check.values)) return Outcome::inconclusive;
  const bool inside =
      std::all_of(check.values.begin(), check.values.end(), [&](double v) { return check.band.contains(v); });
  return inside ? Outcome::pass : Outcome::fail;
}

Interval range_of(const std::vector<double>& values) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!all_finite(values)) return {-infinity, infinity};
  const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
  return {*lo, *hi};
}

/// Whether `replicas` like these would have an interval of half width `distance` or less.
bool decides(const ReplicaSummary& seen, double distance, double alpha, double replicas) {
  return student_t_quantile(1 - alpha, replicas - 1) * seen.deviation <= distance * std::sqrt(replicas);
}

/// The number of replicas that would decide a check if mean and deviation stayed as they are; infinite on an edge.
double replicas_to_decide(const ReplicaSummary& seen, Interval band, double alpha) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double distance = std::min(std::abs(seen.mean - band.lo), std::abs(seen.mean - band.hi));
  if (seen.count < 2 || !(distance > 0) || !std::isfinite(seen.deviation)) return infinity;
  constexpr double most = 1e6;
  if (!decides(seen, distance, alpha, most)) return infinity;
  double too_few = 1, enough = most;
  while (enough - too_few > 1) {
    const double middle = std::floor((too_few + enough) / 2);
    (decides(seen, distance, alpha, middle) ? enough : too_few) = middle;
  }
  return enough;
}

Share share_of(const Check& check) {
  return {static_cast<std::size_t>(std::count(check.values.begin(), check.values.end(), 1.0)), check.values.size()};
}

/// About the number of replicas at which a share like this one would be decided; infinite on an edge and near it.
double replicas_to_decide(const Share& seen, Interval band, double pass_alpha, double fail_alpha) {
  constexpr std::size_t most = 1000;
  for (std::size_t trials = seen.trials + 1; trials <= most; trials += 1 + trials / 8) {
    const Share more{static_cast<std::size_t>(std::lround(seen.value() * static_cast<double>(trials))), trials};
    if (outside_band_p_value(more, band) <= fail_alpha || inside_band_p_value(more, band) <= pass_alpha)
      return static_cast<double>(trials);
  }
  return std::numeric_limits<double>::infinity();
}

double outside_p_value(const JudgedCheck& c) {
  return c.check.share ? outside_band_p_value(share_of(c.check), c.check.band)
                       : outside_band_p_value(c.summary, c.check.band);
}

/// Everything but failure, which needs all checks together.
JudgedCheck first_judgement(const Check& check, double alpha, double share_alpha) {
  JudgedCheck judged{check, summarise(check.values), {}, Outcome::inconclusive, 0};
  if (check.exact) {
    judged.interval = range_of(check.values);
    judged.outcome = exact_outcome(check);
    return judged;
  }
  if (!all_finite(check.values)) {
    judged.interval = range_of({});
    return judged;
  }
  judged.interval = check.share ? proportion_interval(share_of(check), share_alpha) : t_interval(judged.summary, alpha);
  if (check.values.size() > 1 && check.band.contains(judged.interval)) judged.outcome = Outcome::pass;
  return judged;
}

void find_failures(std::vector<JudgedCheck>& checks, double alpha, double share_alpha) {
  std::vector<JudgedCheck*> tested;
  std::vector<double> p_values;
  for (JudgedCheck& c : checks)
    if (!c.check.exact && c.check.values.size() > 1 && all_finite(c.check.values)) {
      tested.push_back(&c);
      p_values.push_back(outside_p_value(c));
    }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t k = 0; k < tested.size(); ++k)
    if (adjusted[k] <= alpha) tested[k]->outcome = Outcome::fail;
  for (JudgedCheck& c : checks)
    if (c.outcome == Outcome::inconclusive && !c.check.exact) {
      // Outside of its band a check needs Holm's most demanding level.
      const double strict = alpha / static_cast<double>(std::max<std::size_t>(tested.size(), 1));
      if (c.check.share && all_finite(c.check.values)) {
        c.replicas_needed = replicas_to_decide(share_of(c.check), c.check.band, share_alpha, strict);
        continue;
      }
      const bool inside = c.check.band.contains(c.summary.mean);
      c.replicas_needed = replicas_to_decide(c.summary, c.check.band, inside ? alpha : strict);
    }
}

Outcome outcome_of(const std::vector<JudgedCheck>& checks, const std::vector<HealthCheck>& health) {
  const auto count = [&](Outcome outcome) {
    return std::count_if(checks.begin(), checks.end(),
                         [outcome](const JudgedCheck& c) { return c.outcome == outcome; });
  };
  const bool healthy = std::all_of(health.begin(), health.end(), [](const HealthCheck& h) { return h.passed; });
  if (!healthy || checks.empty()) return Outcome::inconclusive;
  if (count(Outcome::fail) > 0) return Outcome::fail;
  return count(Outcome::inconclusive) > 0 ? Outcome::inconclusive : Outcome::pass;
}

}  // namespace

std::vector<int> looks_up_to(int most_replicas) {
  if (most_replicas < 4) return {1};
  std::vector<int> looks;
  for (int replicas = 4; replicas <= std::min(most_replicas, 32); replicas *= 2) looks.push_back(replicas);
  return looks;
}

Verdict judge(const Claim& claim, Tier tier, const Evidence& evidence, int replicas, int look, int looks) {
  if (look < 1 || look > looks)
    throw InputError(fmt::format("look {} of {}", look, looks), "looks are counted from 1", "pass a look that exists");
  Verdict verdict;
  verdict.claim_id = claim.id;
  verdict.tier = tier;
  verdict.expected = claim.expected;
  verdict.replicas = replicas;
  verdict.look = look;
  verdict.alpha = alpha_per_direction / looks;
  verdict.claim_hash = claim.text_hash;
  const double share_alpha = share_alpha_per_direction / looks;
  for (const Check& check : evidence.checks)
    verdict.checks.push_back(first_judgement(check, verdict.alpha, share_alpha));
  find_failures(verdict.checks, verdict.alpha, share_alpha);
  verdict.health = evidence.health;
  verdict.outcome = outcome_of(verdict.checks, verdict.health);
  verdict.green = agrees(verdict.outcome, verdict.expected);
  verdict.plot = evidence.plot;
  verdict.drawings = evidence.drawings;
  verdict.notes = evidence.notes;
  if (const std::string note = unused_tolerance(verdict.checks); !note.empty()) verdict.notes.push_back(note);
  verdict.cpu_seconds = evidence.extra_cpu_seconds;
  verdict.summary = summary_of(verdict);
  return verdict;
}

bool agrees(Outcome outcome, Expectation expected) {
  switch (expected) {
    case Expectation::reproduced:
      return outcome == Outcome::pass;
    case Expectation::refuted:
      return outcome == Outcome::fail;
    default:
      return outcome == Outcome::inconclusive;
  }
}

std::string_view name_of(Outcome outcome) { return outcomes[static_cast<std::size_t>(outcome)]; }

Outcome outcome_named(std::string_view name) {
  const auto found = std::find(outcomes.begin(), outcomes.end(), name);
  if (found == outcomes.end())
    throw InputError(fmt::format("unknown outcome '{}'", name),
                     fmt::format("it is one of {}", fmt::join(outcomes, ", ")), "write one of these");
  return static_cast<Outcome>(found - outcomes.begin());
}

}  // namespace gpf
