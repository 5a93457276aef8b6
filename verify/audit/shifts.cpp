#include "verify/audit/shifts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/stats/hypothesis.hpp"
#include "gpf/stats/step_down.hpp"

namespace gpf {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool measured(double x) { return std::isfinite(x); }
bool all_measured(const ClaimEstimate& e) { return std::all_of(e.values.begin(), e.values.end(), measured); }
bool none_measured(const ClaimEstimate& e) { return std::none_of(e.values.begin(), e.values.end(), measured); }

bool in_band(const ClaimEstimate& e) {
  return std::all_of(e.values.begin(), e.values.end(), [&](double v) { return e.band.contains(v); });
}

/// Half the tolerance: shifts within it are as good as none. Infinite bands have none.
double margin_of(const Shift& s) {
  const double width = std::min(s.before.band.width(), s.after.band.width());
  return std::isfinite(width) ? width / 4 : 0;
}

bool within_margin(const Shift& s, double lo, double hi) {
  const double margin = margin_of(s);
  return margin > 0 && -margin <= lo && hi <= margin;
}

double mean_of(const ClaimEstimate& e) { return summarise(e.values).mean; }

void judge_identity(Shift& s) {
  s.difference = mean_of(s.after) - mean_of(s.before);
  s.interval = {s.difference, s.difference};
  if (s.before.values.empty() || s.after.values.empty() || none_measured(s.before) != none_measured(s.after)) {
    s.moved = Moved::yes;
  } else if (all_measured(s.before) && all_measured(s.after)) {
    const auto [lo_before, hi_before] = std::minmax_element(s.before.values.begin(), s.before.values.end());
    const auto [lo_after, hi_after] = std::minmax_element(s.after.values.begin(), s.after.values.end());
    const auto [smaller, larger] = std::minmax({*lo_after - *lo_before, *hi_after - *hi_before});
    const bool exact = s.before.exact || s.after.exact, both_out = !in_band(s.before) && !in_band(s.after);
    const double width = std::min(s.before.band.width(), s.after.band.width());
    const double moved = std::max(std::abs(smaller), std::abs(larger));
    if (exact ? in_band(s.before) != in_band(s.after) || (both_out && moved > width / 2) : moved > width)
      s.moved = Moved::yes;
    if (in_band(s.before) && in_band(s.after) && within_margin(s, smaller, larger)) s.moved = Moved::equivalent;
  }
}

bool is_identity(const Shift& s) {
  return s.before.exact || s.after.exact || (s.before.values.size() == 1 && s.after.values.size() == 1);
}

void require_two(const Shift& s) {
  if (s.before.values.size() < 2 || s.after.values.size() < 2)
    throw InputError(fmt::format("{}, {}: {} replica(s) before and {} after", s.before.claim, s.before.label,
                                 s.before.values.size(), s.after.values.size()),
                     "a shift is measured by the scatter of the replicas", "run at least two of each version");
}

/// Smallest p-value that this number's relabellings can give. With equal counts the sides can be exchanged.
double smallest_p(const Shift& s) {
  const std::size_t na = s.after.values.size(), nb = s.before.values.size();
  return (na == nb ? 2 : 1) / combinations(na + nb, na);
}

double detectable_shift(const Shift& s, const WelchTest& test, double critical, double alpha) {
  if (!std::isfinite(critical) || smallest_p(s) > alpha) return infinity;
  const double p = std::max(std::erfc(critical / std::sqrt(2.0)), 1e-30);
  const double f = test.degrees_of_freedom;
  return (-student_t_quantile(p / 2, f) + student_t_quantile(0.9, f)) * test.error;
}

void judge_statistically(std::vector<Shift*>& tested, const ShiftOptions& options, Shifts& result) {
  std::vector<TwoSides> family;
  for (const Shift* s : tested) family.push_back({s->after.values, s->before.values, s->before.share});
  const StepDown found = step_down_max_t(family, options.permutations, options.seed);
  result.global_p = found.global_p;
  result.critical = found.critical(options.family_alpha);
  for (std::size_t k = 0; k < tested.size(); ++k) {
    Shift& s = *tested[k];
    const WelchTest test = welch(summarise(s.after.values), summarise(s.before.values));
    s.difference = test.difference;
    s.error = test.error;
    s.interval = test.interval(0.05);
    s.p_adjusted = found.p_adjusted[k];
    s.p_single = found.p_single[k];
    s.detectable = detectable_shift(s, test, result.critical, options.family_alpha);
    if (s.p_adjusted <= options.family_alpha) {
      s.moved = Moved::yes;
    } else if (within_margin(s, s.interval.lo, s.interval.hi)) {
      s.moved = Moved::equivalent;
    }
  }
}

}  // namespace

bool Shifts::identity_moved() const {
  return std::any_of(identities.begin(), identities.end(), [](const Shift& s) { return s.moved == Moved::yes; });
}

bool Shifts::any_named(double family_alpha) const {
  return identity_moved() ||
         std::any_of(all.begin(), all.end(), [&](const Shift& s) { return s.p_adjusted <= family_alpha; });
}

Shifts compare(std::span<const ClaimEstimate> before, std::span<const ClaimEstimate> after,
               const ShiftOptions& options) {
  if (before.size() != after.size())
    throw InputError("numbers without partners", fmt::format("{} before, {} after", before.size(), after.size()),
                     "compare those that both sides have");
  Shifts result;
  for (std::size_t k = 0; k < before.size(); ++k) {
    Shift s;
    s.before = before[k];
    s.after = after[k];
    (is_identity(s) ? result.identities : result.all).push_back(std::move(s));
  }

  for (Shift& s : result.identities) {
    if (same_bits(s.before.values, s.after.values)) {
      s.moved = Moved::no;
    } else {
      judge_identity(s);
    }
  }
  std::vector<Shift*> tested;
  for (Shift& s : result.all) {
    if (same_bits(s.before.values, s.after.values)) {
      s.moved = Moved::no;
    } else if (all_measured(s.before) && all_measured(s.after)) {
      require_two(s);
      tested.push_back(&s);
    } else {
      s.difference = s.error = s.detectable = unknown;
      s.interval = {-infinity, infinity};
    }
  }
  judge_statistically(tested, options, result);
  return result;
}

}  // namespace gpf
