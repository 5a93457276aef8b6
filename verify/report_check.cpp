#include "verify/report_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "verify/verdict_summary.hpp"

namespace gpf {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance of the mean to the nearest edge in standard errors; for an exact check that of its worst value in half
/// widths of the band, where that is finite. Infinite where there is no error.
double margin(const JudgedCheck& c) {
  const Interval band = c.check.band;
  if (c.check.exact) {
    const double half = band.width() / 2, room = std::min(c.interval.lo - band.lo, band.hi - c.interval.hi);
    return std::isfinite(half) && half > 0 ? room / half : room;
  }
  const double room = std::min(c.summary.mean - band.lo, band.hi - c.summary.mean), error = c.summary.standard_error();
  if (error > 0) return room / error;
  return room < 0 ? -infinity : infinity;
}

bool has_one_bound(const Interval& band) { return std::isinf(band.lo) != std::isinf(band.hi); }

}  // namespace

std::optional<ScaledCheck> scaled_to_band(const JudgedCheck& c) {
  const double half = c.check.band.width() / 2, centre = c.check.band.centre();
  if (!std::isfinite(half) || !(half > 0) || !std::isfinite(c.summary.mean)) return std::nullopt;
  return ScaledCheck{(c.summary.mean - centre) / half, (c.interval.lo - centre) / half,
                     (c.interval.hi - centre) / half};
}

std::optional<ScaledCheck> scaled_to_bound(const JudgedCheck& c) {
  const double error = c.summary.standard_error();
  if (c.check.exact || !has_one_bound(c.check.band) || !std::isfinite(c.summary.mean) || !(error > 0))
    return std::nullopt;
  const bool upper = std::isinf(c.check.band.lo);
  const double bound = upper ? c.check.band.hi : c.check.band.lo;
  const auto distance = [&](double x) { return (upper ? bound - x : x - bound) / error; };
  const double one = distance(c.interval.lo), other = distance(c.interval.hi);
  return ScaledCheck{distance(c.summary.mean), std::min(one, other), std::max(one, other)};
}

std::string margin_text(const JudgedCheck& c) {
  if (c.check.values.empty() || !std::isfinite(c.summary.mean)) return "-";
  if (!c.check.exact) {
    const double m = margin(c);
    return std::isfinite(m) ? fmt::format("{:.1f} se", m) : "-";
  }
  const auto scaled = scaled_to_band(c);
  if (!scaled) return "exact";
  return fmt::format("exact, {:.3g} % of band", 100 * std::max(std::abs(scaled->lo), std::abs(scaled->hi)));
}

std::string value_text(const JudgedCheck& c) {
  if (c.check.values.empty()) return "-";
  if (!c.check.exact) return rounded(c.summary.mean, c.interval.width() / 2);
  if (c.interval.lo == c.interval.hi) return fmt::format("{:.6g}", c.interval.lo);
  return fmt::format("{:.6g} ... {:.6g}", c.interval.lo, c.interval.hi);
}

std::string interval_text(const JudgedCheck& c) {
  if (c.check.exact) return "exact";
  const double half = c.interval.width() / 2;
  if (c.check.values.empty() || !std::isfinite(half)) return "-";
  return fmt::format("[{}, {}]", rounded(c.interval.lo, half), rounded(c.interval.hi, half));
}

std::vector<std::size_t> tightest(const std::vector<JudgedCheck>& checks, std::size_t count) {
  std::vector<std::size_t> order(checks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) {
    const Outcome outcome = checks[i].outcome;
    const double m = margin(checks[i]);
    return std::tuple(outcome == Outcome::fail           ? 0
                      : outcome == Outcome::inconclusive ? 1
                                                         : 2,
                      std::isnan(m) ? -infinity : m, i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  order.resize(std::min(count, order.size()));
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace gpf
