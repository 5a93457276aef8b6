#include "verify/verdict_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpf {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance from the mean to the nearest edge in half widths of the interval; negative outside of the band. For an
/// exact check the distance of its worst value, in half widths of the band where that is finite.
double room(const JudgedCheck& c) {
  const Interval band = c.check.band;
  if (c.check.exact) {
    const double scale = std::isfinite(band.width()) && band.width() > 0 ? band.width() / 2 : 1;
    return std::min(c.interval.lo - band.lo, band.hi - c.interval.hi) / scale;
  }
  const double half = c.interval.width() / 2, distance = std::min(c.summary.mean - band.lo, band.hi - c.summary.mean);
  if (half > 0) return distance / half;
  return distance < 0 ? -infinity : infinity;
}

std::string check_text(const JudgedCheck& c) {
  if (c.check.values.empty()) return fmt::format("{}: no values", c.check.label);
  if (c.check.exact) {
    const std::string range = c.interval.lo == c.interval.hi
                                  ? fmt::format("{:.6g}", c.interval.lo)
                                  : fmt::format("{:.6g} ... {:.6g}", c.interval.lo, c.interval.hi);
    return fmt::format("{}: {}, wanted {}", c.check.label, range, band_text(c.check.band));
  }
  if (!std::isfinite(c.summary.mean)) return fmt::format("{}: not measured in every replica", c.check.label);
  if (c.check.share)
    return fmt::format("{}: {:.0f} of {} replicas, share [{:.2f}, {:.2f}], wanted {}", c.check.label,
                       c.summary.mean * static_cast<double>(c.check.values.size()), c.check.values.size(),
                       c.interval.lo, c.interval.hi, band_text(c.check.band));
  if (!std::isfinite(c.interval.width()))
    return fmt::format("{}: {:.6g}, one replica gives no error", c.check.label, c.summary.mean);
  const double half = c.interval.width() / 2;
  return fmt::format("{}: {} +- {}, wanted {}", c.check.label, rounded(c.summary.mean, half), rounded(half, half),
                     band_text(c.check.band));
}

template <class Key>
const JudgedCheck* least(const std::vector<JudgedCheck>& checks, Outcome outcome, Key key) {
  const JudgedCheck* found = nullptr;
  for (const JudgedCheck& c : checks)
    if (c.outcome == outcome && (found == nullptr || key(c) < key(*found))) found = &c;
  return found;
}

}  // namespace

std::string band_text(const Interval& band) {
  if (std::isinf(band.lo) && std::isinf(band.hi)) return "any";
  if (std::isinf(band.lo)) return fmt::format("<= {:.6g}", band.hi);
  if (std::isinf(band.hi)) return fmt::format(">= {:.6g}", band.lo);
  return fmt::format("[{:.6g}, {:.6g}]", band.lo, band.hi);
}

std::string rounded(double value, double uncertainty) {
  if (!std::isfinite(value) || !(uncertainty > 0) || !std::isfinite(uncertainty)) return fmt::format("{:.6g}", value);
  const int digits = 1 - static_cast<int>(std::floor(std::log10(uncertainty)));
  const double size = std::max(std::abs(value), uncertainty);
  if (digits < 0 || digits > 15 || size < 1e-4) {
    const int significant = std::clamp(digits + static_cast<int>(std::floor(std::log10(size))), 1, 15);
    return fmt::format("{:.{}e}", value, significant);
  }
  return fmt::format("{:.{}f}", value, digits);
}

const JudgedCheck* deciding_check(const Verdict& verdict) {
  const auto& checks = verdict.checks;
  if (const JudgedCheck* failed = least(checks, Outcome::fail, room)) return failed;
  if (const JudgedCheck* open =
          least(checks, Outcome::inconclusive, [](const JudgedCheck& c) { return -c.replicas_needed; }))
    return open;
  return least(checks, Outcome::pass, room);
}

std::string summary_of(const Verdict& verdict) {
  const auto unhealthy =
      std::find_if(verdict.health.begin(), verdict.health.end(), [](const HealthCheck& h) { return !h.passed; });
  if (unhealthy != verdict.health.end())
    return fmt::format("health check failed - {}: {}", unhealthy->name, unhealthy->detail);
  const JudgedCheck* deciding = deciding_check(verdict);
  if (deciding == nullptr) return "the estimator found nothing to check";
  std::string text = check_text(*deciding);
  const auto alike = std::count_if(verdict.checks.begin(), verdict.checks.end(),
                                   [&](const JudgedCheck& c) { return c.outcome == deciding->outcome; });
  if (verdict.checks.size() > 1)
    text += fmt::format(" ({} of {} checks {})", alike, verdict.checks.size(),
                        deciding->outcome == Outcome::inconclusive ? "undecided" : name_of(deciding->outcome));
  if (deciding->outcome == Outcome::inconclusive && !deciding->check.exact && std::isfinite(deciding->interval.width()))
    text += std::isfinite(deciding->replicas_needed)
                ? fmt::format("; about {:.0f} replicas would decide", deciding->replicas_needed)
                : "; on the edge of its band, more replicas would not decide";
  return text;
}

std::string unused_tolerance(const std::vector<JudgedCheck>& checks) {
  double most_used = 0;
  bool any = false;
  for (const JudgedCheck& c : checks) {
    if (c.outcome != Outcome::pass) return {};
    const double half = c.check.band.width() / 2, centre = c.check.band.centre();
    if (!std::isfinite(half) || !(half > 0)) continue;
    any = true;
    most_used = std::max({most_used, std::abs(c.interval.lo - centre) / half, std::abs(c.interval.hi - centre) / half});
  }
  if (!any || most_used >= 0.1) return {};
  return fmt::format("Tolerance too wide: no check uses more than {:.2g} % of its band.", 100 * most_used);
}

}  // namespace gpf
